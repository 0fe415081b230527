#include "times_table.hpp"

#include <string_view>

#include <fmt/format.h>

#include "scan_table.hpp"

namespace berm {
namespace {

std::string field(const std::optional<StageTime>& time) {
  return time ? fmt::format(",{:.3f}", time->wall_ms) : std::string(",");
}

}  // namespace

TimesTable::TimesTable(const std::filesystem::path& path) : file_(path) {
  std::string header = "scan,stamp,read_ms";
  for (std::size_t stage = 0; stage < kStages; ++stage) {
    header += fmt::format(",{}_ms", to_string(static_cast<Stage>(stage)));
  }
  file_.write(header + ",odometry_ms,map_ms,write_ms\n");
}

void TimesTable::add(const std::string& name, Stamp stamp_ns, const ScanTimes& times) {
  std::string line = csv_field(name) + "," + stamp_field(stamp_ns) + field(times.read);
  for (const std::optional<StageTime>& stage : times.stages) {
    line += field(stage);
  }
  file_.write(line + field(times.odometry) + field(times.map) + field(times.write) + "\n");
}

}  // namespace berm
