#pragma once

#include <cstdint>
#include <span>

#include "berm/core/edge.hpp"
#include "berm/core/label.hpp"
#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/geometry/height_grid.hpp"

namespace berm {

/// A place on the edge of the road, seen by one scan.
struct EdgePoint {
  float x_m = 0.0F;  ///< frame of the sensor, at the time of the point; the toe, not the nearest return
  float y_m = 0.0F;
  float z_m = 0.0F;
  float time_s = 0.0F;  ///< since the scan's stamp; 0 where the scan has no times
  EdgeSide side = EdgeSide::left;
  EdgeKind kind = EdgeKind::rise;
  float confidence = 0.0F;  ///< 0..1
  float height_m = 0.0F;    ///< of what rises, above the road at the toe; 0: not seen to its top
  float width_m =
      0.0F;  ///< from the toe to where it is back on the level of the road, or as far as is seen; 0: unknown
};

/// What earlier stages know of a scan.
struct EdgeInput {
  PointsView points;              ///< frame of the sensor
  std::span<const Label> labels;  ///< one per point: no_return, falling_snow, unlabeled, drivable (ground), obstacle
  const HeightGrid* surface = nullptr;  ///< the ground
  Pose T_base_sensor;
};

/// Spans are valid until the next call of `process`.
struct EdgeResult {
  std::span<const EdgePoint> edges;
  /// Indices of the points that were seen to be plain road: there is no edge there.
  std::span<const std::uint32_t> plain;
};

/// Finds the edges of the road, scan by scan. Keeps scratch memory between calls and nothing else.
class EdgeDetector {
 public:
  EdgeDetector() = default;
  EdgeDetector(const EdgeDetector&) = delete;
  EdgeDetector& operator=(const EdgeDetector&) = delete;
  virtual ~EdgeDetector() = default;

  [[nodiscard]] virtual EdgeResult process(const EdgeInput& input) = 0;
};

}  // namespace berm
