#include "snow/snow_cases.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "berm/core/angle.hpp"

namespace berm::test {
namespace {

double uniform(std::mt19937& random) {
  return static_cast<double>(random()) / 4294967296.0;
}

double normal(std::mt19937& random) {
  return std::sqrt(-2.0 * std::log(1.0 - uniform(random))) * std::cos(2.0 * std::numbers::pi * uniform(random));
}

}  // namespace

PointsView SnowyScan::view() const {
  return {.x = channels.x, .y = channels.y, .z = channels.z, .intensity = channels.intensity};
}

SnowyScan let_it_snow(const MadeScan& scan, const Snowfall& snowfall, std::uint32_t seed) {
  std::mt19937 random(seed);
  SnowyScan snowy;
  const PointsView points = scan.cloud.view();
  snowy.channels.x.assign(points.x.begin(), points.x.end());
  snowy.channels.y.assign(points.y.begin(), points.y.end());
  snowy.channels.z.assign(points.z.begin(), points.z.end());
  snowy.channels.intensity.resize(points.size());
  snowy.is_flake.assign(points.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    float& x = snowy.channels.x[i];
    float& y = snowy.channels.y[i];
    float& z = snowy.channels.z[i];
    const double range_m = std::hypot(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
    const double flake_m = snowfall.median_m * std::exp(snowfall.spread * normal(random));
    float& intensity = snowy.channels.intensity[i];
    intensity = snowfall.least_intensity + static_cast<float>(uniform(random)) * (180.0F - snowfall.least_intensity);
    // Beams without a return have lost their direction here, so that flakes in front of the sky are left out.
    if (uniform(random) < snowfall.share && flake_m < range_m) {
      const auto scale = static_cast<float>(flake_m / range_m);
      x *= scale;
      y *= scale;
      z *= scale;
      intensity = std::floor(static_cast<float>(uniform(random)) * (snowfall.most_intensity + 1.0F));
      snowy.is_flake[i] = 1;
    }
  }
  return snowy;
}

MadeScan Lookout::look(const World& world, std::uint32_t seed) const {
  return cast(world, beams, standing_at_origin(world, height_m, pitch_deg), {.seed = seed});
}

Lookout spinning_64() {
  return {"64 rings", spinning_beams(64, -24.9, 2.0, 900), 1.73, 0.0};
}

Lookout spinning_16() {
  return {"16 rings", spinning_beams(16, -15.0, 15.0, 1800), 1.73, 0.0};
}

Lookout rosette_70() {
  return {"rosette", rosette_beams(70.4, 10000), 2.3, 11.0};
}

const std::vector<Lookout>& lookouts() {
  static const std::vector<Lookout> all = {spinning_64(), spinning_16(), rosette_70()};
  return all;
}

SnowScore score(const SnowResult& result, const SnowyScan& scan) {
  double hits = 0.0;
  double flakes = 0.0;
  double returns = 0.0;
  const PointsView points = scan.view();
  for (std::size_t i = 0; i < points.size(); ++i) {
    hits += result.falling[i] != 0 && scan.is_flake[i] != 0 ? 1.0 : 0.0;
    flakes += scan.is_flake[i];
    returns += is_no_return(points.x[i], points.y[i], points.z[i]) ? 0.0 : 1.0;
  }
  const auto marks = static_cast<double>(result.count);
  return {.precision = marks > 0.0 ? hits / marks : 1.0,
          .recall = flakes > 0.0 ? hits / flakes : 1.0,
          .f1 = marks + flakes > 0.0 ? 2.0 * hits / (marks + flakes) : 1.0,
          .marked = returns > 0.0 ? marks / returns : 0.0};
}

bool is_sound(const SnowResult& result, const PointsView& points) {
  if (result.falling.size() != points.size()) {
    return false;
  }
  std::size_t marks = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float extent = std::fabs(points.x[i]) + std::fabs(points.y[i]) + std::fabs(points.z[i]);
    const bool usable = extent > 0.0F && extent < 1e5F;
    if (result.falling[i] > 1 || (result.falling[i] == 1 && !usable)) {
      return false;
    }
    marks += result.falling[i];
  }
  return marks == result.count;
}

SnowyScan turned(const SnowyScan& scan, double yaw_deg, double pitch_deg, double roll_deg) {
  const Pose turn = Pose::from_yaw_pitch_roll(yaw_deg * kRadPerDeg, pitch_deg * kRadPerDeg, roll_deg * kRadPerDeg,
                                              Eigen::Vector3d::Zero());
  SnowyScan result = scan;
  for (std::size_t i = 0; i < scan.is_flake.size(); ++i) {
    const Eigen::Vector3d p(static_cast<double>(scan.channels.x[i]), static_cast<double>(scan.channels.y[i]),
                            static_cast<double>(scan.channels.z[i]));
    const Eigen::Vector3f q = (turn * p).cast<float>();
    result.channels.x[i] = q.x();
    result.channels.y[i] = q.y();
    result.channels.z[i] = q.z();
  }
  return result;
}

SnowyScan picked(const SnowyScan& scan, const std::vector<std::size_t>& order) {
  SnowyScan result;
  for (const std::size_t i : order) {
    result.channels.x.push_back(scan.channels.x[i]);
    result.channels.y.push_back(scan.channels.y[i]);
    result.channels.z.push_back(scan.channels.z[i]);
    result.channels.intensity.push_back(scan.channels.intensity[i]);
    result.is_flake.push_back(scan.is_flake[i]);
  }
  return result;
}

}  // namespace berm::test
