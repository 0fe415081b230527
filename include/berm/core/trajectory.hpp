#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "berm/core/pose.hpp"
#include "berm/core/stamp.hpp"

namespace berm {

struct StampedPose {
  Stamp stamp_ns = 0;
  Pose T_world_base;
};

/// Poses over time; stamps strictly increase.
class Trajectory {
 public:
  /// Makes room for `count` poses, so that appending them needs no second copy.
  void reserve(std::size_t count) { poses_.reserve(count); }

  /// Throws Error(invalid_argument) unless `stamp_ns` is later than every stamp so far.
  void append(Stamp stamp_ns, const Pose& T_world_base);

  /// The pose at `stamp_ns`, on the screw motion between its neighbours; none before the first and after the last.
  [[nodiscard]] std::optional<Pose> at(Stamp stamp_ns) const;

  [[nodiscard]] std::size_t size() const { return poses_.size(); }
  [[nodiscard]] bool empty() const { return poses_.empty(); }
  [[nodiscard]] const std::vector<StampedPose>& poses() const { return poses_; }

 private:
  std::vector<StampedPose> poses_;
};

}  // namespace berm
