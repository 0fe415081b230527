#pragma once

#include <cstdint>
#include <vector>

#include "berm/sim/world_config.hpp"
#include "buckets.hpp"
#include "run.hpp"

namespace berm::sim {

/// A round patch of a road: a pothole, or a puddle that levels the ground to its water.
struct RoadPatch {
  double x_m = 0.0;
  double y_m = 0.0;
  double reach_m = 0.0;
  double depth_m = 0.0;        ///< of a pothole
  double water_level_m = 0.0;  ///< of a puddle
  bool is_puddle = false;
};

/// What wheels and weather do to a road.
class RoadDetails {
 public:
  RoadDetails() = default;
  RoadDetails(const HaulRoadConfig& config, const Run& road, std::uint64_t seed);

  /// Changes the height of the road at a place, by the share `fade`; true where there is water.
  bool apply(const RunPlace& at, double x_m, double y_m, double fade, double& height_m) const;
  [[nodiscard]] const std::vector<RoadPatch>& patches() const { return patches_.items(); }

 private:
  Buckets<RoadPatch> patches_;
  Profile rut_depth_m_;
  Profile lane_m_;  ///< where the trucks drive, left of the middle; the way back mirrors it
};

}  // namespace berm::sim
