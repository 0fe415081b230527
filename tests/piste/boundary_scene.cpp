#include "piste/boundary_scene.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <utility>

#include <Eigen/Geometry>

namespace berm::test {
namespace {

using Eigen::Vector3d;

/// Facet z = climb x + rise + slope beside_m for from_m <= beside_m < to_m to one side of the middle.
struct Facet {
  double from_m = 0.0;
  double to_m = 0.0;
  double rise_m = 0.0;
  double slope = 0.0;
};

struct Hit {
  double range_m = std::numeric_limits<double>::infinity();
  bool on_piste = false;
};

Hit hit(const StraightPiste& piste, const Vector3d& origin, const Vector3d& direction) {
  const double foot_m = piste.half_width_m;
  const double top_m = foot_m + piste.bank_run_m;
  const double slope = piste.bank_m / piste.bank_run_m;
  const Facet facets[] = {
      {0.0, foot_m, 0.0, 0.0}, {foot_m, top_m, -slope * foot_m, slope}, {top_m, 1e9, piste.bank_m, 0.0}};
  Hit nearest;
  for (const double side : {1.0, -1.0}) {
    for (const Facet& facet : facets) {
      const auto above = [&](const Vector3d& p, double middle_y_m, double rise_m) {
        return p.z() - piste.climb * p.x() - facet.slope * side * (p.y() - middle_y_m) - rise_m;
      };
      const double range_m = -above(origin, piste.middle_y_m, facet.rise_m) / above(direction, 0.0, 0.0);
      const double beside_m = side * (origin.y() + range_m * direction.y() - piste.middle_y_m);
      if (range_m > 0.0 && range_m < nearest.range_m && beside_m >= facet.from_m && beside_m < facet.to_m) {
        nearest = {range_m, facet.from_m == 0.0};
      }
    }
  }
  return nearest;
}

PointChannels coordinates_of(const PisteScan& scan) {
  const PointsView view = scan.cloud.view();
  PointChannels channels;
  channels.x.assign(view.x.begin(), view.x.end());
  channels.y.assign(view.y.begin(), view.y.end());
  channels.z.assign(view.z.begin(), view.z.end());
  channels.ring.assign(view.ring.begin(), view.ring.end());
  return channels;
}

}  // namespace

PisteScan look_at(const StraightPiste& piste, const Beams& beams, const Pose& T_base_sensor,
                  const LookOptions& options) {
  std::mt19937 random(options.seed);
  std::normal_distribution<double> normal;
  PisteScan scan;
  scan.T_base_sensor = T_base_sensor;
  PointChannels channels;
  channels.ring = beams.rings;
  const Pose T_sensor_base = T_base_sensor.inverse();
  for (const Vector3d& beam : beams.directions) {
    const Vector3d direction = T_base_sensor.rotation() * beam;
    const Hit there = hit(piste, T_base_sensor.translation_m(), direction);
    const bool met = there.range_m < options.max_range_m;
    Vector3d p = Vector3d::Zero();
    if (met) {
      p = T_base_sensor.translation_m() + (there.range_m + options.range_noise_m * normal(random)) * direction;
      p.z() += there.on_piste ? 0.0 : piste.rough_m * normal(random);
      p = T_sensor_base * p;
    }
    channels.x.push_back(static_cast<float>(p.x()));
    channels.y.push_back(static_cast<float>(p.y()));
    channels.z.push_back(static_cast<float>(p.z()));
    scan.labels.push_back(met ? Label::drivable : Label::no_return);
    scan.on_piste.push_back(met && there.on_piste);
  }
  scan.cloud = PointCloud(std::move(channels));
  return scan;
}

PisteScan remounted(const PisteScan& scan, const Eigen::Quaterniond& turn) {
  PisteScan other = scan;
  PointChannels channels = coordinates_of(scan);
  for (std::size_t i = 0; i < channels.x.size(); ++i) {
    const Vector3d p = turn.inverse() * Vector3d(channels.x[i], channels.y[i], channels.z[i]);
    channels.x[i] = static_cast<float>(p.x());
    channels.y[i] = static_cast<float>(p.y());
    channels.z[i] = static_cast<float>(p.z());
  }
  other.cloud = PointCloud(std::move(channels));
  other.T_base_sensor = scan.T_base_sensor * Pose(turn, Vector3d::Zero());
  return other;
}

PisteScan mirrored(const PisteScan& scan) {
  PisteScan other = scan;
  PointChannels channels = coordinates_of(scan);
  for (float& y : channels.y) {
    y = -y;
  }
  other.cloud = PointCloud(std::move(channels));
  return other;
}

PisteScan shuffled(const PisteScan& scan, std::uint32_t seed) {
  std::vector<std::size_t> order(scan.labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random(seed);
  for (std::size_t i = order.size(); i > 1; --i) {  // std::shuffle differs between standard libraries
    std::swap(order[i - 1], order[random() % i]);
  }
  const PointsView view = scan.cloud.view();
  PisteScan other;
  other.T_base_sensor = scan.T_base_sensor;
  PointChannels channels;
  for (const std::size_t i : order) {
    channels.x.push_back(view.x[i]);
    channels.y.push_back(view.y[i]);
    channels.z.push_back(view.z[i]);
    other.labels.push_back(scan.labels[i]);
    other.on_piste.push_back(scan.on_piste[i]);
  }
  other.cloud = PointCloud(std::move(channels));
  return other;
}

}  // namespace berm::test
