#include "berm/ground/polar_ground.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "berm/core/error.hpp"
#include "count_classes.hpp"

namespace berm {
namespace {

/// A cell without points keeps a lowest point that lies above every T_hmax.
constexpr float kNoPoint_m = std::numeric_limits<float>::max();

float as_float(double value) {
  return static_cast<float>(value);
}

void check_order(const char* key, double low, double high) {
  if (!(low < high)) {
    throw ConfigError(std::string("ground_reference.") + key, "the minimum must lie below the maximum");
  }
}

}  // namespace

void PolarGroundConfig::check() const {
  check_fields(*this, "ground_reference");
  check_order("min_range_m", min_range_m, max_range_m);
  check_order("min_height_m", min_height_m, max_height_m);
}

PolarGround::PolarGround(const PolarGroundConfig& config) : config_(config) {
  config_.check();
  cells_.resize(static_cast<std::size_t>(config_.channels) * static_cast<std::size_t>(config_.bins));
}

PolarGround::Cell& PolarGround::cell(int channel, int bin) {
  return cells_[static_cast<std::size_t>(channel) * static_cast<std::size_t>(config_.bins) +
                static_cast<std::size_t>(bin)];
}

/// G steps 1 and 2. A point at azimuth exactly +pi falls off the grid, as in the original.
void PolarGround::map_points(const PointsView& points, const Pose& T_base_sensor) {
  constexpr float kPi = std::numbers::pi_v<float>;
  const Eigen::Matrix3f R = T_base_sensor.rotation().toRotationMatrix().cast<float>();
  const float min_range_m = as_float(config_.min_range_m);
  const float max_range_m = as_float(config_.max_range_m);
  std::fill(cells_.begin(), cells_.end(), Cell{.lowest_m = kNoPoint_m});
  cell_of_point_.assign(points.size(), -1);
  heights_m_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = R * Eigen::Vector3f(points.x[i], points.y[i], points.z[i]);
    heights_m_[i] = p.z();
    const float distance_m = p.norm();
    const float range_m = std::sqrt(p.x() * p.x() + p.y() * p.y());
    if (!(distance_m >= min_range_m && distance_m <= max_range_m && range_m >= min_range_m)) {
      continue;
    }
    const float turn = (std::atan2(p.y(), p.x()) + kPi) / (2.0F * kPi);
    const int channel = static_cast<int>(std::floor(turn * static_cast<float>(config_.channels)));
    const int bin = static_cast<int>(
        std::floor((range_m - min_range_m) / (max_range_m - min_range_m) * static_cast<float>(config_.bins)));
    if (channel < config_.channels && bin < config_.bins) {
      cell_of_point_[i] = channel * config_.bins + bin;
      Cell& c = cell(channel, bin);
      c.lowest_m = std::min(c.lowest_m, p.z());
    }
  }
}

/// G step 3. What lies below T_hmin, and what the consistency check looks for later, stays at T_hmin.
void PolarGround::choose_heights() {
  for (Cell& c : cells_) {
    if (c.lowest_m > as_float(config_.max_height_m)) {
      c.height_m = -as_float(config_.sensor_height_m);
    } else {
      c.height_m = std::max(c.lowest_m, as_float(config_.min_height_m));
    }
  }
}

/// G step 4: a Gaussian of three samples and sigma 1 along the channel; at its ends over the samples there are.
void PolarGround::smooth_heights() {
  const float side = std::exp(-0.5F);
  for (int channel = 0; channel < config_.channels; ++channel) {
    for (int bin = 0; bin < config_.bins; ++bin) {
      float sum = cell(channel, bin).height_m;
      float weight = 1.0F;
      for (const int neighbour : {bin - 1, bin + 1}) {
        if (neighbour >= 0 && neighbour < config_.bins) {
          sum += side * cell(channel, neighbour).height_m;
          weight += side;
        }
      }
      cell(channel, bin).smoothed_m = sum / weight;
    }
  }
}

