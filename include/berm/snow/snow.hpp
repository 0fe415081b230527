#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"

namespace berm {

/// What a scan lacked, so that the snow stage worked with less.
struct SnowLimits {
  bool no_intensity = false;        ///< the channel is absent, or says the same of every point
  bool no_returns_dropped = false;  ///< not one beam without a return: the driver may have dropped them
  bool no_points = false;           ///< nothing but beams without a return, NaN and absurd points
};

struct SnowResult {
  std::span<const std::uint8_t> falling;  ///< one per point, 1 for a flake in the air; valid until the next `process`
  std::size_t count = 0;                  ///< of flakes
  SnowLimits limits;
};

/// Finds the flakes of falling snow, scan by scan; never the snow on the ground. Keeps scratch memory between calls
/// and nothing else.
class SnowFilter {
 public:
  SnowFilter() = default;
  SnowFilter(const SnowFilter&) = delete;
  SnowFilter& operator=(const SnowFilter&) = delete;
  virtual ~SnowFilter() = default;

  /// `points` in the frame of the sensor. Points that are no return, NaN or absurd are never flakes.
  [[nodiscard]] virtual SnowResult process(const PointsView& points, const Pose& T_base_sensor) = 0;
};

}  // namespace berm
