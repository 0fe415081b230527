#include "run_report.hpp"

#include <array>
#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "berm/core/version.hpp"
#include "edges_json.hpp"
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

/// Scans with each kind of degradation; kinds without any are left out.
Json describe(const std::array<std::size_t, kDegradations>& scans) {
  Json json = Json::object();
  for (std::size_t kind = 0; kind < kDegradations; ++kind) {
    if (scans[kind] > 0) {
      json[std::string(to_string(static_cast<Degradation>(kind)))] = scans[kind];
    }
  }
  return json;
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
            {"terrain", counts.terrain},
            {"obstacle", counts.obstacle},
            {"falling_snow", counts.falling_snow},
            {"no_return", counts.no_return},
            {"invalid", counts.invalid}}},
          {"degraded", describe(counts.degraded)}};
}

/// Degrees with two decimals.
double degrees(double angle_rad) {
  return std::round(angle_rad * 180.0 / std::numbers::pi * 100.0) / 100.0;
}

Json describe(const MountSummary& mount) {
  Json json = {{"verdict", to_string(mount.verdict)}, {"scans_that_tell", mount.scans}};
  if (mount.estimate) {
    json["ground_tilt_deg"] = degrees(mount.estimate->tilt_rad);
    json["pitch_off_deg"] = degrees(mount.estimate->pitch_rad);
    json["roll_off_deg"] = degrees(mount.estimate->roll_rad);
    json["height_m"] = std::round(mount.estimate->height_m * 1e3) / 1e3;
  }
  return json;
}

Json describe(const RunTimes& times) {
  Json json = {{"read", describe(times.read)}};
  for (std::size_t stage = 0; stage < kStages; ++stage) {
    if (times.stages[stage].count() > 0) {
      json[std::string(to_string(static_cast<Stage>(stage)))] = describe(times.stages[stage]);
    }
  }
  if (times.odometry.count() > 0) {
    json["odometry"] = describe(times.odometry);
  }
  if (times.localize.count() > 0) {
    json["localize"] = describe(times.localize);
  }
  if (times.map.count() > 0) {
    json["map"] = describe(times.map);
  }
  if (times.surface.count() > 0) {
    json["surface"] = describe(times.surface);
  }
  json["write"] = describe(times.write);
  return json;
}

Json describe(const OdometryCounts& counts) {
  Json health = Json::object();
  for (std::size_t kind = 0; kind < kOdometryHealths; ++kind) {
    health[std::string(health_name(static_cast<OdometryHealth>(kind)))] = counts.health[kind];
  }
  return {{"scans", counts.scans},
          {"health", health},
          {"sessions", counts.sessions},
          {"path_m", std::round(counts.path_m * 1e3) / 1e3}};
}

Json describe(const LocalizationCounts& counts) {
  Json health = Json::object();
  for (std::size_t kind = 0; kind < kOdometryHealths; ++kind) {
    health[std::string(health_name(static_cast<OdometryHealth>(kind)))] = counts.health[kind];
  }
  return {{"map", counts.map},
          {"scans", counts.scans},
          {"located", counts.located},
          {"health", health},
          {"first_s", counts.first_s ? Json(*counts.first_s) : Json(nullptr)},
          {"mean_ground_fit", std::round(counts.mean_ground_fit * 1e4) / 1e4},
          {"most_tiles", counts.most_tiles},
          {"broken_tiles", counts.broken_tiles}};
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
  return {"run",
          "run.json",
          std::string("\"schema\": \"") + kRunSchemaName,
          {"trajectory.tum",
           "odometry.csv",
           "trajectory_global.tum",
           "trajectory_global.csv",
           "trajectory_map.tum",
           "localization.csv",
           "scans.csv",
           "times.csv",
           "report.html",
           "boundary.csv",
           "edge_points.csv",
           "edges.ot",
           "edges.csv",
           "edges.geojson",
           "edges.gpkg",
           "edges.dxf",
           "road.csv",
           "map.pcd",
           "elevation.tif",
           "elevation.asc",
           "elevation_slope.asc",
           "elevation_sigma.asc",
           "elevation_count.asc",
           "elevation_depth.asc"},
          {{"labels", ".label"}, {"map", ".pcd", true}, {"map", ".json", true}}};
}

std::string write_run_report(const Recording& recording, const Machine& machine, const RunOptions& options,
                             const RunSummary& summary, const RunTimes& times, const RunFiles& files) {
  Json names = Json::object();
  for (const auto& [content, name] : files) {
    names[content] = name;
  }
  const bool whole = summary.counts.skipped == 0;
  Json report = {{"schema", std::string(kRunSchemaName) + "/" + std::to_string(kRunSchemaVersion)},
                 {"schema_version", kRunSchemaVersion},
                 {"program", "berm"},
                 {"version", version()},
                 {"state", whole ? "whole" : "lossy"},
                 {"recording", describe(recording, options)},
                 {"machine_file", options.machine_file.string()},
                 {"machine", to_json(machine)},
                 {"files", names},
                 {"counts", describe(summary.counts)}};
  if (summary.poses) {
    report["poses"] = to_json(*summary.poses);
  }
  if (summary.odometry) {
    report["odometry"] = describe(*summary.odometry);
  }
  if (summary.localization) {
    report["localization"] = describe(*summary.localization);
  }
  if (summary.edges) {
    report["edges"] = to_json(*summary.edges);
  }
  if (summary.surface) {
    report["surface"] = to_json(*summary.surface);
  }
  report["mount"] = describe(summary.mount);
  report["skipped"] = describe(summary.skipped);
  report["notes"] = summary.notes;
  report["threads"] = options.threads;
  report["stages"] = describe(times);
  report["wall_s"] = std::round(times.wall_s * 1e3) / 1e3;
  report["peak_memory_mib"] = peak_memory_mib();
  // Names of files may hold any bytes; what is no UTF-8 is replaced.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace berm
