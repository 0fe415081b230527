#include "edge/road_scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "berm/core/angle.hpp"

namespace berm::test {
namespace {

constexpr double kSensorHeight_m = 4.0;
constexpr int kColumns = 1800;
constexpr int kRings = 16;
constexpr double kMaxRange_m = 100.0;
constexpr double kTall_m = 0.3;

double across(double beyond_m, double height_m, double slope) {
  const double crest_m = height_m / slope;
  return std::max(0.0, height_m - slope * std::abs(beyond_m - crest_m));
}

/// Range at which the beam meets the ground, to a millimetre; 0: it does not, or meets water.
double cast(const RoadHeights& heights, double azimuth, double elevation) {
  const auto above = [&](double range) {
    const double flat = range * std::cos(elevation);
    const double ground = heights(flat * std::cos(azimuth), flat * std::sin(azimuth));
    return kSensorHeight_m + range * std::sin(elevation) - (std::isnan(ground) ? 0.0 : ground);
  };
  constexpr double kStep_m = 0.1;
  for (double far = 1.0; far < kMaxRange_m; far += kStep_m) {
    if (above(far) < 0.0) {
      double near = far - kStep_m;
      double hit = far;
      while (hit - near > 1e-3) {
        const double middle = 0.5 * (near + hit);
        (above(middle) < 0.0 ? hit : near) = middle;
      }
      const double flat = hit * std::cos(elevation);
      return std::isnan(heights(flat * std::cos(azimuth), flat * std::sin(azimuth))) ? 0.0 : hit;
    }
  }
  return 0.0;
}

}  // namespace

RoadHeights road_between_berms(double half_width_m, double height_m, double slope) {
  return [=](double /*x*/, double y) { return across(std::abs(y) - half_width_m, height_m, slope); };
}

RoadHeights bend_between_berms(double radius_m, double half_width_m, double height_m) {
  return [=](double x, double y) {
    constexpr double kSlope = 0.7;
    return across(std::abs(std::hypot(x, y - radius_m) - radius_m) - half_width_m, height_m, kSlope);
  };
}

PointsView RoadScan::points() const {
  PointsView view;
  view.x = channels.x;
  view.y = channels.y;
  view.z = channels.z;
  view.time = channels.time;
  view.ring = channels.ring;
  return view;
}

EdgeInput RoadScan::input() const {
  return {.points = points(), .labels = labels, .surface = nullptr, .T_base_sensor = T_base_sensor};
}

RoadScan scan_road(const RoadHeights& heights, double noise_m) {
  RoadScan scan;
  scan.T_base_sensor = Pose(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0.0, 0.0, kSensorHeight_m));
  std::mt19937 random(1);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same scan every time
  for (int column = 0; column < kColumns; ++column) {
    const double azimuth = std::numbers::pi - 2.0 * std::numbers::pi * (column + 0.5) / kColumns;
    for (int ring = 0; ring < kRings; ++ring) {
      const double elevation = (2.0 * ring - 15.0) * kRadPerDeg;
      const double hit = cast(heights, azimuth, elevation);
      const double noise = noise_m * (static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 0.5);
      const double range = hit > 0.0 ? hit + 3.5 * noise : 0.0;
      const double z = range * std::sin(elevation);
      scan.channels.x.push_back(static_cast<float>(range * std::cos(elevation) * std::cos(azimuth)));
      scan.channels.y.push_back(static_cast<float>(range * std::cos(elevation) * std::sin(azimuth)));
      scan.channels.z.push_back(static_cast<float>(z));
      scan.channels.time.push_back(static_cast<float>(0.1 * column / kColumns));
      scan.channels.ring.push_back(static_cast<std::uint16_t>(ring));
      const Label solid = kSensorHeight_m + z > kTall_m ? Label::obstacle : Label::drivable;
      scan.labels.push_back(hit > 0.0 ? solid : Label::no_return);
    }
  }
  return scan;
}

}  // namespace berm::test
