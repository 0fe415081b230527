#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "berm/core/pose.hpp"
#include "berm/geometry/polar_grid.hpp"

namespace berm {

/// A height and one standard deviation of it.
struct HeightEstimate {
  double height_m = 0.0;
  double sigma_m = 0.0;
};

/// Height of the ground around a sensor on a polar grid, each cell a small plane with an uncertainty. It lives in the
/// levelled frame of the scan: origin on the ground plane below the sensor, z along the normal of that plane.
class HeightGrid {
 public:
  /// The ground in one cell.
  struct Cell {
    float height_m = 0.0F;      ///< at the middle of the cell
    float radial_slope = 0.0F;  ///< rise per metre away from the sensor
    float sigma_m = 0.0F;       ///< of the height
    bool measured = false;      ///< whether the ground was seen here; else it is carried on from cells that were
  };

  /// The same, one array each for all cells: all sectors of the nearest bin, then those of the next.
  struct Channels {
    std::vector<float> height_m;
    std::vector<float> radial_slope;
    std::vector<float> variance_m2;
    std::vector<std::uint8_t> measured;
  };

  explicit HeightGrid(PolarGrid grid);

  [[nodiscard]] const PolarGrid& grid() const { return grid_; }
  [[nodiscard]] const Pose& T_level_sensor() const { return T_level_sensor_; }
  void set_T_level_sensor(const Pose& T_level_sensor) { T_level_sensor_ = T_level_sensor; }

  /// For whoever fills the grid; the lengths must stay.
  [[nodiscard]] Channels& channels() { return channels_; }
  [[nodiscard]] const Channels& channels() const { return channels_; }
  /// Place of a cell in the channels; `cell` must be of `grid()`.
  [[nodiscard]] std::size_t offset(PolarCell cell) const {
    return static_cast<std::size_t>(cell.bin) * static_cast<std::size_t>(grid_.sectors()) +
           static_cast<std::size_t>(cell.sector);
  }
  [[nodiscard]] Cell cell(PolarCell cell) const;

  /// The ground at a place of the levelled frame; none outside of the grid and for NaN.
  [[nodiscard]] std::optional<HeightEstimate> at(double x_m, double y_m) const;
  /// How high a point of the sensor frame lies above the ground, along the normal of the levelled plane, with the
  /// uncertainty of the ground; none outside of the grid and for NaN.
  [[nodiscard]] std::optional<HeightEstimate> height_above(const Eigen::Vector3d& point_sensor_m) const;

 private:
  PolarGrid grid_;
  Pose T_level_sensor_;
  Channels channels_;
};

}  // namespace berm
