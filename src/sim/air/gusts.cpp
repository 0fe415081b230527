#include "gusts.hpp"

#include <cmath>
#include <numbers>

#include "berm/sim/random.hpp"

namespace berm::sim {
namespace {

/// std::floor is a call of the library unless built for newer processors.
std::int64_t whole_below(double x) {
  const auto towards_zero = static_cast<std::int64_t>(x);
  return towards_zero - (static_cast<double>(towards_zero) > x ? 1 : 0);
}

}  // namespace

// Half of the nodes have nothing, the others up to four times the mean. They are
// scaled so that the mean of the lattice is 1 and not about 1.
Gusts::Gusts(const SnowfallConfig& snowfall, std::uint64_t seed)
    : gustiness_(snowfall.gustiness), nodes_per_m_(1.0 / snowfall.gust_size_m) {
  const double from_rad = snowfall.wind_from_deg * std::numbers::pi / 180.0;
  velocity_x_m_per_s_ = -snowfall.wind_m_per_s * std::sin(from_rad);
  velocity_y_m_per_s_ = -snowfall.wind_m_per_s * std::cos(from_rad);
  Random random(seed, Purpose::weather);
  nodes_.resize(static_cast<std::size_t>(kNodes * kNodes));
  double sum = 0.0;
  for (float& value : nodes_) {
    value = random.chance(0.5) ? 0.0F : static_cast<float>(random.uniform());
    sum += static_cast<double>(value);
  }
  const auto scale = static_cast<float>(static_cast<double>(nodes_.size()) / sum);
  for (float& value : nodes_) {
    value *= scale;
  }
}

// Bilinear between nodes of mean 1, hence of mean 1 itself.
double Gusts::at(const Eigen::Vector3d& place_m, double time_s) const {
  if (gustiness_ <= 0.0) {
    return 1.0;
  }
  const double x = (place_m.x() - velocity_x_m_per_s_ * time_s) * nodes_per_m_;
  const double y = (place_m.y() - velocity_y_m_per_s_ * time_s) * nodes_per_m_;
  const std::int64_t column = whole_below(x);
  const std::int64_t row = whole_below(y);
  const double right = x - static_cast<double>(column);
  const double up = y - static_cast<double>(row);
  const double low = node(column, row) + right * (node(column + 1, row) - node(column, row));
  const double high = node(column, row + 1) + right * (node(column + 1, row + 1) - node(column, row + 1));
  return 1.0 - gustiness_ + gustiness_ * (low + up * (high - low));
}

}  // namespace berm::sim
