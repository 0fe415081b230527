#include "piste/mid70_scan.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <numbers>

#include "berm/core/angle.hpp"

namespace berm::test {
namespace {

constexpr double kMountHeight_m = 2.3;
constexpr double kMountPitch_rad = 11.0 * kRadPerDeg;

}  // namespace

Beams mid70_beams(std::size_t first, std::size_t count) {
  constexpr double kHalfField_rad = 35.2 * kRadPerDeg;
  constexpr double kShare = 0.506;
  constexpr double kTurn_rad = 2.0 * std::numbers::pi * -122.306 / 100000.0;
  constexpr double kRatio = -0.639332;
  Beams beams;
  for (std::size_t i = first; i < first + count; ++i) {
    const double turn_rad = kTurn_rad * static_cast<double>(i);
    const std::complex<double> deflection =
        kHalfField_rad * (std::polar(kShare, turn_rad) + std::polar(1.0 - kShare, kRatio * turn_rad));
    const double angle_rad = std::abs(deflection);
    const std::complex<double> side = deflection / std::max(angle_rad, 1e-12) * std::sin(angle_rad);
    beams.directions.emplace_back(std::cos(angle_rad), side.real(), side.imag());
  }
  return beams;
}

Pose groomer_mount() {
  return Pose::from_yaw_pitch_roll(0.0, kMountPitch_rad, 0.0, {0.0, 0.0, kMountHeight_m});
}

World made_piste() {
  World world;
  world.terrain_m = [](double x_m, double y_m) {
    const double climb_m = x_m > 15.0 ? 0.1 * (x_m - 15.0) : 0.0;
    const double beside_m = std::max(0.0, std::abs(y_m) - 10.0);
    return climb_m + std::min(0.6 * beside_m, 1.5) + 0.02 * std::sin(0.7 * x_m) * std::cos(0.4 * y_m);
  };
  for (int i = 0; i < 30; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    world.things.push_back({8.0 + 2.5 * i, side * (14.0 + i % 5), 0.3, 0.3, 6.0, 0.0, true});
  }
  world.things.push_back({30.0, 4.0, 1.5, 1.5, 3.0});
  return world;
}

MadeScan mid70_scan(std::size_t first, std::size_t count) {
  const World world = made_piste();
  return cast(world, mid70_beams(first, count), standing_at_origin(world, kMountHeight_m, kMountPitch_rad / kRadPerDeg),
              {.seed = static_cast<std::uint32_t>(first) + 1});
}

}  // namespace berm::test
