#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

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
  void follow(const CellExtremes& extremes, double plane_rms_m, double blind_m);

  // The ground, one value per cell in the order of `TerrainCells`.
  [[nodiscard]] std::span<const float> heights_m() const { return heights_m_; }          ///< at the middle of the cell
  [[nodiscard]] std::span<const float> cross_slopes() const { return cross_slopes_; }    ///< rise per metre leftward
  [[nodiscard]] std::span<const float> variances_m2() const { return variances_m2_; }
  [[nodiscard]] std::span<const std::uint8_t> measured() const { return measured_; }     ///< 1: the ground was seen
  [[nodiscard]] std::span<const std::uint8_t> has_object() const { return has_object_; } ///< 1: something high is there

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
  void measure(const CellExtremes& extremes, int bin, float blind_m);
  void share(int bin);
  void store(int bin);

  TerrainGroundConfig config_;
  int sectors_;
  int bins_;
  std::vector<float> middles_m_;
  std::vector<float> lengths_m_;
  float radians_per_sector_;

  Estimate now_;
  Estimate before_;
  Ring cross_slope_;

  std::vector<float> heights_m_;
  std::vector<float> cross_slopes_;
  std::vector<float> variances_m2_;
  std::vector<std::uint8_t> measured_;
  std::vector<std::uint8_t> has_object_;
};

}  // namespace berm
