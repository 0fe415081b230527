#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "berm/geometry/height_grid.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "terrain_cells.hpp"

namespace berm {

/// What the points say of each cell: the lowest and the highest height in the levelled frame; +Inf and -Inf where
/// there is no point. One more entry than cells, for the points of none.
struct CellExtremes {
  std::vector<float> lowest_m;
  std::vector<float> highest_m;
};

/// Follows the ground outward, bin by bin, all sectors abreast. Each sector carries a Kalman filter of two states, the
/// height and its slope outward; a cell's lowest point is a measurement unless it lies too far above or below what is
/// expected. Between two bins neighbouring sectors share their estimates.
class TerrainFollower {
 public:
  TerrainFollower(const TerrainGroundConfig& config, const TerrainCells& cells);

  /// `plane_rms_m`: how well the low points around the sensor fit the levelled plane, which is where it starts;
  /// `blind_m`: nearer than this no ground is seen, and the plane says as much as it does at that distance.
  /// Fills all channels of `surface`, and `has_object` with 1 for cells that hold something high.
  void follow(const CellExtremes& extremes, double plane_rms_m, double blind_m, HeightGrid::Channels& surface,
              std::span<std::uint8_t> has_object);

 private:
  /// One value per sector, and a copy of the last before the first and of the first behind the last.
  using Ring = std::vector<float>;

  struct Estimate {
    Ring height_m;
    Ring slope;
    Ring height_variance;
    Ring covariance;
    Ring slope_variance;
  };

  void start(double plane_rms_m);
  void measure(const CellExtremes& extremes, std::size_t bin, float blind_m, std::uint8_t* measured,
               std::uint8_t* has_object);
  void share(std::size_t bin, const std::uint8_t* measured);
  void store(std::size_t bin, HeightGrid::Channels& surface) const;
  void slope_outward(HeightGrid::Channels& surface) const;

  TerrainGroundConfig config_;
  std::size_t sectors_;
  std::vector<float> middles_m_;
  std::vector<float> lengths_m_;
  float radians_per_sector_;

  Estimate now_;
  Estimate before_;
  Ring lowest_m_;
};

}  // namespace berm
