#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "berm/core/edge.hpp"
#include "berm/geometry/voxel_hash.hpp"
#include "road_path.hpp"

namespace berm {

/// Stretches of line that were carried across a gap have 0.5; a place seen once, with 0.7, is clearly above.
constexpr double kLeastConfidence = 0.6;

/// Where the edges lie to the left and right of a place of the path.
struct RoadCrossings {
  std::optional<double> left_m;   ///< horizontally from the path
  std::optional<double> right_m;  ///< the same, positive too
};

/// Edge lines, to be met by who goes across the path.
class RoadEdgeIndex {
 public:
  explicit RoadEdgeIndex(std::span<const EdgeLine> lines);

  /// The nearest edges on the perpendicular of the path. A stretch of line that was not seen is none.
  [[nodiscard]] RoadCrossings find(const RoadPlace& place, double reach_m) const;

 private:
  struct Segment {
    Eigen::Vector3d from_m;
    Eigen::Vector3d to_m;
  };

  void add(const Segment& segment);

  std::vector<Segment> segments_;
  VoxelHash<std::vector<std::uint32_t>> cells_;
};

}  // namespace berm
