#include "run_report.hpp"

#include <cmath>

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "berm/core/version.hpp"
#include "machine_json.hpp"

namespace berm {
namespace {

using Json = nlohmann::ordered_json;

/// Nanoseconds are beyond what the clock can tell.
double round_ms(double value_ms) {
  return std::round(value_ms * 1e4) / 1e4;
}

Json describe(const StageTimes& times) {
  const StageSummary summary = times.summarize();
  return {{"cpu_mean_ms", round_ms(summary.cpu_mean_ms)}, {"mean_ms", round_ms(summary.mean_ms)},
          {"p50_ms", round_ms(summary.p50_ms)},           {"p95_ms", round_ms(summary.p95_ms)},
          {"p99_ms", round_ms(summary.p99_ms)},           {"max_ms", round_ms(summary.max_ms)}};
}

Json describe(const RunCounts& counts) {
  return {{"scans",
           {{"selected", counts.selected},
            {"labelled", counts.labelled},
            {"skipped", counts.skipped},
            {"without_pose", counts.without_pose}}},
          {"points",
           {{"total", counts.points},
            {"drivable", counts.drivable},
            {"obstacle", counts.obstacle},
            {"no_return", counts.no_return},
            {"invalid", counts.invalid}}}};
}

Json describe(const Recording& recording, const RunOptions& options) {
  return {{"path", recording.path().string()},
          {"layout", to_string(recording.layout())},
          {"stamps", to_string(recording.stamp_source())},
          {"scans", recording.size()},
          {"first", options.first}};
}

Json describe(const std::vector<SkippedScan>& skipped) {
  Json list = Json::array();
  for (const SkippedScan& scan : skipped) {
    list.push_back({{"scan", scan.name}, {"reason", scan.reason}});
  }
  return list;
}

double peak_memory_mib() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return std::round(static_cast<double>(usage.ru_maxrss) / 1024.0 * 10.0) / 10.0;  // the system counts in KiB
}

}  // namespace

OutputResults run_results() {
  return {
      "run", "run.json", std::string("\"schema\": \"") + kRunSchemaName, {"trajectory.tum"}, {{"labels", ".label"}}};
}

std::string write_run_report(const Recording& recording, const Machine& machine, const RunOptions& options,
                             const RunSummary& summary, const RunTimes& times, bool has_trajectory) {
  Json files = {{"labels", "labels"}};
  if (has_trajectory) {
    files["trajectory"] = "trajectory.tum";
  }
  const bool whole = summary.counts.skipped == 0;
  const Json report = {
      {"schema", std::string(kRunSchemaName) + "/" + std::to_string(kRunSchemaVersion)},
      {"schema_version", kRunSchemaVersion},
      {"program", "berm"},
      {"version", version()},
      {"state", whole ? "whole" : "lossy"},
      {"recording", describe(recording, options)},
      {"machine_file", options.machine_file.string()},
      {"machine", to_json(machine)},
      {"files", files},
      {"counts", describe(summary.counts)},
      {"skipped", describe(summary.skipped)},
      {"notes", summary.notes},
      {"threads", options.threads},
      {"stages",
       {{"read", describe(times.read)}, {"ground", describe(times.ground)}, {"write", describe(times.write)}}},
      {"wall_s", std::round(times.wall_s * 1e3) / 1e3},
      {"peak_memory_mib", peak_memory_mib()}};
  // Names of files may hold any bytes; what is no UTF-8 is replaced.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace berm
