#include "drive_way.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "berm/sim/random.hpp"

namespace berm::sim {
namespace {

/// Nobody steers in waves shorter than this, nor keeps to one side for longer.
constexpr double kShortestWave_m = 35.0;
constexpr double kLongestWave_m = 160.0;
/// What a driver keeps between the tracks and the edge.
constexpr double kDriveClearance_m = 0.4;
constexpr double kDriveStep_m = 0.25;

}  // namespace

DrivenWay::DrivenWay(const Route& route, const VehicleConfig& config, std::uint64_t seed)
    : route_(route),
      wander_m_(config.wander_m),
      half_width_m_(0.5 * config.width_m),
      half_length_m_(0.5 * config.length_m) {
  Random random(seed, Purpose::vehicle, 2);
  for (Wave& wave : waves_) {
    wave.per_m = 2.0 * std::numbers::pi / random.uniform(kShortestWave_m, kLongestWave_m);
    wave.phase_rad = random.uniform(0.0, 2.0 * std::numbers::pi);
  }
}

double DrivenWay::strays_m(double s_m, const RoutePoint& point) const {
  double sum = 0.0;
  for (const Wave& wave : waves_) {
    sum += std::sin(wave.per_m * s_m + wave.phase_rad);
  }
  // A sine has a variance of 1/2.
  const double wanted_m = wander_m_ * sum * std::sqrt(2.0 / static_cast<double>(waves_.size()));
  const double free_m = std::min(point.left_m, point.right_m) - half_width_m_ - kDriveClearance_m;
  return free_m > 0.0 ? free_m * std::tanh(wanted_m / free_m) : 0.0;
}

Eigen::Vector2d DrivenWay::at(double s_m) const {
  const RoutePoint point = route_.at(s_m);
  const double left_m = strays_m(s_m, point);
  return {point.x_m - left_m * std::sin(point.heading_rad), point.y_m + left_m * std::cos(point.heading_rad)};
}

double DrivenWay::heading_rad(double s_m) const {
  const double rear_m = std::max(0.0, s_m - half_length_m_);
  const double front_m = std::min(route_.length_m(), s_m + half_length_m_);
  const Eigen::Vector2d ahead = at(front_m) - at(rear_m);
  return std::atan2(ahead.y(), ahead.x());
}

double DrivenWay::stretch(double s_m) const {
  const double planar = (at(s_m + kDriveStep_m) - at(s_m - kDriveStep_m)).norm() / (2.0 * kDriveStep_m);
  // At the ends of the route, where `at` stands still.
  return std::hypot(std::max(0.2, planar), route_.gradient(s_m));
}

}  // namespace berm::sim
