#include "level_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

#include "berm/core/multiversion.hpp"
#include "berm/geometry/plane_fit.hpp"

namespace berm {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector3f;

/// Low points are the lowest of square cells of 2 m within 20 m: large enough to see past a car, and few.
constexpr float kCell_m = 2.0F;
constexpr float kReach_m = 20.0F;
constexpr int kCells = 20;  // a side: 2 * kReach_m / kCell_m

/// The lowest points come from about this many points: the plane does not need more.
constexpr std::size_t kSamples = 16384;

constexpr std::size_t kMinLowPoints = 10;
constexpr int kHypotheses = 400;
constexpr int kRefinements = 3;

/// Share of the weight of all low points that a plane loses at most for a wrong sensor height; half of it where it is
/// off by 30 %.
constexpr float kHeightPrior = 0.1F;
constexpr float kHeightPriorSpread = 0.3F;
/// A low point at this distance counts half as much as one right at the sensor: it is the ground under the machine that
/// the terrain is followed from. The sides of a bowl would win otherwise, since there is so much of them.
constexpr float kNear_m = 6.0F;
/// What a low point below the plane costs: nothing is below the ground but reflections, so ground is seldom above it.
constexpr float kBelowPenalty = 0.5F;
/// Least height of the sensor above the ground, and least area that three low points must span (twice, in m^2).
constexpr float kMinHeight_m = 0.3F;
constexpr float kMinSpan_m2 = 4.0F;

/// Every stride-th point is looked at. A prime, so that no number of lasers divides it and rings are lost.
std::size_t stride_for(std::size_t points) {
  constexpr std::array<std::size_t, 12> kPrimes = {1, 3, 7, 11, 13, 17, 29, 61, 127, 251, 509, 1021};
  for (const std::size_t prime : kPrimes) {
    if (points / prime <= kSamples) {
      return prime;
    }
  }
  return points / kSamples;
}

/// Weighted sum over the low points of 1 - (distance / tolerance)^2, less a penalty for each that lies below. Eight
/// partial sums in a fixed order, so that the compiler may use wide registers and the result stays the same.
BERM_MULTIVERSION
float sum_scores(const float* __restrict x, const float* __restrict y, const float* __restrict z,
                 const float* __restrict tolerance_m, const float* __restrict weight, std::size_t count, float nx,
                 float ny, float nz, float height_m) {
  constexpr std::size_t kLanes = 8;
  std::array<float, kLanes> sums{};
  const std::size_t whole = count - count % kLanes;
  for (std::size_t i = 0; i < whole; i += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const std::size_t k = i + lane;
      const float distance = nx * x[k] + ny * y[k] + nz * z[k] + height_m;
      const float relative = distance / tolerance_m[k];
      const float fit = 1.0F - relative * relative;
      const float miss = distance < 0.0F ? -kBelowPenalty : 0.0F;
      sums[lane] += weight[k] * (fit > 0.0F ? fit : miss);
    }
  }
  float sum = 0.0F;
  for (const float part : sums) {
    sum += part;
  }
  return sum;
}

/// A small linear congruential generator (Numerical Recipes): the same hypotheses for every scan.
class Dice {
 public:
  std::size_t below(std::size_t count) {
    state_ = state_ * 1664525U + 1013904223U;
    return (static_cast<std::size_t>(state_ >> 8U) * count) >> 24U;
  }

 private:
  std::uint32_t state_ = 12345U;
};

/// The frame on the plane, its x axis as near to the sensor's as the plane allows.
Pose level_frame(const Vector3d& normal_sensor, double height_m) {
  const Vector3d x = (Vector3d::UnitX() - normal_sensor.x() * normal_sensor).normalized();
  Matrix3d R_level_sensor;
  R_level_sensor.row(0) = x;
  R_level_sensor.row(1) = normal_sensor.cross(x);
  R_level_sensor.row(2) = normal_sensor;
  Eigen::Matrix<double, 3, 4> matrix;
  matrix << R_level_sensor, Vector3d(0.0, 0.0, height_m);
  return Pose::from_matrix(matrix);
}

}  // namespace

void LevelPlaneFinder::collect_low_points(const PointsView& points, const Eigen::Matrix3f& R_base_sensor,
                                          float min_range_m) {
  constexpr float kNone = std::numeric_limits<float>::infinity();
  const Vector3f none(0.0F, 0.0F, kNone);
  lowest_.assign(static_cast<std::size_t>(kCells * kCells), {none, none});
  const std::size_t stride = stride_for(points.size());
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const Vector3f p = R_base_sensor * Vector3f(points.x[i], points.y[i], points.z[i]);
    const float range2 = p.x() * p.x() + p.y() * p.y();
    if (!(range2 >= min_range_m * min_range_m && range2 < kReach_m * kReach_m && range2 > 0.0F)) {
      continue;
    }
    const int column = static_cast<int>((p.x() + kReach_m) / kCell_m);
    const int row = static_cast<int>((p.y() + kReach_m) / kCell_m);
    LowPoints& low =
        lowest_[static_cast<std::size_t>(std::min(row, kCells - 1) * kCells + std::min(column, kCells - 1))];
    if (p.z() < low.first.z()) {
      low.second = low.first;
      low.first = p;
    } else if (p.z() < low.second.z()) {
      low.second = p;
    }
  }
  x_.clear(), y_.clear(), z_.clear(), tolerance_m_.clear(), weight_.clear();
  weight_sum_ = 0.0F;
  for (const LowPoints& cell : lowest_) {
    // The second lowest: a lone reflection from below the ground does no harm.
    const Vector3f& low = cell.second;
    if (low.z() < kNone) {
      x_.push_back(low.x()), y_.push_back(low.y()), z_.push_back(low.z());
      // Near: what a rough ground shows. Farther out a hill or a hollow leaves its tangent plane.
      tolerance_m_.push_back(0.1F + 0.04F * std::hypot(low.x(), low.y()));
      weight_.push_back(1.0F / (1.0F + (low.x() * low.x() + low.y() * low.y()) / (kNear_m * kNear_m)));
      weight_sum_ += weight_.back();
    }
  }
}

