#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "berm/core/point_cloud.hpp"
#include "berm/geometry/height_grid.hpp"
#include "berm/ground/ground.hpp"
#include "terrain_cells.hpp"

namespace berm {

/// The test of points against the ground of their cells: one small plane per cell, raised by its tolerance and turned
/// into the sensor frame, so that a point costs three products.
class CellPlanes {
 public:
  explicit CellPlanes(const TerrainCells& cells);

  /// `bare_m` and `object_m`: how high above the ground a point may lie to belong to it, in cells without and with an
  /// object.
  void build(const HeightGrid::Channels& surface, std::span<const std::uint8_t> has_object, const LevelFrame& frame,
             float bare_m, float object_m);

  /// Says `ground` of points below the plane of their cell and `not_ground` of all others, those of no cell included.
  /// Gives the number of ground points.
  std::size_t classify(const PointsView& points, std::span<const std::uint16_t> cell_of_point,
                       std::span<GroundClass> classes) const;

 private:
  /// Points with nx x + ny y + nz z + d < 0 lie below.
  struct Plane {
    float nx;
    float ny;
    float nz;
    float d;
  };

  std::size_t sectors_;
  std::vector<float> middles_m_;  ///< of the bins
  std::vector<float> cos_;        ///< of the azimuth in the middle of each sector
  std::vector<float> sin_;
  std::vector<Plane> planes_;  ///< and behind them one that no point lies below
};

}  // namespace berm
