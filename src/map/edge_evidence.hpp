#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "berm/geometry/voxel_hash.hpp"
#include "berm/map/edge_map.hpp"

namespace berm {

/// A voxel in which an edge was seen at least once.
struct EdgeSample {
  Eigen::Vector3d position_m;  ///< middle of the voxel
  float left = 0.0F;           ///< scans that saw a left edge here
  float right = 0.0F;

  [[nodiscard]] float hits() const { return left + right; }
};

/// All samples of a map, to be looked up by place; the order follows from the map alone.
class EdgeEvidence {
 public:
  explicit EdgeEvidence(const EdgeMap& map);

  [[nodiscard]] const std::vector<EdgeSample>& samples() const { return samples_; }

  /// Calls `visit(index)` for all samples in a square of twice `radius_m` around a place, and some beyond; in an order
  /// that depends on the place alone.
  template <typename Visit>
  void around(const Eigen::Vector3d& place_m, double radius_m, Visit&& visit) const {
    for (std::int32_t x = cell(place_m.x() - radius_m); x <= cell(place_m.x() + radius_m); ++x) {
      for (std::int32_t y = cell(place_m.y() - radius_m); y <= cell(place_m.y() + radius_m); ++y) {
        if (const auto* range = cells_.find({x, y, 0})) {
          for (std::uint32_t i = range->first; i < range->second; ++i) {
            visit(std::size_t{i});
          }
        }
      }
    }
  }

 private:
  static constexpr double kCell_m = 1.0;
  /// What lies farther out than cells can be counted shares the last one.
  static std::int32_t cell(double coordinate_m) {
    return static_cast<std::int32_t>(
        std::clamp(std::floor(coordinate_m / kCell_m), -1.0 * kMaxVoxelKey, 1.0 * kMaxVoxelKey));
  }

  std::vector<EdgeSample> samples_;                           // cell by cell
  VoxelHash<std::pair<std::uint32_t, std::uint32_t>> cells_;  // first sample, and one past the last
};

}  // namespace berm
