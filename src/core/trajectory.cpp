#include "berm/core/trajectory.hpp"

#include <algorithm>
#include <cstdint>
#include <string>

#include "berm/core/error.hpp"

namespace berm {
namespace {

/// Unsigned, because stamps at both ends of their range are farther apart than a stamp can tell.
double span_ns(Stamp from_ns, Stamp to_ns) {
  return static_cast<double>(static_cast<std::uint64_t>(to_ns) - static_cast<std::uint64_t>(from_ns));
}

}  // namespace

void Trajectory::append(Stamp stamp_ns, const Pose& T_world_base) {
  if (!poses_.empty() && stamp_ns <= poses_.back().stamp_ns) {
    throw Error(ErrorCode::invalid_argument, "trajectory: stamp " + std::to_string(stamp_ns) +
                                                 " ns does not come after " + std::to_string(poses_.back().stamp_ns) +
                                                 " ns");
  }
  poses_.push_back({stamp_ns, T_world_base});
}

std::optional<Pose> Trajectory::at(Stamp stamp_ns) const {
  const auto after = std::lower_bound(poses_.begin(), poses_.end(), stamp_ns,
                                      [](const StampedPose& pose, Stamp stamp) { return pose.stamp_ns < stamp; });
  if (after == poses_.end()) {
    return std::nullopt;
  }
  if (after->stamp_ns == stamp_ns) {
    return after->T_world_base;
  }
  if (after == poses_.begin()) {
    return std::nullopt;
  }
  const StampedPose& before = *(after - 1);
  const double share = span_ns(before.stamp_ns, stamp_ns) / span_ns(before.stamp_ns, after->stamp_ns);
  return interpolate(before.T_world_base, after->T_world_base, share);
}

}  // namespace berm
