#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "berm/core/label.hpp"
#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/edge/edge.hpp"

namespace berm::test {

/// Height of the ground at a place, in base_link; NaN: water, which gives nothing back.
using RoadHeights = std::function<double(double x, double y)>;

/// A straight road along x, `half_width_m` to either side, with berms of `height_m` whose flanks rise by `slope` and
/// fall again; level ground beyond.
[[nodiscard]] RoadHeights road_between_berms(double half_width_m, double height_m, double slope = 0.7);
/// The same profile across a road that bends to the left around (0, radius_m).
[[nodiscard]] RoadHeights bend_between_berms(double radius_m, double half_width_m, double height_m);

/// A scan of a sensor with 16 rings at (0, 0, 4), firing column by column, with the labels of a perfect ground stage:
/// what rises by more than `tall_m` is an obstacle.
struct RoadScan {
  PointChannels channels;
  std::vector<Label> labels;
  Pose T_base_sensor;

  [[nodiscard]] PointsView points() const;
  [[nodiscard]] EdgeInput input() const;
};
[[nodiscard]] RoadScan scan_road(const RoadHeights& heights, double noise_m = 0.01);

}  // namespace berm::test
