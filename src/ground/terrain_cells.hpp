#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/geometry/polar_grid.hpp"

namespace berm {

/// How a place becomes a cell without logarithm or arc tangent. Bins are equally long within an octave of
/// (range + 8 m), as the mantissa of a float is, and twice as long in the next: near cells are short, far ones hold
/// more than one ring of a spinning sensor.
struct TerrainCells {
  /// `cell_m` is rounded so that a whole number of cells makes up 8 m.
  TerrainCells(int sector_count, double cell_m, double max_range);

  [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(sectors) * static_cast<std::size_t>(bins); }
  /// The same cells for looking up.
  [[nodiscard]] PolarGrid grid() const;

  int sectors;
  int bins_per_octave;
  float max_range_m;
  int bins = 0;
  std::vector<float> edges_m;  ///< bins + 1
};

/// Rotation and offset of the levelled frame as floats, for hot loops.
struct LevelFrame {
  explicit LevelFrame(const Pose& T_level_sensor);

  float xx, xy, xz;      ///< x axis of the levelled frame in the sensor frame
  float yx, yy, yz;      ///< its y axis
  float zx, zy, zz, z0;  ///< height of a sensor point: (zx, zy, zz) . p + z0
};

/// Cell of every point, row by row (all sectors of the nearest bin first): `cell[i] = bin * sectors + sector`, or
/// `cells.size()` for a no-return, a point that is not finite, or one beyond the range; and its height in the levelled
/// frame. `cell` and `height_m` are as long as `points`.
void locate_points(const PointsView& points, const LevelFrame& frame, const TerrainCells& cells,
                   std::span<std::uint16_t> cell, std::span<float> height_m);

}  // namespace berm
