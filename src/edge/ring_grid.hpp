#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "berm/core/label.hpp"
#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "ring_numbers.hpp"

namespace berm {

/// Sectors by azimuth times rings (E step 1), in base_link with the origin below the sensor.
class RingGrid {
 public:
  struct Cell {
    std::uint32_t points = 0;
    float radius_m = 0.0F;  ///< means
    float x_m = 0.0F;
    float y_m = 0.0F;
    float z_m = 0.0F;
    float time_s = 0.0F;
    float highest_m = 0.0F;
    float lowest_m = 0.0F;
  };
  static constexpr std::uint32_t kNoCell = 0xFFFFFFFFU;

  RingGrid(int sectors, int guessed_rings);

  void fill(const PointsView& points, std::span<const Label> labels, const Pose& T_base_sensor);

  [[nodiscard]] int sectors() const { return sectors_; }
  [[nodiscard]] int rings() const { return static_cast<int>(numbers_.count()); }
  [[nodiscard]] float sensor_height_m() const { return sensor_height_m_; }
  /// `sector` may lie a turn beyond the grid on either side.
  [[nodiscard]] std::size_t offset(int sector, int ring) const;
  [[nodiscard]] const Cell& cell(int sector, int ring) const { return cells_[offset(sector, ring)]; }
  [[nodiscard]] std::span<const Cell> cells() const { return cells_; }
  /// Offset of the cell that each point fell into, or kNoCell.
  [[nodiscard]] std::span<const std::uint32_t> cell_of_points() const { return cell_of_points_; }

 private:
  void add(const PointsView& points, std::size_t i, const Eigen::Vector3f& place, int ring);

  int sectors_;
  int guessed_rings_;
  float sensor_height_m_ = 0.0F;
  RingNumbers numbers_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> cell_of_points_;
};

}  // namespace berm
