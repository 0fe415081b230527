#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "berm/geometry/voxel_hash.hpp"
#include "berm/map/road_survey.hpp"
#include "road_crossings.hpp"

namespace berm {
namespace {

/// Stations lie a metre apart, and each looks at the metre around it.
constexpr double kNear_m = 1.0;
/// Edges far above or below are those of another road.
constexpr double kMostClimb_m = 4.0;

struct SeenBerm {
  Eigen::Vector3d toe_m;
  Measure height_m;
};

/// Berms by where they stand, from above.
class SeenBerms {
 public:
  explicit SeenBerms(std::span<const RoadStation> stations) {
    for (const RoadStation& station : stations) {
      const Eigen::Vector3d left(-std::sin(station.heading_rad), std::cos(station.heading_rad), 0.0);
      add(station, station.left, left);
      add(station, station.right, -left);
    }
  }

  [[nodiscard]] std::optional<double> height_m(const Eigen::Vector3d& place_m) const {
    const auto middle = cell_of(place_m);
    if (!middle) {
      return std::nullopt;
    }
    double sum_m = 0.0;
    double weights = 0.0;
    for (std::int32_t cell = 0; cell < 9; ++cell) {
      const auto* those = cells_.find({middle->x + cell % 3 - 1, middle->y + cell / 3 - 1, 0});
      if (those == nullptr) {
        continue;
      }
      for (const SeenBerm& berm : *those) {
        const Eigen::Vector3d off_m = berm.toe_m - place_m;
        if (off_m.head<2>().norm() <= kNear_m && std::abs(off_m.z()) <= kMostClimb_m) {
          const double weight = 1.0 / (berm.height_m.sigma * berm.height_m.sigma);
          sum_m += weight * berm.height_m.value;
          weights += weight;
        }
      }
    }
    return weights > 0.0 ? std::optional(sum_m / weights) : std::nullopt;
  }

 private:
  [[nodiscard]] std::optional<VoxelKey> cell_of(const Eigen::Vector3d& place_m) const {
    return cells_.key_of({place_m.x(), place_m.y(), 0.0});
  }

  void add(const RoadStation& station, const RoadSide& side, const Eigen::Vector3d& outward) {
    if (side.edge_m && side.berm_height_m && side.berm_height_m->sigma > 0.0) {
      const Eigen::Vector3d toe_m = station.position_m + side.edge_m->value * outward;
      if (const auto cell = cell_of(toe_m)) {
        cells_.at_or_new(*cell).push_back({toe_m, *side.berm_height_m});
      }
    }
  }

  VoxelHash<std::vector<SeenBerm>> cells_{kNear_m};
};

}  // namespace

void set_berm_heights(std::span<const RoadStation> stations, std::span<EdgeLine> lines) {
  const SeenBerms berms(stations);
  for (EdgeLine& line : lines) {
    for (EdgeLine::Vertex& vertex : line.vertices) {
      vertex.berm_height_m = vertex.confidence >= kLeastConfidence ? berms.height_m(vertex.position_m) : std::nullopt;
    }
  }
}

}  // namespace berm
