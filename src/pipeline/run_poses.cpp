#include "run_poses.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/io/pose_file.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

RunPoses from_given(GivenPoses given, const Machine& machine) {
  RunPoses poses{.file = given.file, .datum = machine.datum.given()};
  poses.world = world_name(poses.datum);
  if (given.of == PoseOf::base) {
    poses.trajectory = std::move(given.trajectory);
    return poses;
  }
  const Pose T_sensor_base = machine.mount.T_base_sensor().inverse();
  poses.trajectory.reserve(given.trajectory.size());
  for (const StampedPose& pose : given.trajectory.poses()) {
    poses.trajectory.append(pose.stamp_ns, pose.T_world_base * T_sensor_base);
  }
  return poses;
}

/// A world that starts at the first fix is that of the map which is continued, if it has one.
PoseLog read_log(const fs::path& file, const Machine& machine, const std::optional<Geodetic>& old_datum,
                 std::vector<std::string>& notes) {
  PoseLog log = read_pose_log(file, machine.poses, machine.gnss, machine.datum);
  if (machine.datum.origin != "first_fix" || !log.datum || !old_datum) {
    return log;
  }
  DatumConfig datum{.origin = "given"};
  datum.lat_deg = old_datum->lat_deg;
  datum.lon_deg = old_datum->lon_deg;
  datum.h_m = old_datum->h_m;
  notes.emplace_back("the world starts at the datum of the map that is continued, not at the first fix");
  return read_pose_log(file, machine.poses, machine.gnss, datum);
}

/// Nothing is said of a log without losses.
std::optional<std::string> describe_losses(const PoseLogCounts& counts, const std::string& name) {
  std::string losses;
  const auto add = [&losses](std::size_t count, const char* what) {
    if (count > 0) {
      losses += fmt::format("{}{} {}", losses.empty() ? "" : ", ", count, what);
    }
  };
  add(counts.bad_checksum, "with a bad checksum");
  add(counts.malformed, "malformed");
  add(counts.no_fix, "without a position");
  add(counts.poor_fix, "poorer than poses.fix");
  add(counts.no_attitude, "without an attitude");
  add(counts.not_rising, "not later than one before");
  if (losses.empty()) {
    return std::nullopt;
  }
  return fmt::format("{}: of {} records some were left out: {}", name, counts.records, losses);
}

RunPoses from_log(const fs::path& file, const Machine& machine, const std::optional<Geodetic>& old_datum) {
  RunPoses poses{.file = file};
  PoseLog log = read_log(file, machine, old_datum, poses.notes);
  poses.trajectory = std::move(log.trajectory);
  poses.world = world_name(log.datum);
  if (machine.datum.origin == "none") {
    // The places of the log are metres around its first fix all the same: a world of its own, not that of other days.
    poses.world = log.datum ? "unplaced, begins at " + poses.world : poses.world;
  } else {
    poses.datum = log.datum;
  }
  poses.log = log.counts;
  poses.poor_fix_stamps = std::move(log.poor_fix_stamps);
  const std::string name = file.filename().string();
  for (const std::string& note : log.notes) {
    poses.notes.push_back(fmt::format("{}: {}", name, note));
  }
  if (const auto losses = describe_losses(log.counts, name)) {
    poses.notes.push_back(*losses);
  }
  return poses;
}

std::optional<RunPoses> read_any(const Recording& recording, const Machine& machine, const PoseSource& source) {
  if (!source.file.empty()) {
    switch (recognise_pose_file(source.file)) {
      case PoseFileKind::tum:
        return from_given(Recording::read_tum_poses(source.file), machine);
      case PoseFileKind::kitti:
        return from_given(recording.read_camera_poses(source.file), machine);
      case PoseFileKind::log:
        return from_log(source.file, machine, source.old_datum);
    }
  }
  if (recording.pose_log()) {
    return from_log(*recording.pose_log(), machine, source.old_datum);
  }
  auto given = recording.read_given_poses();
  return given ? std::optional(from_given(std::move(*given), machine)) : std::nullopt;
}

/// Coordinates of a projection are no metres around a datum.
void check_reach(const RunPoses& poses) {
  // Half of what the local frame bears, so that the edges around the poses are within it, too.
  constexpr double kReach_m = 0.5 * LocalFrame::kMaxDistance_m;
  if (!poses.datum || poses.trajectory.empty()) {
    return;
  }
  const auto& all = poses.trajectory.poses();
  const auto far = std::count_if(all.begin(), all.end(), [](const StampedPose& pose) {
    return pose.T_world_base.translation_m().norm() > kReach_m;
  });
  if (2 * static_cast<std::size_t>(far) > all.size()) {
    throw FileError(ErrorCode::invalid_argument, poses.file.string(), std::nullopt,
                    fmt::format("the poses lie {:.0f} km from the datum: these are coordinates of a projection, which "
                                "berm cannot place on the earth; set datum.origin to none",
                                all.front().T_world_base.translation_m().norm() * 1e-3));
  }
}

}  // namespace

std::optional<RunPoses> read_run_poses(const Recording& recording, const Machine& machine, const PoseSource& source) {
  std::optional<RunPoses> poses = read_any(recording, machine, source);
  if (!poses) {
    return std::nullopt;
  }
  check_reach(*poses);
  const auto problem = find_time_base_problem(poses->trajectory, recording.scan(0).stamp_ns,
                                              recording.scan(recording.size() - 1).stamp_ns);
  if (!problem) {
    return poses;
  }
  if (!source.file.empty()) {
    throw FileError(ErrorCode::malformed, source.file.string(), std::nullopt, *problem);
  }
  poses->notes.push_back(poses->file.filename().string() + " is not used: " + *problem);
  poses->trajectory = Trajectory();
  return poses;
}

}  // namespace berm
