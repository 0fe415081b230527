#include "road_mapper.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berm {
namespace {

/// Earliest and latest time of a scan's points since its stamp; both 0 where they have none.
struct TimeSpan {
  double first_s = 0.0;
  double last_s = 0.0;
};

TimeSpan span_of(std::span<const float> times_s) {
  std::optional<TimeSpan> span;
  for (const float time_s : times_s) {
    if (std::isfinite(time_s)) {
      const auto t = double{time_s};
      span = span ? TimeSpan{std::min(span->first_s, t), std::max(span->last_s, t)} : TimeSpan{t, t};
    }
  }
  return span.value_or(TimeSpan{});
}

/// Scans that end later, or at the end of time, have no pose.
std::optional<Stamp> stamp_at(Stamp stamp_ns, double time_s) {
  constexpr double kLongest_s = 1e6;
  Stamp result = 0;
  if (std::abs(time_s) > kLongest_s || __builtin_add_overflow(stamp_ns, from_seconds(time_s), &result)) {
    return std::nullopt;
  }
  return result;
}

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
  const TimeSpan span = span_of(points.time);
  const auto first_ns = stamp_at(scan.stamp_ns, span.first_s);
  const auto last_ns = stamp_at(scan.stamp_ns, span.last_s);
  placed.trust = first_ns && last_ns ? guard_.over(*first_ns, *last_ns) : PoseTrust::no_pose;
  if (placed.trust != PoseTrust::trusted) {
    return;
  }
  if (!placed.motion.set(trajectory_, scan.T_base_sensor, *first_ns, *last_ns)) {
    placed.trust = PoseTrust::no_pose;
    return;
  }
  const auto to_world_m = [&](float x_m, float y_m, float z_m, float time_s) {
    return placed.motion.to_world_m({double{x_m}, double{y_m}, double{z_m}}, double{time_s} - span.first_s);
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
