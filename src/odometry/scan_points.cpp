#include "scan_points.hpp"

#include <algorithm>
#include <cmath>

#include "scenery.hpp"

namespace berm {
namespace {

/// A scan has no use for more: the map needs a few points per voxel, and gets them from many scans.
constexpr std::size_t kCandidates = 40'000;

}  // namespace

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

void ScanThinner::process(const OdometryInput& input, const SurfaceOdometryConfig& config) {
  for_map_.clear();
  samples_.clear();
  met_.clear();
  met_coarse_.clear();
  const PointsView& points = input.points;
  const double last_s = last_time_s(points.time);
  const bool timed = config.deskew && last_s > 0.0;
  duration_s_ = timed ? last_s : 0.0;
  const double min_m2 = config.min_range_m * config.min_range_m;
  const double max_m2 = config.max_range_m * config.max_range_m;
  const std::size_t stride = std::max<std::size_t>(1, points.size() / kCandidates);
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const Eigen::Vector3d sensor_m(points.x[i], points.y[i], points.z[i]);
    const double range_m2 = sensor_m.squaredNorm();
    if (!is_scenery(input.labels[i]) || !(range_m2 > min_m2 && range_m2 < max_m2)) {
      continue;
    }
    const auto key = voxel_key(sensor_m, config.map_spacing_m);
    if (!key || !met_.insert(*key)) {
      continue;
    }
    const double share = timed ? std::clamp(static_cast<double>(points.time[i]) / last_s, 0.0, 1.0) : 0.0;
    if (!(share >= 0.0)) {
      continue;  // a point whose time is NaN
    }
    for_map_.push_back({input.T_base_sensor * sensor_m, share, input.labels[i] != Label::obstacle});
    const auto coarse_key = voxel_key(sensor_m, config.sample_spacing_m);
    if (coarse_key && met_coarse_.insert(*coarse_key)) {
      samples_.push_back(for_map_.back());
    }
  }
  limit_points(for_map_, static_cast<std::size_t>(config.max_map_points));
  limit_points(samples_, static_cast<std::size_t>(config.max_samples));
}

}  // namespace berm
