#include "ring_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace berm {

RingGrid::RingGrid(int sectors, int guessed_rings) : sectors_(sectors), guessed_rings_(guessed_rings) {}

std::size_t RingGrid::offset(int sector, int ring) const {
  const int wrapped = (sector + sectors_) % sectors_;
  return static_cast<std::size_t>(ring) * static_cast<std::size_t>(sectors_) + static_cast<std::size_t>(wrapped);
}

void RingGrid::fill(const PointsView& points, std::span<const Label> labels, const Pose& T_base_sensor) {
  const std::span<const std::uint16_t> numbers = numbers_.process(points, labels, guessed_rings_);
  cells_.assign(static_cast<std::size_t>(sectors_) * numbers_.count(), Cell{});
  cell_of_points_.assign(points.size(), kNoCell);
  const Eigen::Matrix3f R = T_base_sensor.rotation().toRotationMatrix().cast<float>();
  sensor_height_m_ = static_cast<float>(T_base_sensor.translation_m().z());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_solid(labels[i])) {
      const Eigen::Vector3f place =
          R * Eigen::Vector3f(points.x[i], points.y[i], points.z[i]) + Eigen::Vector3f(0.0F, 0.0F, sensor_height_m_);
      add(points, i, place, numbers[i]);
    }
  }
  for (Cell& cell : cells_) {
    const float share = cell.points > 0 ? 1.0F / static_cast<float>(cell.points) : 0.0F;
    for (float* sum : {&cell.radius_m, &cell.x_m, &cell.y_m, &cell.z_m, &cell.time_s}) {
      *sum *= share;
    }
  }
}

void RingGrid::add(const PointsView& points, std::size_t i, const Eigen::Vector3f& place, int ring) {
  constexpr float kPi = std::numbers::pi_v<float>;
  const float turn = (std::atan2(place.y(), place.x()) + kPi) / (2.0F * kPi);
  const int sector = std::clamp(static_cast<int>(turn * static_cast<float>(sectors_)), 0, sectors_ - 1);
  const std::size_t at = offset(sector, ring);
  cell_of_points_[i] = static_cast<std::uint32_t>(at);
  Cell& cell = cells_[at];
  cell.highest_m = cell.points == 0 ? place.z() : std::max(cell.highest_m, place.z());
  cell.lowest_m = cell.points == 0 ? place.z() : std::min(cell.lowest_m, place.z());
  ++cell.points;
  cell.radius_m += std::hypot(place.x(), place.y());
  cell.x_m += place.x();
  cell.y_m += place.y();
  cell.z_m += place.z();
  cell.time_s += points.time.empty() ? 0.0F : points.time[i];
}

}  // namespace berm
