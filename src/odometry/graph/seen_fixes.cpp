#include "seen_fixes.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/SVD>

namespace berm {
namespace {

/// On so long a way a drift of 0.5 % is 15 cm, which bends no fit.
constexpr double kWindow_m = 30.0;
constexpr std::size_t kMostInWindow = 400;
constexpr double kWindow_s = 60.0;
/// Standing machines are upright to this, one sigma: pistes are steep. It only has to be there.
constexpr double kSeenUpright_rad = 0.3;
/// An odometry drifts by this within a window; fixes that are better than that fit no better.
constexpr double kSeenDrift_m = 0.03;
constexpr int kSeenRounds = 6;
/// Fixes scatter about so long a base, or they say nothing of the heading.
constexpr double kShortestBase_m = 1.0;

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// One weighted fit: Kabsch 1976, with attitudes as vectors more.
class RigidFit {
 public:
  RigidFit(std::span<const SeenFix> window, std::span<const Fix> fixes) : window_(window), fixes_(fixes) {}

  [[nodiscard]] Pose fit(std::span<const double> weights) {
    Eigen::Vector3d odom_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d world_m = Eigen::Vector3d::Zero();
    double sum = 0.0;
    for (std::size_t i = 0; i < window_.size(); ++i) {
      odom_m += weights[i] * window_[i].antenna_odom_m;
      world_m += weights[i] * window_[i].position_m;
      sum += weights[i];
    }
    odom_m /= sum;
    world_m /= sum;
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    spread_m2_ = 0.0;
    for (std::size_t i = 0; i < window_.size(); ++i) {
      const SeenFix& seen = window_[i];
      moments += weights[i] * (seen.position_m - world_m) * (seen.antenna_odom_m - odom_m).transpose();
      spread_m2_ += weights[i] / sum * (seen.antenna_odom_m - odom_m).squaredNorm();
    }
    moments += attitudes(weights);
    Eigen::JacobiSVD<Eigen::Matrix3d> svd(moments, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Vector3d mirror = Eigen::Vector3d::Ones();
    mirror.z() = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    const Eigen::Matrix3d R = svd.matrixU() * mirror.asDiagonal() * svd.matrixV().transpose();
    return {Eigen::Quaterniond(R), world_m - R * odom_m};
  }
  [[nodiscard]] double spread_m2() const { return spread_m2_; }
  [[nodiscard]] bool has_attitude() const { return has_attitude_; }

 private:
  /// Attitudes weigh against positions as their sigmas do, up to how sure the odometry's own are.
  [[nodiscard]] Eigen::Matrix3d attitudes(std::span<const double> weights) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
    const double n = static_cast<double>(window_.size());
    has_attitude_ = false;
    for (std::size_t i = 0; i < window_.size(); ++i) {
      const SeenFix& seen = window_[i];
      const Eigen::Matrix3d R_odom_base = seen.T_odom_base.rotation().toRotationMatrix();
      sum += up * (R_odom_base * up).transpose() / (kSeenUpright_rad * kSeenUpright_rad * n);
      const auto attitude = attitude_of(fixes_[seen.fix]);
      const double heading_rad = fixes_[seen.fix].heading_sigma_rad;
      const double tilt_rad = fixes_[seen.fix].tilt_sigma_rad;
      if (!attitude || !std::isfinite(heading_rad)) {
        continue;
      }
      has_attitude_ = true;
      const Eigen::Matrix3d R_world_base = attitude->toRotationMatrix();
      const double weight = std::min(weights[i] * kSeenDrift_m * kSeenDrift_m, 1.0);
      if (std::isfinite(tilt_rad)) {
        const double sigma_rad = std::max(heading_rad, tilt_rad);
        sum += weight / (sigma_rad * sigma_rad) * R_world_base * R_odom_base.transpose();
      } else {
        const Eigen::Vector3d ahead = Eigen::Vector3d::UnitX();
        sum +=
            weight / (kSeenUpright_rad * kSeenUpright_rad) * (R_world_base * ahead) * (R_odom_base * ahead).transpose();
      }
    }
    return sum;
  }