/// G step 5.
void PolarGround::compare_neighbours() {
  for (int channel = 0; channel < config_.channels; ++channel) {
    for (int bin = 0; bin < config_.bins; ++bin) {
      Cell& c = cell(channel, bin);
      c.difference_m = 0.0F;
      for (const int neighbour : {bin - 1, bin + 1}) {
        if (neighbour >= 0 && neighbour < config_.bins) {
          c.difference_m = std::max(c.difference_m, std::fabs(c.height_m - cell(channel, neighbour).height_m));
        }
      }
    }
  }
}

/// G step 6.
void PolarGround::classify_cells() {
  const float max_height_m = as_float(config_.max_height_m);
  const float max_difference_m = as_float(config_.max_difference_m);
  for (Cell& c : cells_) {
    const bool low = c.smoothed_m < max_height_m || c.height_m < max_height_m;
    c.is_ground = low && c.difference_m < max_difference_m;
    c.ground_m = c.height_m;
  }
}

/// G step 7: within a run of ground, one or two cells stuck at T_hmin between good ones take the mean of these.
void PolarGround::check_consistency() {
  const float stuck_m = as_float(config_.min_height_m);
  for (int channel = 1; channel < config_.channels - 1; ++channel) {
    for (int bin = 1; bin < config_.bins - 2; ++bin) {
      const Cell& before = cell(channel, bin - 1);
      Cell& here = cell(channel, bin);
      const Cell& next = cell(channel, bin + 1);
      const Cell& second = cell(channel, bin + 2);
      if (!(before.is_ground && here.is_ground && next.is_ground && second.is_ground) || before.height_m == stuck_m ||
          here.height_m != stuck_m) {
        continue;
      }
      if (next.height_m != stuck_m) {
        here.height_m = 0.5F * (before.height_m + next.height_m);
      } else if (second.height_m != stuck_m) {
        here.height_m = 0.5F * (before.height_m + second.height_m);
      }
      here.ground_m = here.height_m;
    }
  }
}

/// G step 8.
void PolarGround::filter_median() {
  for (int channel = 1; channel < config_.channels - 1; ++channel) {
    for (int bin = 1; bin < config_.bins - 1; ++bin) {
      Cell& here = cell(channel, bin);
      const std::array<const Cell*, 4> around = {&cell(channel, bin + 1), &cell(channel, bin - 1),
                                                 &cell(channel + 1, bin), &cell(channel - 1, bin)};
      if (here.is_ground || !std::all_of(around.begin(), around.end(), [](const Cell* c) { return c->is_ground; })) {
        continue;
      }
      std::array<float, 4> heights_m{};
      std::transform(around.begin(), around.end(), heights_m.begin(), [](const Cell* c) { return c->height_m; });
      std::sort(heights_m.begin(), heights_m.end());
      here.height_m = 0.5F * (heights_m[1] + heights_m[2]);
      here.ground_m = here.height_m;
      here.is_ground = true;
    }
  }
}

/// G step 9.
GroundCounts PolarGround::classify_points(const PointsView& points) {
  const float tolerance_m = as_float(config_.tolerance_m);
  classes_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (cell_of_point_[i] < 0) {
      classes_[i] = class_of_stray(points.x[i], points.y[i], points.z[i]);
      continue;
    }
    const Cell& c = cells_[static_cast<std::size_t>(cell_of_point_[i])];
    const bool low = c.is_ground && heights_m_[i] < c.ground_m + tolerance_m;
    classes_[i] = low ? GroundClass::ground : GroundClass::not_ground;
  }
  return count_classes(classes_);
}

GroundResult PolarGround::process(const PointsView& points, const Pose& T_base_sensor) {
  map_points(points, T_base_sensor);
  choose_heights();
  smooth_heights();
  compare_neighbours();
  classify_cells();
  check_consistency();
  filter_median();
  const GroundCounts counts = classify_points(points);
  return {.classes = classes_, .surface = nullptr, .counts = counts};
}

}  // namespace berm
