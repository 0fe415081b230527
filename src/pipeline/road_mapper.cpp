#include "road_mapper.hpp"

#include <cmath>
#include <utility>

#include "scan_placing.hpp"

namespace berm {
namespace {

bool is_solid(Label label) {
  return label == Label::drivable || label == Label::terrain || label == Label::obstacle;
}

/// The trusted poses of the run.
Trajectory path_of(const Trajectory& trajectory, const PoseGuard& guard, Stamp first_ns, Stamp last_ns) {
  Trajectory path;
  for (const StampedPose& pose : trajectory.poses()) {
    if (pose.stamp_ns >= first_ns && pose.stamp_ns <= last_ns && guard.at(pose.stamp_ns) == PoseTrust::trusted) {
      path.append(pose.stamp_ns, pose.T_world_base);
    }
  }
  return path;
}

}  // namespace

RoadMapper::RoadMapper(const Machine& machine, const RunPoses& poses, EdgeMap map, Stamp first_ns, Stamp last_ns)
    : trajectory_(poses.trajectory),
      guard_(poses.trajectory, machine.pose_guard, poses.poor_fix_stamps),
      map_(std::move(map)),
      survey_(machine.road, path_of(trajectory_, guard_, first_ns, last_ns), machine.pose_guard) {}

void RoadMapper::place(const Scan& scan, std::span<const Label> labels, const EdgeResult& found,
                       PlacedScan& placed) const {
  placed.stamp_ns = scan.stamp_ns;
  placed.left_out = 0;
  placed.edges.clear();
  placed.surveyed.clear();
  placed.plain_m.clear();
  placed.raised_m.clear();
  const PointsView points = scan.cloud.view();
  double first_s = 0.0;
  placed.trust = place_scan(scan, trajectory_, guard_, placed.motion, first_s);
  if (placed.trust != PoseTrust::trusted) {
    return;
  }
  const auto to_world_m = [&](float x_m, float y_m, float z_m, float time_s) {
    return placed.motion.to_world_m({double{x_m}, double{y_m}, double{z_m}}, double{time_s} - first_s);
  };
  for (const EdgePoint& edge : found.edges) {
    if (!std::isfinite(edge.time_s)) {
      ++placed.left_out;
      continue;
    }
    const Eigen::Vector3d position_m = to_world_m(edge.x_m, edge.y_m, edge.z_m, edge.time_s);
    placed.edges.push_back({position_m, edge.side});
    placed.surveyed.push_back({position_m, edge.height_m, edge.width_m, edge.kind});
  }
  const auto time_of_s = [&points](std::size_t i) { return points.time.empty() ? 0.0F : points.time[i]; };
  const auto point_to_world_m = [&](std::size_t i) {
    return to_world_m(points.x[i], points.y[i], points.z[i], time_of_s(i));
  };
  placed.is_plain.assign(points.size(), 0);
  for (const std::uint32_t i : found.plain) {
    placed.is_plain[i] = 1;
    if (!std::isfinite(time_of_s(i))) {
      ++placed.left_out;
      continue;
    }
    placed.plain_m.push_back(point_to_world_m(i));
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (placed.is_plain[i] == 0 && is_solid(labels[i]) && std::isfinite(time_of_s(i))) {
      placed.raised_m.push_back(point_to_world_m(i));
    }
  }
}

void RoadMapper::add(const PlacedScan& placed) {
  if (placed.trust != PoseTrust::trusted) {
    ++counts_.not_mapped[static_cast<std::size_t>(placed.trust)];
    return;
  }
  ++counts_.mapped;
  counts_.left_out += placed.left_out + map_.add_scan(placed.edges, placed.plain_m);
  survey_.add_scan(placed.stamp_ns, placed.surveyed, placed.plain_m, placed.raised_m);
}

}  // namespace berm
