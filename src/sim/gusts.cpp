#include "gusts.hpp"

#include <cmath>
#include <numbers>

#include "berm/sim/random.hpp"

namespace berm::sim {
namespace {

/// Value of a node of the lattice: nothing at half of them, up to four times the mean elsewhere.
double node(std::uint64_t seed, double x, double y) {
  Random random(seed, Purpose::weather, static_cast<std::uint64_t>(static_cast<std::int64_t>(x)),
                static_cast<std::uint64_t>(static_cast<std::int64_t>(y)));
  const double u = random.uniform();
  return u < 0.5 ? 0.0 : 8.0 * (u - 0.5);
}

}  // namespace

Gusts::Gusts(const SnowfallConfig& snowfall, std::uint64_t seed)
    : gustiness_(snowfall.gustiness), nodes_per_m_(1.0 / snowfall.gust_size_m), seed_(seed) {
  const double from_rad = snowfall.wind_from_deg * std::numbers::pi / 180.0;
  velocity_x_m_per_s_ = -snowfall.wind_m_per_s * std::sin(from_rad);
  velocity_y_m_per_s_ = -snowfall.wind_m_per_s * std::cos(from_rad);
}

// Bilinear between nodes of mean 1, hence of mean 1 itself.
double Gusts::at(const Eigen::Vector3d& place_m, double time_s) const {
  if (gustiness_ <= 0.0) {
    return 1.0;
  }
  const double x = (place_m.x() - velocity_x_m_per_s_ * time_s) * nodes_per_m_;
  const double y = (place_m.y() - velocity_y_m_per_s_ * time_s) * nodes_per_m_;
  const double column = std::floor(x);
  const double row = std::floor(y);
  const double right = x - column;
  const double up = y - row;
  const double low = (1.0 - right) * node(seed_, column, row) + right * node(seed_, column + 1.0, row);
  const double high = (1.0 - right) * node(seed_, column, row + 1.0) + right * node(seed_, column + 1.0, row + 1.0);
  return 1.0 - gustiness_ + gustiness_ * ((1.0 - up) * low + up * high);
}

}  // namespace berm::sim
