#include "scan_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

#include "scenery.hpp"

namespace berm {
namespace {

/// A scan has no use for more: the map needs a few points per voxel, and gets them from many scans.
constexpr std::size_t kCandidates = 40'000;
constexpr double kLongestPart_s = 0.15;
constexpr double kMostParts = 10.0;

/// Sensors that turn have this many rings and more; the few lines of others cross.
constexpr std::uint16_t kFewestRings = 8;

bool draws_rings(std::span<const std::uint16_t> rings) {
  return std::any_of(rings.begin(), rings.end(), [](std::uint16_t ring) { return ring + 1 >= kFewestRings; });
}

/// Of the points' times, 0 where they are not to be used.
double timed_duration_s(const OdometryInput& input, const SurfaceOdometryConfig& config) {
  return config.deskew ? std::max(0.0, last_time_s(input.points.time)) : 0.0;
}

}  // namespace

std::size_t count_parts(const OdometryInput& input, const SurfaceOdometryConfig& config) {
  const double parts = std::ceil(timed_duration_s(input, config) / kLongestPart_s);
  return static_cast<std::size_t>(std::clamp(parts, 1.0, kMostParts));
}

void limit_points(std::vector<ScanPoint>& points, std::size_t count) {
  if (points.size() <= count) {
    return;
  }
  for (std::size_t i = 0; i < count; ++i) {
    points[i] = points[i * points.size() / count];
  }
  points.resize(count);
}

void MetVoxels::clear() {
  ++round_;
  filled_ = 0;
  if (round_ == 0) {
    std::fill(slots_.begin(), slots_.end(), Slot{});
    round_ = 1;
  }
}

bool MetVoxels::insert(const VoxelKey& key) {
  if (2 * filled_ >= slots_.size()) {
    grow();
  }
  const std::size_t mask = slots_.size() - 1;
  for (std::size_t i = VoxelKeyHash{}(key)&mask;; i = (i + 1) & mask) {
    if (slots_[i].round != round_) {
      slots_[i] = {key, round_};
      ++filled_;
      return true;
    }
    if (slots_[i].key == key) {
      return false;
    }
  }
}

void MetVoxels::grow() {
  constexpr std::size_t kFirst = 1024;
  std::vector<Slot> old(std::max(kFirst, 2 * slots_.size()));
  old.swap(slots_);
  filled_ = 0;
  round_ = std::max(round_, 1U);
  for (const Slot& slot : old) {
    if (slot.round == round_) {
      insert(slot.key);
    }
  }
}

void ScanThinner::process(const OdometryInput& input, const SurfaceOdometryConfig& config, const ScanPart& part) {
  for_map_.clear();
  samples_.clear();
  met_.clear();
  met_coarse_.clear();
  const PointsView& points = input.points;
  const double scan_s = timed_duration_s(input, config);
  const auto parts = static_cast<double>(part.count);
  duration_s_ = scan_s / parts;
  const double min_m2 = config.min_range_m * config.min_range_m;
  const double max_m2 = config.max_range_m * config.max_range_m;
  const bool is_on_ring = draws_rings(points.ring);
  const std::size_t stride = std::max<std::size_t>(1, points.size() / (kCandidates * part.count));
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const double scan_share = scan_s > 0.0 ? std::clamp(static_cast<double>(points.time[i]) / scan_s, 0.0, 1.0) : 0.0;
    // Counted in parts. The last point of all belongs to the last part; a point whose time is NaN to none.
    const double place = scan_share * parts - static_cast<double>(part.index);
    if (!(place >= 0.0 && (place < 1.0 || part.index + 1 == part.count))) {
      continue;
    }
    const Eigen::Vector3d sensor_m(points.x[i], points.y[i], points.z[i]);
    const double range_m2 = sensor_m.squaredNorm();
    if (!is_scenery(input.labels[i]) || !(range_m2 > min_m2 && range_m2 < max_m2)) {
      continue;
    }
    const auto key = voxel_key(sensor_m, config.map_spacing_m);
    if (!key || !met_.insert(*key)) {
      continue;
    }
    const Eigen::Vector3d ray = input.T_base_sensor.rotation() * (sensor_m / std::sqrt(range_m2));
    for_map_.push_back({.base_m = input.T_base_sensor * sensor_m,
                        .share = place,
                        .is_ground = input.labels[i] != Label::obstacle,
                        .is_on_ring = is_on_ring,
                        .ray = ray.cast<float>()});
    const auto coarse_key = voxel_key(sensor_m, config.sample_spacing_m);
    if (coarse_key && met_coarse_.insert(*coarse_key)) {
      samples_.push_back(for_map_.back());
    }
  }
  limit_points(for_map_, static_cast<std::size_t>(config.max_map_points));
  limit_points(samples_, static_cast<std::size_t>(config.max_samples));
}

}  // namespace berm
