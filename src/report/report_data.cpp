#include <functional>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "berm/core/version.hpp"
#include "berm/io/csv_table.hpp"
#include "berm/io/edge_lines_file.hpp"
#include "berm/io/file_reader.hpp"
#include "berm/io/height_raster.hpp"
#include "berm/io/trajectory_file.hpp"
#include "berm/report/report.hpp"
#include "map_parts.hpp"
#include "table_parts.hpp"
#include "terrain_part.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int kReportSchemaVersion = 1;

/// Writing nested values takes stack for each level; run.json has 4.
constexpr int kMaxDepth = 16;
constexpr std::uint64_t kMaxRunFileBytes = std::uint64_t{64} << 20U;

/// JSON that is not nested deeper than ours; discarded (`is_discarded`) for anything else.
Json parse_json(std::string_view text) {
  bool too_deep = false;
  const auto check = [&too_deep](int depth, Json::parse_event_t /*event*/, Json& /*value*/) {
    too_deep = too_deep || depth > kMaxDepth;
    return depth <= kMaxDepth;
  };
  Json json = Json::parse(text, check, false);
  return too_deep ? Json(Json::value_t::discarded) : json;
}

Json read_run_file(const fs::path& file) {
  FileBuffer buffer;
  read_file(file, buffer, kMaxRunFileBytes);
  Json run = parse_json(buffer.text());
  const auto refuse = [&file](const char* problem) {
    throw FileError(ErrorCode::malformed, file.string(), std::nullopt, problem);
  };
  if (!run.is_object()) {
    refuse("is no JSON object; a report can be made of the output folder of berm run only");
  }
  const auto schema = run.find("schema");
  if (schema == run.end() || !schema->is_string() || !schema->get_ref<const std::string&>().starts_with("berm.run/")) {
    refuse("was not written by berm run");
  }
  return run;
}

/// The files of one run as parts of the report.
class Collector {
 public:
  explicit Collector(const fs::path& folder) : folder_(folder) {}

  Json collect(std::string_view evaluation) {
    json_ = {{"schema", "berm.report/" + std::to_string(kReportSchemaVersion)},
             {"version", version()},
             {"run", read_run_file(folder_ / "run.json")}};
    if (Json parsed = parse_json(evaluation); parsed.is_object()) {
      json_["evaluation"] = std::move(parsed);
    }
    add("scans", "scans.csv", scans_part);
    add("times", "times.csv", times_part);
    add("odometry", "odometry.csv", odometry_part);
    add("road", "road.csv", road_part);
    add_trajectory("trajectory", "trajectory.tum");
    add_trajectory("global_trajectory", "trajectory_global.tum");
    add("edges", "edges.csv", [this](const fs::path& file) {
      const std::vector<EdgeLine> lines = read_edge_lines(file);
      if (!origin_m_ && !lines.empty()) {
        origin_m_ = lines.front().vertices.front().position_m;
      }
      return edges_part(lines, origin_m_.value_or(Eigen::Vector3d::Zero()));
    });
    add_terrain();
    if (origin_m_) {
      json_["origin_m"] = {origin_m_->x(), origin_m_->y(), origin_m_->z()};
    }
    json_["trouble"] = trouble_;
    return std::move(json_);
  }

 private:
  void add(const char* key, const char* name, const std::function<Json(const fs::path&)>& read) {
    const fs::path file = folder_ / name;
    std::error_code code;
    if (!fs::exists(file, code)) {
      return;
    }
    try {
      Json part = read(file);
      if (!part.empty()) {
        json_[key] = std::move(part);
      }
    } catch (const FileError& error) {
      trouble_.emplace_back(error.what());
    }
  }

  void add_trajectory(const char* key, const char* name) {
    add(key, name, [this](const fs::path& file) {
      const Trajectory trajectory = read_tum(file);
      if (trajectory.empty()) {
        return Json();
      }
      const StampedPose& first = trajectory.poses().front();
      if (!origin_m_) {
        origin_m_ = first.T_world_base.translation_m();
      }
      return trajectory_part(trajectory, start_ns(first.stamp_ns), *origin_m_);
    });
  }

  /// A GeoTIFF, or a grid where the program that wrote it had no GDAL.
  void add_terrain() {
    const auto read = [this](const fs::path& file) {
      const HeightRaster raster = read_height_raster(file);
      return terrain_part(raster, origin_m_.value_or(Eigen::Vector3d::Zero()));
    };
    for (const char* name : {"elevation.tif", "elevation.asc"}) {
      if (!json_.contains("terrain")) {
        add("terrain", name, read);
      }
    }
  }

  /// Stamp of the first scan, from which all times count.
  Stamp start_ns(Stamp otherwise) const {
    std::error_code code;
    if (!fs::exists(folder_ / "scans.csv", code)) {
      return otherwise;
    }
    CsvTable table(folder_ / "scans.csv");
    const auto stamp = table.column("stamp");
    return stamp && table.next() ? from_seconds(table.number(*stamp)) : otherwise;
  }

  const fs::path& folder_;
  Json json_;
  std::vector<std::string> trouble_;
  std::optional<Eigen::Vector3d> origin_m_;
};

}  // namespace

std::filesystem::path recording_of(const std::filesystem::path& run_folder) {
  const Json run = read_run_file(run_folder / "run.json");
  const auto recording = run.find("recording");
  if (recording == run.end() || !recording->is_object() || !recording->contains("path") ||
      !recording->at("path").is_string()) {
    return {};
  }
  return recording->at("path").get<std::string>();
}

std::string report_data(const std::filesystem::path& run_folder, std::string_view evaluation) {
  // Names of files may hold any bytes; what is no UTF-8 is replaced.
  return Collector(run_folder).collect(evaluation).dump(-1, ' ', true, Json::error_handler_t::replace);
}

}  // namespace berm
