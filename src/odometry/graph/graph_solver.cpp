#include "graph_solver.hpp"

#include <algorithm>
#include <cmath>

#include <ceres/problem.h>
#include <ceres/solver.h>

#include "chain_covariance.hpp"
#include "graph_costs.hpp"

namespace berm {
namespace {

/// What is known of the attitude where no fix tells it: machines stand upright, roughly.
constexpr double kUpright_rad = 0.3;
/// The scale of the losses falls so fast, with so many steps of the solver each time: enough to follow.
constexpr double kNarrowing = 4.0;
constexpr int kStepsPerStage = 4;
constexpr int kManySteps = 40;
/// What is so many times the scale off has hardly any weight left, a quarter, and is called outvoted.
constexpr double kOutvoted = 1.7;
/// An attitude of GNSS is one of a filter: off for minutes where it is off.
constexpr double kAttitudeFactor = 2.0;

class Graph {
 public:
  Graph(const GraphTask& task, const PoseGraphConfig& config)
      : task_(task), config_(config), states_(task.start.size()), problem_(options()) {
    for (std::size_t i = 0; i < states_.size(); ++i) {
      states_[i].reference = task.start[i];
      problem_.AddParameterBlock(states_[i].step.data(), 6);
    }
    add_links();
    add_groups();
    for (const NodeClosure& closure : task.closures) {
      NodeState& a = states_[closure.first];
      NodeState& b = states_[closure.second];
      auto* cost = new LinkCost(a, b, closure.T_first_second, root_information(closure.covariance));
      closures_.push_back(problem_.AddResidualBlock(cost, &loss_, a.step.data(), b.step.data()));
    }
    if (task.groups.empty()) {
      problem_.SetParameterBlockConstant(states_.front().step.data());
    }
  }

  void solve() {
    const double last = config_.gate_sigma;
    std::vector<double> scales = {last};
    for (const double widest = 2.0 * largest_residual(); scales.back() < widest;) {
      scales.push_back(scales.back() * kNarrowing);
    }
    for (auto scale = scales.rbegin(); scale != scales.rend(); ++scale) {
      loss_.set_scale(*scale);
      attitude_loss_.set_scale(kAttitudeFactor * *scale);
      const bool is_first = scale == scales.rbegin();
      const bool is_last = std::next(scale) == scales.rend();
      take_steps(is_first || is_last ? kManySteps : kStepsPerStage);
    }
  }

  [[nodiscard]] GraphSolution solution() {
    GraphSolution result;
    for (const NodeState& state : states_) {
      result.nodes.push_back(state.pose());
    }
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      result.is_used.push_back(norm_of(positions_[i]) < kOutvoted * config_.gate_sigma);
      result.is_attitude_used.push_back(attitudes_[i] != nullptr &&
                                        norm_of(attitudes_[i]) < kOutvoted * kAttitudeFactor * config_.gate_sigma);
    }
    for (const ceres::ResidualBlockId block : closures_) {
      result.is_closure_used.push_back(norm_of(block) < kOutvoted * config_.gate_sigma);
    }
    result.covariances = covariances(result);
    return result;
  }

 private:
  static ceres::Problem::Options options() {
    ceres::Problem::Options options;
    options.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    return options;
  }

  void add_links() {
    for (std::size_t i = 0; i < task_.chain.links.size(); ++i) {
      const ChainLink& link = task_.chain.links[i];
      auto* cost = new LinkCost(states_[i], states_[i + 1], link.T_a_b, root_information(link.covariance));
      links_.push_back(problem_.AddResidualBlock(cost, nullptr, states_[i].step.data(), states_[i + 1].step.data()));
    }
  }

  void add_groups() {
    for (const FixGroup& group : task_.groups) {
      NodeState& node = states_[group.node];
      positions_.push_back(problem_.AddResidualBlock(
          new PositionCost(node, group.antenna_m, group.position_m, group.sigma_m), &loss_, node.step.data()));
      attitudes_.push_back(nullptr);
      if (group.attitude.count > 0) {
        auto* cost = new AttitudeCost(node, group.attitude.R_world_base, group.attitude.sigma_rad);
        attitudes_.back() = problem_.AddResidualBlock(cost, &attitude_loss_, node.step.data());
      }
    }
    if (!task_.groups.empty()) {
      NodeState& first = states_.front();
      auto* cost = new AttitudeCost(first, first.reference.rotation(), Eigen::Vector3d::Constant(kUpright_rad));
      upright_ = problem_.AddResidualBlock(cost, nullptr, first.step.data());
    }
  }