float LevelPlaneFinder::score(const Plane& plane) const {
  return sum_scores(x_.data(), y_.data(), z_.data(), tolerance_m_.data(), weight_.data(), x_.size(), plane.normal.x(),
                    plane.normal.y(), plane.normal.z(), plane.height_m);
}

LevelPlaneFinder::Plane LevelPlaneFinder::best_plane(float mount_height_m, float min_up) const {
  const auto low_point = [this](std::size_t i) { return Vector3f(x_[i], y_[i], z_[i]); };
  Plane best{Vector3f::UnitZ(), mount_height_m};
  float best_score = -std::numeric_limits<float>::infinity();
  Dice dice;
  for (int i = 0; i < kHypotheses; ++i) {
    const Vector3f a = low_point(dice.below(x_.size()));
    const Vector3f b = low_point(dice.below(x_.size()));
    const Vector3f c = low_point(dice.below(x_.size()));
    const Vector3f cross = (b - a).cross(c - a);
    const float span = cross.norm();
    if (span < kMinSpan_m2) {
      continue;
    }
    const Vector3f normal = cross / (cross.z() < 0.0F ? -span : span);
    const Plane plane{normal, -normal.dot(a)};
    if (!(normal.z() >= min_up && plane.height_m >= kMinHeight_m)) {  // negated, so that NaN is refused
      continue;
    }
    float plane_score = score(plane);
    if (mount_height_m > 0.0F) {
      const float off = (plane.height_m / mount_height_m - 1.0F) / kHeightPriorSpread;
      plane_score -= kHeightPrior * weight_sum_ * off * off / (1.0F + off * off);
    }
    if (plane_score > best_score) {
      best_score = plane_score;
      best = plane;
    }
  }
  return best;
}

/// Least squares over the low points near the plane, weighted by nearness and after Cauchy, as long as it leans no more
/// than allowed.
void LevelPlaneFinder::refine(Plane& plane, float min_up) const {
  for (int i = 0; i < kRefinements; ++i) {
    Moments moments;
    for (std::size_t k = 0; k < x_.size(); ++k) {
      const Vector3f p(x_[k], y_[k], z_[k]);
      const float relative = (plane.normal.dot(p) + plane.height_m) / tolerance_m_[k];
      if (std::fabs(relative) < 1.0F) {
        moments.add(p.cast<double>(), static_cast<double>(weight_[k] / (1.0F + 4.0F * relative * relative)));
      }
    }
    const std::optional<PlaneFit> fit = fit_plane(moments);
    if (!fit || fit->normal.z() < static_cast<double>(min_up)) {
      return;
    }
    plane.normal = fit->normal.cast<float>();
    plane.height_m = static_cast<float>(-fit->normal.dot(fit->centroid_m));
  }
}

/// How well the low points fit the plane, and how near they come.
LevelPlane LevelPlaneFinder::judge(const Plane& plane, const Matrix3d& R_base_sensor) const {
  double sum_m2 = 0.0;
  double nearest_m2 = static_cast<double>(kReach_m * kReach_m);
  std::size_t count = 0;
  for (std::size_t k = 0; k < x_.size(); ++k) {
    const Vector3f p(x_[k], y_[k], z_[k]);
    const double distance_m = static_cast<double>(plane.normal.dot(p) + plane.height_m);
    if (std::fabs(distance_m) < static_cast<double>(tolerance_m_[k])) {
      sum_m2 += distance_m * distance_m;
      nearest_m2 = std::min(
          nearest_m2, static_cast<double>(p.squaredNorm()) - static_cast<double>(plane.height_m * plane.height_m));
      ++count;
    }
  }
  const Vector3d normal_sensor = (R_base_sensor.transpose() * plane.normal.cast<double>()).normalized();
  return {.T_level_sensor = level_frame(normal_sensor, static_cast<double>(plane.height_m)),
          .rms_m = count > 0 ? std::sqrt(sum_m2 / static_cast<double>(count)) : 0.0,
          .nearest_m = std::sqrt(std::max(0.0, nearest_m2)),
          .found = true};
}

LevelPlane LevelPlaneFinder::find(const PointsView& points, const Pose& T_base_sensor,
                                  const TerrainGroundConfig& config) {
  const Matrix3d R_base_sensor = T_base_sensor.rotation().toRotationMatrix();
  const double mount_height_m = std::max(0.0, T_base_sensor.translation_m().z());
  const LevelPlane by_mount{.T_level_sensor = level_frame(R_base_sensor.row(2).transpose(), mount_height_m)};
  if (!config.level) {
    return by_mount;
  }
  collect_low_points(points, R_base_sensor.cast<float>(), static_cast<float>(config.min_range_m));
  if (x_.size() < kMinLowPoints) {
    return by_mount;
  }
  const auto min_up = static_cast<float>(std::cos(config.max_tilt_deg * std::numbers::pi / 180.0));
  Plane plane = best_plane(static_cast<float>(mount_height_m), min_up);
  refine(plane, min_up);
  return judge(plane, R_base_sensor);
}

}  // namespace berm
