#include "scan_motion.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace berm {
namespace {

constexpr Stamp kStep_ns = 1'000'000;
constexpr Stamp kLongest_ns = 10'000'000'000;

}  // namespace

bool ScanMotion::set(const Trajectory& T_world_base, const Pose& T_base_sensor, Stamp first_ns, Stamp last_ns) {
  T_world_sensor_.clear();
  const Stamp span_ns = last_ns - first_ns;
  if (span_ns < 0 || span_ns > kLongest_ns) {
    return false;
  }
  const Stamp steps = (span_ns + kStep_ns - 1) / kStep_ns;
  for (Stamp step = 0; step <= steps; ++step) {
    const Stamp offset_ns = steps == 0 ? 0 : span_ns * step / steps;
    const auto pose = T_world_base.at(first_ns + offset_ns);
    if (!pose) {
      return false;
    }
    T_world_sensor_.emplace_back((*pose * T_base_sensor).matrix().topRows<3>());
  }
  steps_per_s_ = span_ns == 0 ? 0.0 : static_cast<double>(steps) / to_seconds(span_ns);
  return true;
}

Eigen::Vector3d ScanMotion::to_world_m(const Eigen::Vector3d& point_m, double since_first_s) const {
  const auto last = static_cast<double>(T_world_sensor_.size() - 1);
  const double place = std::clamp(since_first_s * steps_per_s_, 0.0, last);
  const double before = std::floor(place);
  const auto knot = static_cast<std::size_t>(before);
  const std::size_t next = std::min(knot + 1, T_world_sensor_.size() - 1);
  const double share = place - before;
  const Eigen::Vector4d point(point_m.x(), point_m.y(), point_m.z(), 1.0);
  const Eigen::Vector3d from = T_world_sensor_[knot] * point;
  const Eigen::Vector3d to = T_world_sensor_[next] * point;
  return from + share * (to - from);
}

}  // namespace berm
