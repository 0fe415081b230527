#include "run_edges.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <system_error>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/io/file_reader.hpp"
#include "berm/map/edge_lines.hpp"
#include "road_files.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_map(const fs::path& file, const std::string& problem) {
  throw FileError(ErrorCode::unsupported, file.string(), std::nullopt, problem);
}

std::optional<EdgeMap> read_old_map(const RunOptions& options, const Machine& machine) {
  if (options.map.empty()) {
    return std::nullopt;
  }
  std::error_code code;
  if (fs::equivalent(options.map, options.output / "edges.ot", code)) {
    refuse_map(options.map, "is a result in the output folder, which is about to be replaced; choose another folder");
  }
  FileBuffer buffer;
  read_file(options.map, buffer);
  EdgeMap map = EdgeMap::from_octomap(buffer.text(), options.map.string(), machine.map);
  if (map.config().voxel_m != machine.map.voxel_m) {
    refuse_map(options.map,
               fmt::format("has voxels of {} m, this run has {} m; set map.voxel_m={}, or leave the map away",
                           map.config().voxel_m, machine.map.voxel_m, map.config().voxel_m));
  }
  return map;
}

/// OctoMap counts 65536 voxels from end to end; edges lie up to 200 m beside the path. To be known before the work
/// rather than after it.
void check_width(const EdgeMap& map, const RunPoses& poses, const PoseGuard& guard, Stamp first_ns, Stamp last_ns) {
  constexpr double kVoxels = 65000.0;
  constexpr double kBeside_m = 200.0;
  Eigen::AlignedBox3d extent;
  map.for_each([&](const VoxelKey& key, const EdgeVoxel&) {
    extent.extend(Eigen::Vector3d(map.config().voxel_m * Eigen::Vector3d(key.x, key.y, key.z)));
  });
  for (const StampedPose& pose : poses.trajectory.poses()) {
    if (pose.stamp_ns >= first_ns && pose.stamp_ns <= last_ns && guard.at(pose.stamp_ns) == PoseTrust::trusted) {
      extent.extend(pose.T_world_base.translation_m());
    }
  }
  const double widest_m = (extent.isEmpty() ? 0.0 : extent.sizes().maxCoeff()) + 2.0 * kBeside_m;
  const double allowed_m = kVoxels * map.config().voxel_m;
  if (widest_m > allowed_m) {
    throw Error(ErrorCode::invalid_argument,
                fmt::format("the map would be {:.1f} km wide, with voxels of {} m it can be {:.1f} km: set a larger "
                            "map.voxel_m, or run parts of the recording with --first and --count",
                            widest_m * 1e-3, map.config().voxel_m, allowed_m * 1e-3));
  }
}

std::string described(const std::string& world) {
  return world.empty() ? "a world without a datum" : "the world '" + world + "'";
}

double length_m(const EdgeLine& line) {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < line.vertices.size(); ++i) {
    sum_m += (line.vertices[i].position_m - line.vertices[i - 1].position_m).norm();
  }
  return sum_m;
}

RoadCounts count_rules(const std::vector<RoadStation>& stations) {
  RoadCounts counts{.stations = stations.size()};
  const auto count = [](std::array<std::size_t, kRuleVerdicts>& of, RuleVerdict verdict) {
    ++of[static_cast<std::size_t>(verdict)];
  };
  for (const RoadStation& station : stations) {
    count(counts.width, station.width_rule);
    count(counts.grade, station.grade_rule);
    count(counts.left_berm, station.left.berm_rule);
    count(counts.right_berm, station.right.berm_rule);
  }
  return counts;
}

/// "gap: 10, no pose: 2"; empty without any.
std::string describe_reasons(const std::array<std::size_t, kPoseTrusts>& scans) {
  std::string text;
  for (std::size_t reason = 0; reason < kPoseTrusts; ++reason) {
    if (scans[reason] > 0) {
      text +=
          fmt::format("{}{}: {}", text.empty() ? "" : ", ", trust_name(static_cast<PoseTrust>(reason)), scans[reason]);
    }
  }
  return text;
}

}  // namespace

