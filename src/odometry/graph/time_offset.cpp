#include "time_offset.hpp"

#include <algorithm>
#include <cmath>

#include "rotations.hpp"
#include "seen_fixes.hpp"

namespace berm {
namespace {

/// More fixes do not make it better, only slower.
constexpr std::size_t kFixes = 3000;
constexpr double kCoarse_s = 0.1;
constexpr double kFine_s = 0.001;
/// Fixes farther off say nothing of the time: these are jumps.
constexpr double kCap_m = 2.0;
/// An attitude of a fix is as good as a position of this sigma for every radian: 0.01 rad for 3 cm.
constexpr double kMetresPerRad = 3.0;
/// The sum of squares has to fall by so many times the noise of one fix, and by this share of that of all.
constexpr double kOffsetFacts = 40.0;
constexpr double kShare = 0.02;
/// What the odometry itself is off within a window, one sigma.
constexpr double kOdometry_m = 0.02;

class OffsetSearch {
 public:
  OffsetSearch(std::span<const OdometryStep> odometry, std::span<const double> path_m, std::span<const Fix> fixes,
               std::span<const std::size_t> chosen, const PoseGraphConfig& config)
      : odometry_(odometry), path_m_(path_m), fixes_(fixes), config_(config), clock_(odometry) {
    // Those near the ends would come and go with the offset, and the sum with them.
    const Stamp margin_ns = from_seconds(config.max_time_offset_s);
    std::vector<std::size_t> inner;
    for (const std::size_t i : chosen) {
      const auto early = clock_.at(fixes[i].stamp_ns - margin_ns);
      const auto late = clock_.at(fixes[i].stamp_ns + margin_ns);
      if (early && late && odometry[early->step].session == odometry[late->step].session) {
        inner.push_back(i);
      }
    }
    const std::size_t stride = std::max<std::size_t>(1, inner.size() / kFixes);
    for (std::size_t k = 0; k < inner.size(); k += stride) {
      chosen_.push_back(inner[k]);
    }
  }

  [[nodiscard]] bool empty() const { return chosen_.empty(); }

  struct Score {
    double sum_m2 = 0.0;  ///< of squared distances, capped
    double median_m = 0.0;
    double count = 0.0;
  };
  [[nodiscard]] Score score(double offset_s) const {
    const std::vector<SeenFix> seen = see_fixes(clock_, fixes_, chosen_, offset_s, config_);
    Score result;
    std::vector<double> distances_m;
    for (const FixWindow& window : cut_windows(seen, odometry_, path_m_)) {
      const auto part = std::span(seen).subspan(window.first, window.count);
      const WindowFit fit = fit_window(part, fixes_);
      for (const SeenFix& one : part) {
        distances_m.push_back((fit.T_world_odom * one.antenna_odom_m - one.position_m).norm());
        result.sum_m2 += std::pow(std::min(distances_m.back(), kCap_m), 2);
        const auto attitude = attitude_of(fixes_[one.fix]);
        if (attitude && std::isfinite(fixes_[one.fix].tilt_sigma_rad)) {
          const Eigen::Quaterniond off =
              attitude->conjugate() * fit.T_world_odom.rotation() * one.T_odom_base.rotation();
          result.sum_m2 += std::pow(std::min(kMetresPerRad * rotation_log(off).norm(), kCap_m), 2);
        }
      }
    }
    if (!distances_m.empty()) {
      const auto middle = distances_m.begin() + static_cast<std::ptrdiff_t>(distances_m.size() / 2);
      std::nth_element(distances_m.begin(), middle, distances_m.end());
      result.median_m = *middle;
      result.count = static_cast<double>(distances_m.size());
    }
    return result;
  }

 private:
  std::span<const OdometryStep> odometry_;
  std::span<const double> path_m_;
  std::span<const Fix> fixes_;
  const PoseGraphConfig& config_;
  OdometryClock clock_;
  std::vector<std::size_t> chosen_;
};

/// What exact fixes of the odometry's own path would say.
std::vector<Fix> fixes_on_path(std::span<const OdometryStep> odometry, std::span<const Fix> fixes,
                               const PoseGraphConfig& config) {
  const OdometryClock clock(odometry);
  const Eigen::Vector3d antenna_m(config.antenna_x_m, config.antenna_y_m, config.antenna_z_m);
  std::vector<Fix> driven(fixes.begin(), fixes.end());
  for (Fix& fix : driven) {
    const auto place = clock.at(fix.stamp_ns);
    if (place) {
      fix.position_m = place->T_odom_base * antenna_m;
      fix.R_world_base = attitude_of(fix) ? std::optional(place->T_odom_base.rotation()) : std::nullopt;
    }
  }
  return driven;
}

}  // namespace

TimeOffset find_time_offset(std::span<const OdometryStep> odometry, std::span<const double> path_m,
                            std::span<const Fix> fixes, std::span<const std::size_t> chosen,
                            const PoseGraphConfig& config) {
  const OffsetSearch search(odometry, path_m, fixes, chosen, config);
  if (search.empty()) {
    return {};
  }
  const OffsetSearch::Score as_stamped = search.score(0.0);
  const int steps = static_cast<int>(std::round(config.max_time_offset_s / kCoarse_s));
  double best_s = 0.0;
  double best_m2 = as_stamped.sum_m2;
  const auto attempt = [&](double offset_s) {
    const double sum_m2 = search.score(offset_s).sum_m2;
    if (sum_m2 < best_m2) {
      best_m2 = sum_m2;
      best_s = offset_s;
    }
  };
  for (int i = 1; i <= steps; ++i) {
    const double offset_s = config.max_time_offset_s * i / steps;
    attempt(offset_s);
    attempt(-offset_s);
  }
  const double coarse_s = best_s;
  for (double step_s = 0.5 * kCoarse_s; step_s > kFine_s; step_s *= 0.5) {
    const double center_s = best_s;
    attempt(std::max(center_s - step_s, -config.max_time_offset_s));
    attempt(std::min(center_s + step_s, config.max_time_offset_s));
  }
  const OffsetSearch::Score best = search.score(best_s);
  // On an even drive any offset fits, and the drift of the odometry picks one: the offset must change the shape of the
  // path by more than what the fixes are off it anyway.
  const std::vector<Fix> driven = fixes_on_path(odometry, fixes, config);
  const double change_m2 = OffsetSearch(odometry, path_m, driven, chosen, config).score(best_s).sum_m2;
  TimeOffset result{.as_stamped_m = as_stamped.median_m};
  const double noise_m2 = std::pow(std::max(best.median_m, kOdometry_m), 2);
  if (change_m2 > best.sum_m2 && as_stamped.sum_m2 - best.sum_m2 > noise_m2 * (kShare * best.count + kOffsetFacts)) {
    result.offset_s = best_s;
    result.is_at_border =
        std::abs(coarse_s) > config.max_time_offset_s - 0.5 * kCoarse_s && std::abs(best_s) > std::abs(coarse_s) - 0.01;
  }
  result.residual_m = result.offset_s == 0.0 ? as_stamped.median_m : best.median_m;
  return result;
}

}  // namespace berm
