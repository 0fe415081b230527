#include "slope_fan.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace berm {

SlopeFan::SlopeFan(const EnvelopePisteConfig& config)
    : min_m_(config.fan_min_m),
      max_m_(config.fan_max_m),
      cell_m_(config.fan_cell_m),
      tan_half_angle_(std::tan(config.fan_half_angle_deg * std::numbers::pi / 180.0)),
      cells_(static_cast<std::size_t>(std::ceil((max_m_ - min_m_) / cell_m_))) {}

void SlopeFan::fill(const BaseSeries& series, std::span<const std::uint8_t> interpolated) {
  std::fill(cells_.begin(), cells_.end(), Cell{});
  const auto tan_half_angle = static_cast<float>(tan_half_angle_);
  const std::span<const float> x = series.x();
  const std::span<const float> y = series.y();
  const std::span<const float> z = series.z();
  for (std::size_t i = 0; i < series.size(); ++i) {
    if (!(std::abs(y[i]) <= tan_half_angle * x[i]) || interpolated[i] != 0 || !std::isfinite(z[i])) {
      continue;
    }
    const auto x_m = static_cast<double>(x[i]);
    const auto y_m = static_cast<double>(y[i]);
    const double distance_m = std::sqrt(x_m * x_m + y_m * y_m);
    if (distance_m < min_m_ || distance_m >= max_m_) {
      continue;
    }
    const auto k = static_cast<std::size_t>((distance_m - min_m_) / cell_m_);
    Cell& cell = cells_[std::min(k, cells_.size() - 1)];
    cell.x_m += x_m;
    cell.y_m += y_m;
    cell.z_m += static_cast<double>(z[i]);
    ++cell.points;
  }
  for (Cell& cell : cells_) {
    if (cell.points > 0) {
      cell.x_m /= cell.points;
      cell.y_m /= cell.points;
      cell.z_m /= cell.points;
    }
  }
}

std::optional<SlopeAhead> SlopeFan::measure(const BaseSeries& series, std::span<const std::uint8_t> interpolated) {
  fill(series, interpolated);
  double sum = 0.0;
  double squares = 0.0;
  int pairs = 0;
  for (std::size_t k = 1; k < cells_.size(); ++k) {
    const Cell& near = cells_[k - 1];
    const Cell& far = cells_[k];
    if (near.points == 0 || far.points == 0) {
      continue;
    }
    const double slope_rad = std::atan2(far.z_m - near.z_m, std::hypot(far.x_m - near.x_m, far.y_m - near.y_m));
    sum += slope_rad;
    squares += slope_rad * slope_rad;
    ++pairs;
  }
  if (pairs == 0) {
    return std::nullopt;
  }
  SlopeAhead slope;
  slope.slope_rad = sum / pairs;
  slope.slope_sigma_rad = std::numbers::pi / 2.0;
  if (pairs > 1) {
    const double variance = std::max(0.0, squares - sum * slope.slope_rad) / (pairs - 1);
    slope.slope_sigma_rad = std::sqrt(variance / pairs);
  }
  return slope;
}

}  // namespace berm
