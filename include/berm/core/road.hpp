#pragma once

#include <cstdint>
#include <optional>

#include <Eigen/Core>

namespace berm {

/// A measured value and one standard deviation of it, in the same unit.
struct Measure {
  double value = 0.0;
  double sigma = 0.0;
};

/// What a rule of the mine says of a place, given how sure the measurement is.
enum class RuleVerdict : std::uint8_t {
  unknown,    ///< nothing was measured, or the machine file does not say what is asked
  holds,      ///< by two standard deviations
  uncertain,  ///< within two standard deviations of the limit
  broken,     ///< by two standard deviations
};

/// One side of the road at a station.
struct RoadSide {
  std::optional<Measure> edge_m;         ///< horizontally from the path to the edge
  std::optional<Measure> berm_height_m;  ///< above the road at its toe; 0 where the road ends in a drop
  std::optional<Measure> berm_width_m;   ///< from toe to toe, or as far as was seen
  RuleVerdict berm_rule = RuleVerdict::unknown;
};

/// What a road is like at one place of the path that was driven. Left and right are those of who drives it this way.
struct RoadStation {
  std::uint32_t piece = 0;                               ///< stretch of path without a jump or a change of direction
  double chainage_m = 0.0;                               ///< along all that was driven, horizontally; never falls
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< on the path, world frame
  double heading_rad = 0.0;                              ///< from x of the world to the left
  RoadSide left;
  RoadSide right;
  std::optional<Measure> width_m;     ///< from edge to edge, across the path
  std::optional<Measure> grade;       ///< rise over run, uphill positive
  std::optional<Measure> cross_fall;  ///< rise over run across, falling to the right positive
  RuleVerdict width_rule = RuleVerdict::unknown;
  RuleVerdict grade_rule = RuleVerdict::unknown;
};

}  // namespace berm
