#include "way_ahead.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Geometry>

namespace berm {
namespace {

// P section 2.2: the slope ahead is that between 10 and 40 m.
constexpr double kSlopeFrom_m = 10.0;
constexpr double kSlopeTo_m = 40.0;
constexpr double kMinStretch_m = 5.0;
constexpr double kMaxSigma_rad = 0.05;
// Windows of one trace err together: about this many of them count as one.
constexpr double kCorrelated = 4.0;
constexpr double kTilt_rad = 0.005;  // of the level frame itself

constexpr double kStep_m = 0.5;
constexpr int kMinPoints = 3;

}  // namespace

std::optional<SlopeAhead> find_slope_ahead(const PisteSurface& surface, const Pose& T_base_level, double piste_ends_m) {
  const double far_m = std::min(kSlopeTo_m, piste_ends_m);
  const double stretch_m = far_m - kSlopeFrom_m;
  if (!(stretch_m >= kMinStretch_m)) {
    return std::nullopt;
  }
  const Eigen::Matrix3d R_base_level = T_base_level.rotation().toRotationMatrix();
  const Eigen::Vector2d ahead = R_base_level.row(0).head<2>().transpose().normalized();
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  const double middle_m = 0.5 * (kSlopeFrom_m + far_m);
  const PisteSurface::Terms along = (PisteSurface::height_terms(far_m * ahead.x(), far_m * ahead.y()) -
                                     PisteSurface::height_terms(kSlopeFrom_m * ahead.x(), kSlopeFrom_m * ahead.y())) /
                                    stretch_m;
  const PisteSurface::Terms across =
      PisteSurface::slope_terms(middle_m * ahead.x(), middle_m * ahead.y(), left.x(), left.y());
  SlopeAhead result;
  result.slope_sigma_rad = std::sqrt(kCorrelated * surface.variance(along) + kTilt_rad * kTilt_rad);
  result.cross_fall_sigma_rad = std::sqrt(kCorrelated * surface.variance(across) + kTilt_rad * kTilt_rad);
  if (!(result.slope_sigma_rad < kMaxSigma_rad)) {
    return std::nullopt;
  }
  const Eigen::Vector2d gradient = surface.value(along) * ahead + surface.value(across) * left;
  const Eigen::Vector3d normal = R_base_level * Eigen::Vector3d(-gradient.x(), -gradient.y(), 1.0);
  result.slope_rad = std::atan2(-normal.x(), normal.z());
  if (result.cross_fall_sigma_rad < kMaxSigma_rad) {
    result.cross_fall_rad = std::atan2(-normal.y(), normal.z());
  }
  return result;
}

ObstacleAhead::ObstacleAhead(const BoundaryPisteConfig& config)
    : config_(config), counts_(static_cast<std::size_t>(config.max_range_m / kStep_m) + 2) {}

std::optional<double> ObstacleAhead::find(std::span<const std::uint32_t> obstacles, const LevelPoints& level,
                                          const PisteSurface& surface, const Pose& T_base_level) {
  std::fill(counts_.begin(), counts_.end(), 0);
  const Eigen::Matrix3f r = T_base_level.rotation().toRotationMatrix().cast<float>();
  const Eigen::Vector3f t = T_base_level.translation_m().cast<float>();
  const auto half_width = static_cast<float>(0.5 * config_.machine_width_m);
  const auto clearance = static_cast<float>(config_.machine_height_m);
  const auto farthest = static_cast<float>(config_.max_range_m);
  for (const std::uint32_t i : obstacles) {
    const float y = r(1, 0) * level.x[i] + r(1, 1) * level.y[i] + r(1, 2) * level.z[i] + t.y();
    const float x = r(0, 0) * level.x[i] + r(0, 1) * level.y[i] + r(0, 2) * level.z[i] + t.x();
    if (std::abs(y) < half_width && x > 0.0F && x < farthest &&
        level.z[i] - surface.height_m(level.x[i], level.y[i]) < clearance) {
      ++counts_[static_cast<std::size_t>(x / static_cast<float>(kStep_m))];
    }
  }
  for (std::size_t step = 0; step + 1 < counts_.size(); ++step) {
    if (counts_[step] > 0 && counts_[step] + counts_[step + 1] >= kMinPoints) {
      return static_cast<double>(step) * kStep_m;
    }
  }
  return std::nullopt;
}

}  // namespace berm
