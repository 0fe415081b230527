#pragma once

#include <array>

#include <Eigen/Core>
#include <ceres/loss_function.h>
#include <ceres/sized_cost_function.h>

#include "berm/core/pose.hpp"
#include "berm/odometry/odometry.hpp"

namespace berm {

/// A node of the graph: a pose, and a step from it that is solved for. Manifolds and local parameterizations of Ceres
/// differ from release to release of the distributions; a step of plain numbers does not.
struct NodeState {
  Pose reference;
  std::array<double, 6> step{};  ///< along the axes of the world, m; then a rotation vector in the frame of the base

  [[nodiscard]] Pose pose() const;
  /// Makes the pose its own reference.
  void absorb();
};

/// Whitens with the inverse root of a covariance. Columns that were not measured have no weight.
[[nodiscard]] Matrix6d root_information(const Matrix6d& covariance);

/// The way from one node to another. Parameters: steps of both. The references have to outlive it.
class LinkCost final : public ceres::SizedCostFunction<6, 6, 6> {
 public:
  LinkCost(const NodeState& a, const NodeState& b, const Pose& T_a_b, const Matrix6d& root)
      : a_(a), b_(b), T_a_b_(T_a_b), root_(root) {}
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  const NodeState& a_;
  const NodeState& b_;
  Pose T_a_b_;
  Matrix6d root_;
};

/// Where a point of the machine is.
class PositionCost final : public ceres::SizedCostFunction<3, 6> {
 public:
  PositionCost(const NodeState& node, const Eigen::Vector3d& base_m, const Eigen::Vector3d& world_m,
               const Eigen::Vector3d& sigma_m)
      : node_(node), base_m_(base_m), world_m_(world_m), weights_(sigma_m.cwiseInverse()) {}
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  const NodeState& node_;
  Eigen::Vector3d base_m_;
  Eigen::Vector3d world_m_;
  Eigen::Vector3d weights_;
};

/// How the machine is turned; sigmas along the axes of the world.
class AttitudeCost final : public ceres::SizedCostFunction<3, 6> {
 public:
  AttitudeCost(const NodeState& node, const Eigen::Quaterniond& R_world_base, const Eigen::Vector3d& sigma_rad)
      : node_(node), R_world_base_(R_world_base), weights_(sigma_rad.cwiseInverse()) {}
  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override;

 private:
  const NodeState& node_;
  Eigen::Quaterniond R_world_base_;
  Eigen::Vector3d weights_;
};

/// Dynamic covariance scaling (Agarwal et al. 2013) as a loss: squares up to `scale`^2, and 3 `scale`^2 far out. It is
/// what switchable constraints come to once the switches are solved for.
class SwitchLoss final : public ceres::LossFunction {
 public:
  void set_scale(double scale) { square_ = scale * scale; }
  void Evaluate(double squared_norm, double out[3]) const override;

 private:
  double square_ = 1.0;
};

}  // namespace berm