RunEdges::RunEdges(const Recording& recording, const Machine& machine, const RunOptions& options, std::size_t selected)
    : machine_(machine), options_(options) {
  const bool finds_edges = machine.methods.edge != "none";
  if (!options.map.empty() && !finds_edges) {
    throw Error(ErrorCode::invalid_argument,
                "a map can only be continued with an edge method: --method edge=default, or leave --map away");
  }
  std::optional<EdgeMap> old = read_old_map(options, machine);
  poses_ = read_run_poses(recording, machine,
                          {.file = options.poses, .old_datum = old ? datum_of(old->world()) : std::nullopt});
  if (poses_) {
    notes_ = poses_->notes;
  }
  if (!finds_edges) {
    return;
  }
  if (poses_ && !poses_->trajectory.empty()) {
    start_map(recording, std::move(old), selected);
    return;
  }
  if (old) {
    throw Error(ErrorCode::invalid_argument,
                "a map cannot be continued without poses that share the time of the scans; name a file with --poses");
  }
  if (!poses_ && machine.methods.odometry != "none") {
    return;  // its poses follow
  }
  notes_.emplace_back(
      "no map of the road edges was written, since there are no poses: put gnss.tum, gnss.csv or gnss.nmea beside the "
      "scans, or name a file with --poses");
}

void RunEdges::use_odometry(const Recording& recording, const Trajectory& T_world_base, std::size_t selected) {
  poses_ = RunPoses{.trajectory = T_world_base};
  if (machine_.methods.edge != "none") {
    start_map(recording, std::nullopt, selected);
  }
}

void RunEdges::start_map(const Recording& recording, std::optional<EdgeMap> old, std::size_t selected) {
  const std::string& world = poses_->world;
  if (old && old->world() != world) {
    refuse_map(options_.map, fmt::format("holds {}, this run is in {}; they cannot be put together. Where the world "
                                         "begins is said by the section datum of the machine",
                                         described(old->world()), described(world)));
  }
  EdgeMap map = old ? std::move(*old) : EdgeMap(machine_.map, world);
  const Stamp first_ns = recording.scan(options_.first).stamp_ns;
  const Stamp last_ns = recording.scan(options_.first + selected - 1).stamp_ns;
  mapper_.emplace(machine_, *poses_, std::move(map), first_ns, last_ns);
  check_width(mapper_->map(), *poses_, mapper_->guard(), first_ns, last_ns);
}

void RunEdges::finish(const OutputFolder& output, RunFiles& files, RunSummary& summary) const {
  summary.notes.insert(summary.notes.end(), notes_.begin(), notes_.end());
  if (poses_ && !poses_->file.empty()) {
    summary.poses = PoseFigures{
        .file = poses_->file.string(), .poses = poses_->trajectory.size(), .datum = poses_->datum, .log = poses_->log};
    const PoseGuard guard =
        mapper_ ? mapper_->guard() : PoseGuard(poses_->trajectory, machine_.pose_guard, poses_->poor_fix_stamps);
    summary.poses->jumps = guard.jumps();
    for (std::size_t reason = 0; reason < kPoseTrusts; ++reason) {
      summary.poses->distrusted_s[reason] = guard.seconds(static_cast<PoseTrust>(reason));
    }
  }
  if (mapper_) {
    write_map(output, files, summary);
  }
}

void RunEdges::write_map(const OutputFolder& output, RunFiles& files, RunSummary& summary) const {
  const std::uint64_t points = summary.edges->points;
  EdgeCounts& counts = summary.edges.emplace(mapper_->counts());
  counts.points = points;
  const EdgeMap& map = mapper_->map();
  counts.has_map = true;
  counts.world = map.world();
  counts.voxels = map.size();
  const std::string reasons = describe_reasons(counts.not_mapped);
  if (counts.mapped == 0 && options_.map.empty()) {
    summary.notes.push_back("no map of the road edges was written, since the poses of no scan are trusted (" + reasons +
                            ")");
    return;
  }
  if (!reasons.empty()) {
    std::size_t scans = 0;
    for (const std::size_t some : counts.not_mapped) {
      scans += some;
    }
    summary.notes.push_back(
        fmt::format("{} scans are not in the map, since their poses are not trusted ({})", scans, reasons));
  }
  std::vector<EdgeLine> lines = extract_lines(map, machine_.lines);
  for (const EdgeLine& line : lines) {
    ++counts.lines[static_cast<std::size_t>(line.side)];
    counts.lines_m[static_cast<std::size_t>(line.side)] += length_m(line);
  }
  const std::vector<RoadStation> stations = mapper_->stations(lines);
  counts.road = count_rules(stations);
  set_berm_heights(stations, lines);
  write_road_files(output, map, lines, stations, poses_->datum, files, summary.notes);
}

}  // namespace berm
