#include "base_terrain.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace berm::sim {
namespace {

/// Weights of the four nodes around for a place at share u of the cell.
std::array<double, 4> spline_weights(double u) {
  const double v = 1.0 - u;
  return {v * v * v / 6.0, (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0,
          (-3.0 * u * u * u + 3.0 * u * u + 3.0 * u + 1.0) / 6.0, u * u * u / 6.0};
}

/// Nearer than this all knots count alike.
constexpr double kKnotSize_m = 6.0;
/// Slopes of knots do not go on for ever: the ground levels out at about this distance.
constexpr double kSlopeReach_m = 120.0;

}  // namespace

SmoothRaster::SmoothRaster(const Area& area, double cell_m, const std::function<double(double, double)>& value)
    : area_(area),
      cell_m_(cell_m),
      columns_(static_cast<int>(std::ceil((area.max_x_m - area.min_x_m) / cell_m)) + 1),
      rows_(static_cast<int>(std::ceil((area.max_y_m - area.min_y_m) / cell_m)) + 1) {
  values_.reserve(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      values_.push_back(static_cast<float>(value(area.min_x_m + column * cell_m, area.min_y_m + row * cell_m)));
    }
  }
}

double SmoothRaster::at(double x_m, double y_m) const {
  const double tx = std::clamp((x_m - area_.min_x_m) / cell_m_, 0.0, static_cast<double>(columns_ - 1));
  const double ty = std::clamp((y_m - area_.min_y_m) / cell_m_, 0.0, static_cast<double>(rows_ - 1));
  const int column = static_cast<int>(tx);
  const int row = static_cast<int>(ty);
  const std::array<double, 4> wx = spline_weights(tx - column);
  const std::array<double, 4> wy = spline_weights(ty - row);
  double sum = 0.0;
  for (int j = 0; j < 4; ++j) {
    const int r = std::clamp(row + j - 1, 0, rows_ - 1);
    const float* line = &values_[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_)];
    double line_sum = 0.0;
    for (int i = 0; i < 4; ++i) {
      line_sum +=
          wx[static_cast<std::size_t>(i)] * static_cast<double>(line[std::clamp(column + i - 1, 0, columns_ - 1)]);
    }
    sum += wy[static_cast<std::size_t>(j)] * line_sum;
  }
  return sum;
}

void SmoothRaster::raise(double by_m) {
  for (float& value : values_) {
    value = static_cast<float>(static_cast<double>(value) + by_m);
  }
}

double ground_between(const std::vector<GroundKnot>& knots, double x_m, double y_m) {
  double sum = 0.0;
  double weights = 0.0;
  for (const GroundKnot& knot : knots) {
    const double dx = x_m - knot.x_m;
    const double dy = y_m - knot.y_m;
    const double squared = dx * dx + dy * dy;
    const double near = squared + kKnotSize_m * kKnotSize_m;
    const double weight = 1.0 / (near * near);
    const double share = 1.0 / (1.0 + std::sqrt(squared) / kSlopeReach_m);
    sum += weight * (knot.z_m + share * (knot.slope_x * dx + knot.slope_y * dy));
    weights += weight;
  }
  return sum / weights;
}

}  // namespace berm::sim