  [[nodiscard]] double norm_of(ceres::ResidualBlockId block) const {
    double cost = 0.0;
    problem_.EvaluateResidualBlock(block, false, &cost, nullptr, nullptr);
    return std::sqrt(2.0 * cost);
  }

  [[nodiscard]] double largest_residual() const {
    double largest = 0.0;
    for (const auto* blocks : {&positions_, &attitudes_, &closures_}) {
      for (const ceres::ResidualBlockId block : *blocks) {
        largest = block != nullptr ? std::max(largest, norm_of(block)) : largest;
      }
    }
    return largest;
  }

  void take_steps(int count) {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    // SuiteSparse calls a BLAS whose sums depend on its number of threads.
    if (ceres::IsSparseLinearAlgebraLibraryTypeAvailable(ceres::EIGEN_SPARSE)) {
      options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
    }
    options.max_num_iterations = count;
    options.num_threads = 1;
    options.max_solver_time_in_seconds = 1e9;
    options.function_tolerance = 1e-13;
    options.parameter_tolerance = 1e-10;
    options.logging_type = ceres::SILENT;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem_, &summary);
    for (NodeState& state : states_) {
      state.absorb();
    }
  }

  /// The information of a block on its node or nodes, J^T J.
  template <int rows>
  [[nodiscard]] Matrix6d information(ceres::ResidualBlockId block) const {
    Eigen::Matrix<double, rows, 6, Eigen::RowMajor> jacobian;
    double* jacobians[] = {jacobian.data()};
    problem_.EvaluateResidualBlock(block, false, nullptr, nullptr, jacobians);
    return jacobian.transpose() * jacobian;
  }

  [[nodiscard]] std::vector<Matrix6d> covariances(const GraphSolution& solution) const {
    // Known to a micrometre: the place of a node that does not move.
    constexpr double kFixed = 1e12;
    ChainInformation chain(states_.size());
    for (std::size_t i = 0; i < links_.size(); ++i) {
      // Ceres gives no derivative by a node that is held, and none at all if it is asked for that one.
      const bool is_held = problem_.IsParameterBlockConstant(states_[i].step.data());
      Eigen::Matrix<double, 6, 6, Eigen::RowMajor> by_a = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>::Zero();
      Eigen::Matrix<double, 6, 6, Eigen::RowMajor> by_b;
      double* jacobians[] = {is_held ? nullptr : by_a.data(), by_b.data()};
      problem_.EvaluateResidualBlock(links_[i], false, nullptr, nullptr, jacobians);
      chain.add_link(i, by_a, by_b);
    }
    for (std::size_t i = 0; i < positions_.size(); ++i) {
      if (solution.is_used[i]) {
        chain.add(task_.groups[i].node, information<3>(positions_[i]));
      }
      if (solution.is_attitude_used[i]) {
        chain.add(task_.groups[i].node, information<3>(attitudes_[i]));
      }
    }
    chain.add(0, upright_ != nullptr ? information<3>(upright_) : Matrix6d(kFixed * Matrix6d::Identity()));
    return chain.covariances();
  }

  const GraphTask& task_;
  const PoseGraphConfig& config_;
  SwitchLoss loss_;  // before the problem, which uses them until its end
  SwitchLoss attitude_loss_;
  std::vector<NodeState> states_;
  ceres::Problem problem_;
  std::vector<ceres::ResidualBlockId> links_;
  std::vector<ceres::ResidualBlockId> positions_;
  std::vector<ceres::ResidualBlockId> attitudes_;  ///< null where there is none
  std::vector<ceres::ResidualBlockId> closures_;
  ceres::ResidualBlockId upright_ = nullptr;
};

}  // namespace

GraphSolution solve_graph(const GraphTask& task, const PoseGraphConfig& config) {
  Graph graph(task, config);
  graph.solve();
  return graph.solution();
}

}  // namespace berm
