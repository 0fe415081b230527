#include "feature_finder.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "scenery.hpp"

namespace berm {
namespace {

/// An edge stands before what is behind it, and goes on to one side at least: there the squares of the ranges differ by
/// less than this share (LOAM-Livox).
constexpr double kEdgeStep = 0.1;
/// Times beyond this are no times within a scan.
constexpr double kLongestScan_s = 10.0;

FeatureClass class_of(Label label, bool edge, bool with_labels) {
  if (with_labels && label == Label::drivable) {
    return edge ? FeatureClass::piste_edge : FeatureClass::piste_plane;
  }
  return edge ? FeatureClass::obstacle_edge : FeatureClass::obstacle_plane;
}

/// Whether the middle of `series_m` is the near side of a step, and no lone point.
bool is_near_side(std::span<const Eigen::Vector3d> series_m) {
  const double range_m2 = series_m[series_m.size() / 2].squaredNorm();
  const double before_m2 = series_m.front().squaredNorm();
  const double after_m2 = series_m.back().squaredNorm();
  return range_m2 <= before_m2 && range_m2 <= after_m2 &&
         std::min(before_m2, after_m2) - range_m2 < kEdgeStep * range_m2;
}

/// Cosine of the angle between the beam and the surface along the trace.
double cosine_of_view(std::span<const Eigen::Vector3d> series_m) {
  const Eigen::Vector3d along_m = series_m.back() - series_m.front();
  const Eigen::Vector3d& beam_m = series_m[series_m.size() / 2];
  const double lengths_m2 = along_m.norm() * beam_m.norm();
  return lengths_m2 > 0.0 ? std::abs(along_m.dot(beam_m)) / lengths_m2 : 1.0;
}

}  // namespace

double curvature_of(std::span<const Eigen::Vector3d> series_m) {
  const Eigen::Vector3d& middle_m = series_m[series_m.size() / 2];
  Eigen::Vector3d sum_m = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point_m : series_m) {
    sum_m += middle_m - point_m;  // the middle one itself adds nothing
  }
  return sum_m.norm() / (static_cast<double>(series_m.size() - 1) * middle_m.norm());
}

const std::vector<Feature>& FeatureFinder::process(const OdometryInput& input, const FeatureOdometryConfig& config) {
  features_.clear();
  order_by_laser(input.points);
  const std::size_t width = 2 * static_cast<std::size_t>(config.neighbours) + 1;
  const PointsView& points = input.points;
  series_m_.clear();
  for (std::size_t i = 0; i < order_.size(); ++i) {
    const std::size_t index = order_[i];
    const bool other_laser = i > 0 && !points.ring.empty() && points.ring[order_[i - 1]] != points.ring[index];
    const Eigen::Vector3d sensor_m(points.x[index], points.y[index], points.z[index]);
    const bool usable = is_scenery(input.labels[index]) && sensor_m.allFinite() && sensor_m.squaredNorm() > 0.0;
    if (other_laser || !usable) {
      series_m_.clear();
    }
    if (!usable) {
      continue;
    }
    series_m_.push_back(sensor_m);
    if (series_m_.size() >= width) {
      collect(input, std::span(series_m_).last(width), order_[i - width / 2], config);
    }
  }
  if (config.variant == "four_classes_capped") {
    limit_piste_planes(static_cast<std::size_t>(config.max_piste_planes));
  }
  return features_;
}

/// Neighbours are beams of one laser, one after the other. P's sensor has one; of one with rings, each is a series.
void FeatureFinder::order_by_laser(const PointsView& points) {
  order_.resize(points.size());
  std::iota(order_.begin(), order_.end(), 0U);
  if (!points.ring.empty()) {
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return points.ring[a] < points.ring[b]; });
  }
}

void FeatureFinder::collect(const OdometryInput& input, std::span<const Eigen::Vector3d> series_m, std::size_t middle,
                            const FeatureOdometryConfig& config) {
  const Eigen::Vector3d& sensor_m = series_m[series_m.size() / 2];
  const double range_m = sensor_m.norm();
  const double time_s = input.points.time.empty() ? 0.0 : static_cast<double>(input.points.time[middle]);
  if (range_m < config.min_range_m || !(time_s >= 0.0 && time_s <= kLongestScan_s)) {
    return;
  }
  const double curvature = curvature_of(series_m);
  const double max_cosine = std::cos(config.min_view_angle_deg * std::numbers::pi / 180.0);
  const bool edge = curvature > config.edge_curvature && range_m < config.max_edge_range_m && is_near_side(series_m);
  // LOAM-Livox asks the angle of edges too. Across a step it is that of no surface, and would leave no edge at all.
  const bool plane = curvature < config.plane_curvature && cosine_of_view(series_m) <= max_cosine;
  if (edge || plane) {
    features_.push_back({.base_m = input.T_base_sensor * sensor_m,
                         .time_s = time_s,
                         .curvature = curvature,
                         .kind = class_of(input.labels[middle], edge, config.variant != "one_class")});
  }
}

/// Those of the smallest curvature stay (P section 3); of equal ones the first.
void FeatureFinder::limit_piste_planes(std::size_t count) {
  const auto is_piste_plane = [](const Feature& feature) { return feature.kind == FeatureClass::piste_plane; };
  curvatures_.clear();
  for (const Feature& feature : features_) {
    if (is_piste_plane(feature)) {
      curvatures_.push_back(feature.curvature);
    }
  }
  if (curvatures_.size() <= count) {
    return;
  }
  const auto last = curvatures_.begin() + static_cast<std::ptrdiff_t>(count - 1);
  std::nth_element(curvatures_.begin(), last, curvatures_.end());
  const double limit = *last;
  auto equal = count - static_cast<std::size_t>(std::count_if(curvatures_.begin(), curvatures_.end(),
                                                              [limit](double value) { return value < limit; }));
  std::erase_if(features_, [&](const Feature& feature) {
    if (!is_piste_plane(feature) || feature.curvature < limit) {
      return false;
    }
    if (feature.curvature > limit || equal == 0) {
      return true;
    }
    --equal;
    return false;
  });
}

}  // namespace berm
