#include "registration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/sized_cost_function.h>
#include <ceres/solver.h>

namespace berm {
namespace {

// LOAM-Livox' own numbers, where nothing else is said.
constexpr int kFirstSteps = 2;
constexpr int kMaxSteps = 50;
constexpr double kStill_m = 0.01;
constexpr double kStill_rad = 0.01 * std::numbers::pi / 180.0;
/// Ours: six unknowns need more than a handful of residuals.
constexpr std::size_t kLeastMatches = 30;

/// One residual, as Ceres wants it.
class MatchCost final : public ceres::SizedCostFunction<1, 6> {
 public:
  explicit MatchCost(const FeatureMatch& match) : match_(match) {}

  bool Evaluate(const double* const* parameters, double* residuals, double** jacobians) const override {
    const Displacement displacement = Eigen::Map<const Displacement>(parameters[0]);
    Vector6d gradient;
    const bool wants_gradient = jacobians != nullptr && jacobians[0] != nullptr;
    residuals[0] = residual_m(match_, displacement, wants_gradient ? &gradient : nullptr);
    if (wants_gradient) {
      std::copy(gradient.data(), gradient.data() + gradient.size(), jacobians[0]);
    }
    return true;
  }

 private:
  FeatureMatch match_;
};

/// Solves from `displacement` on. Returns the steps that were taken; none if the solver failed.
std::size_t solve(const std::vector<FeatureMatch>& matches, int max_steps, double huber_m, Displacement& displacement) {
  std::vector<MatchCost> costs(matches.begin(), matches.end());
  ceres::HuberLoss loss(huber_m);
  ceres::Problem::Options ownership;
  ownership.cost_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.disable_all_safety_checks = true;
  ceres::Problem problem(ownership);
  Displacement solution = displacement;
  problem.AddParameterBlock(solution.data(), 6);
  for (MatchCost& cost : costs) {
    problem.AddResidualBlock(&cost, &loss, solution.data());
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = max_steps;
  options.num_threads = 1;  // sums in a fixed order
  options.max_solver_time_in_seconds = std::numeric_limits<double>::infinity();
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable() || !solution.allFinite()) {
    return 0;
  }
  displacement = solution;
  return summary.iterations.size();
}

/// The features and their surfaces in the map, in the frame of the known pose.
std::vector<FeatureMatch> find_matches(const std::vector<TimedFeature>& features, const FeatureMap& map,
                                       const Pose& T_world_before, const Displacement& displacement) {
  std::vector<FeatureMatch> matches;
  const Pose T_before_world = T_world_before.inverse();
  for (const TimedFeature& feature : features) {
    const Eigen::Vector3d before_m = displaced_m(displacement, feature.base_m, feature.share);
    const auto surface = map.find(T_world_before * before_m, feature.kind);
    if (surface) {
      matches.push_back({.base_m = feature.base_m,
                         .share = feature.share,
                         .anchor_m = T_before_world * surface->anchor_m,
                         .axis = T_before_world.rotation() * surface->axis,
                         .on_line = is_edge(feature.kind)});
    }
  }
  return matches;
}

/// Leaves the share of the matches with the smallest residuals, and those below `config.inlier_m`.
void drop_outliers(std::vector<FeatureMatch>& matches, const Displacement& displacement,
                   const FeatureOdometryConfig& config) {
  std::vector<double> distances_m;
  distances_m.reserve(matches.size());
  for (const FeatureMatch& match : matches) {
    distances_m.push_back(std::abs(residual_m(match, displacement, nullptr)));
  }
  std::vector<double> sorted_m = distances_m;
  const auto last = std::min(sorted_m.size() - 1,
                             static_cast<std::size_t>(config.inlier_share * static_cast<double>(sorted_m.size())));
  std::nth_element(sorted_m.begin(), sorted_m.begin() + static_cast<std::ptrdiff_t>(last), sorted_m.end());
  const double limit_m = std::max(config.inlier_m, sorted_m[last]);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < matches.size(); ++i) {
    if (distances_m[i] <= limit_m) {
      matches[kept++] = matches[i];
    }
  }
  matches.erase(matches.begin() + static_cast<std::ptrdiff_t>(kept), matches.end());
}

/// How well `matches` hold the displacement.
void judge(const std::vector<FeatureMatch>& matches, Registration& result) {
  Matrix6d information = Matrix6d::Zero();
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  double squares_m2 = 0.0;
  for (const FeatureMatch& match : matches) {
    Vector6d gradient;
    const double distance_m = residual_m(match, result.displacement, &gradient);
    squares_m2 += distance_m * distance_m;
    information += gradient * gradient.transpose();
    const Eigen::Vector3d direction = gradient.head<3>().normalized();
    directions += direction * direction.transpose();
  }
  const auto count = static_cast<double>(matches.size());
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(directions / count, Eigen::EigenvaluesOnly);
  result.weakest = std::clamp(3.0 * solver.eigenvalues()[0], 0.0, 1.0);
  // What is not held at all is uncertain by a hundred metres or turns, not by infinity.
  constexpr double kNothing = 1e-4;
  const double variance_m2 = squares_m2 / std::max(1.0, count - 6.0);
  const Matrix6d held = information + kNothing * Matrix6d::Identity();
  result.covariance = variance_m2 * held.ldlt().solve(Matrix6d::Identity());
}

}  // namespace

Registration register_features(const std::vector<TimedFeature>& features, const FeatureMap& map,
                               const Pose& T_world_before, const FeatureOdometryConfig& config) {
  Registration result;
  std::vector<FeatureMatch> matches;
  for (int round = 0; round < config.max_rounds; ++round) {
    matches = find_matches(features, map, T_world_before, result.displacement);
    result.matches = matches.size();
    if (matches.size() < kLeastMatches) {
      return result;
    }
    Displacement next = result.displacement;
    const std::size_t first_steps = solve(matches, kFirstSteps, config.huber_m, next);
    drop_outliers(matches, next, config);
    const std::size_t steps = solve(matches, kMaxSteps, config.huber_m, next);
    if (first_steps == 0 || steps == 0) {
      return result;
    }
    result.iterations += first_steps + steps;
    const Displacement change = next - result.displacement;
    result.displacement = next;
    if (change.head<3>().norm() < kStill_m && change.tail<3>().norm() < kStill_rad) {
      break;
    }
  }
  result.inliers = matches.size();
  result.is_sound = true;
  judge(matches, result);
  return result;
}

}  // namespace berm