  std::span<const SeenFix> window_;
  std::span<const Fix> fixes_;
  double spread_m2_ = 0.0;
  bool has_attitude_ = false;
};

}  // namespace

bool is_finite(const Fix& fix) {
  return fix.position_m.allFinite() && fix.sigma_m.allFinite() && fix.sigma_m.minCoeff() > 0.0;
}

std::optional<Eigen::Quaterniond> attitude_of(const Fix& fix) {
  if (!fix.R_world_base || !fix.R_world_base->coeffs().allFinite() || !(fix.tilt_sigma_rad > 0.0) ||
      !(fix.heading_sigma_rad > 0.0)) {
    return std::nullopt;
  }
  const double norm = fix.R_world_base->norm();
  if (std::abs(norm - 1.0) > 0.1) {
    return std::nullopt;
  }
  return fix.R_world_base->normalized();
}

std::vector<SeenFix> see_fixes(const OdometryClock& clock, std::span<const Fix> fixes,
                               std::span<const std::size_t> chosen, double offset_s, const PoseGraphConfig& config) {
  const Eigen::Vector3d antenna_m(config.antenna_x_m, config.antenna_y_m, config.antenna_z_m);
  const Stamp offset_ns = from_seconds(offset_s);
  std::vector<SeenFix> seen;
  for (const std::size_t i : chosen) {
    const auto place = clock.at(fixes[i].stamp_ns + offset_ns);
    if (place) {
      seen.push_back({i, place->step, fixes[i].stamp_ns + offset_ns, place->T_odom_base, place->T_odom_base * antenna_m,
                      fixes[i].position_m, fixes[i].sigma_m.norm() / std::sqrt(3.0)});
    }
  }
  return seen;
}

std::vector<FixWindow> cut_windows(std::span<const SeenFix> seen, std::span<const OdometryStep> odometry,
                                   std::span<const double> path_m) {
  std::vector<FixWindow> windows;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const std::size_t step = seen[i].step;
    const std::size_t first = windows.empty() ? step : seen[windows.back().first].step;
    if (windows.empty() || path_m[step] - path_m[first] > kWindow_m || windows.back().count >= kMostInWindow ||
        to_seconds(odometry[step].stamp_ns - odometry[first].stamp_ns) > kWindow_s ||
        odometry[step].session != odometry[first].session) {
      windows.push_back({i, 0});
    }
    ++windows.back().count;
  }
  return windows;
}

bool WindowFit::has_heading() const {
  return has_attitude || (base_m >= kShortestBase_m && base_m > 5.0 * residual_m);
}

WindowFit fit_window(std::span<const SeenFix> window, std::span<const Fix> fixes) {
  std::vector<double> own(window.size());
  std::vector<double> distances_m(window.size());
  for (std::size_t i = 0; i < window.size(); ++i) {
    own[i] = 1.0 / (window[i].sigma_m * window[i].sigma_m + kSeenDrift_m * kSeenDrift_m);
  }
  RigidFit rigid(window, fixes);
  std::vector<double> weights = own;
  WindowFit result;
  for (int round = 0; round < kSeenRounds; ++round) {
    result.T_world_odom = rigid.fit(weights);
    for (std::size_t i = 0; i < window.size(); ++i) {
      distances_m[i] = (result.T_world_odom * window[i].antenna_odom_m - window[i].position_m).norm();
    }
    result.residual_m = median(distances_m);
    // Geman and McClure 1987, its scale from the scatter itself.
    const double scale_m2 = std::pow(2.0 * result.residual_m, 2) + kSeenDrift_m * kSeenDrift_m;
    for (std::size_t i = 0; i < window.size(); ++i) {
      const double share = scale_m2 / (scale_m2 + distances_m[i] * distances_m[i]);
      weights[i] = own[i] * share * share;
    }
  }
  for (const double distance_m : distances_m) {
    result.mean_m += distance_m / static_cast<double>(window.size());
  }
  result.base_m = std::sqrt(rigid.spread_m2());
  result.has_attitude = rigid.has_attitude();
  if (!result.has_heading()) {
    // Noise would turn it. The frame of the odometry is no worse.
    Eigen::Vector3d move_m = Eigen::Vector3d::Zero();
    for (const SeenFix& seen : window) {
      move_m += (seen.position_m - seen.antenna_odom_m) / static_cast<double>(window.size());
    }
    result.T_world_odom = Pose(Eigen::Quaterniond::Identity(), move_m);
  }
  return result;
}

}  // namespace berm
