#include "graph_costs.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Eigenvalues>

#include "rotations.hpp"

namespace berm {
namespace {

template <int rows>
using RowMajor = Eigen::Matrix<double, rows, 6, Eigen::RowMajor>;

struct MovedNode {
  Eigen::Matrix3d R;
  Eigen::Vector3d translation_m;
  Eigen::Matrix3d turn;  ///< of the frame of the base per rotation vector of the step
};

MovedNode move(const NodeState& node, const double* step) {
  const Eigen::Map<const Eigen::Vector3d> move_m(step);
  const Eigen::Map<const Eigen::Vector3d> turn_rad(step + 3);
  return {(node.reference.rotation() * rotation_exp(turn_rad)).toRotationMatrix(),
          node.reference.translation_m() + move_m, right_jacobian(turn_rad)};
}

}  // namespace

Pose NodeState::pose() const {
  const MovedNode moved = move(*this, step.data());
  return {Eigen::Quaterniond(moved.R), moved.translation_m};
}

void NodeState::absorb() {
  reference = pose();
  step.fill(0.0);
}

Matrix6d root_information(const Matrix6d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Matrix6d> axes(0.5 * (covariance + covariance.transpose()));
  // A covariance that rounding made indefinite must not become an infinite weight.
  constexpr double kLeast = 1e-12;
  const Vector6d roots = axes.eigenvalues().cwiseMax(kLeast).cwiseSqrt().cwiseInverse();
  return axes.eigenvectors() * roots.asDiagonal() * axes.eigenvectors().transpose();
}

bool LinkCost::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const MovedNode a = move(a_, parameters[0]);
  const MovedNode b = move(b_, parameters[1]);
  const Eigen::Vector3d between_m = a.R.transpose() * (b.translation_m - a.translation_m);
  const Eigen::Matrix3d R_a_b = a.R.transpose() * b.R;
  const Eigen::Vector3d turn_rad = rotation_log(T_a_b_.rotation().conjugate() * Eigen::Quaterniond(R_a_b));
  Vector6d off;
  off << between_m - T_a_b_.translation_m(), turn_rad;
  Eigen::Map<Vector6d>(residuals).noalias() = root_ * off;
  if (jacobians == nullptr) {
    return true;
  }
  const Eigen::Matrix3d spread = right_jacobian_inverse(turn_rad);
  Matrix6d by_step = Matrix6d::Zero();
  if (jacobians[0] != nullptr) {
    by_step.topLeftCorner<3, 3>() = -a.R.transpose();
    by_step.topRightCorner<3, 3>() = skew(between_m) * a.turn;
    by_step.bottomRightCorner<3, 3>() = -spread * R_a_b.transpose() * a.turn;
    Eigen::Map<RowMajor<6>>(jacobians[0]).noalias() = root_ * by_step;
  }
  if (jacobians[1] != nullptr) {
    by_step.topLeftCorner<3, 3>() = a.R.transpose();
    by_step.topRightCorner<3, 3>().setZero();
    by_step.bottomRightCorner<3, 3>() = spread * b.turn;
    Eigen::Map<RowMajor<6>>(jacobians[1]).noalias() = root_ * by_step;
  }
  return true;
}

bool PositionCost::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const MovedNode node = move(node_, parameters[0]);
  Eigen::Map<Eigen::Vector3d>{residuals} = weights_.cwiseProduct(node.translation_m + node.R * base_m_ - world_m_);
  if (jacobians != nullptr && jacobians[0] != nullptr) {
    Eigen::Map<RowMajor<3>> by_step(jacobians[0]);
    by_step.leftCols<3>() = weights_.asDiagonal();
    by_step.rightCols<3>() = -(weights_.asDiagonal() * node.R * skew(base_m_) * node.turn);
  }
  return true;
}

bool AttitudeCost::Evaluate(double const* const* parameters, double* residuals, double** jacobians) const {
  const MovedNode node = move(node_, parameters[0]);
  const Eigen::Vector3d off_rad = rotation_log(Eigen::Quaterniond(node.R) * R_world_base_.conjugate());
  Eigen::Map<Eigen::Vector3d>{residuals} = weights_.cwiseProduct(off_rad);
  if (jacobians != nullptr && jacobians[0] != nullptr) {
    // A turn t in the base is one of R t in the world; the left inverse is the right one of the opposite vector.
    Eigen::Map<RowMajor<3>> by_step(jacobians[0]);
    by_step.leftCols<3>().setZero();
    by_step.rightCols<3>() = weights_.asDiagonal() * right_jacobian_inverse(-off_rad) * node.R * node.turn;
  }
  return true;
}

void SwitchLoss::Evaluate(double squared_norm, double out[3]) const {
  if (squared_norm <= square_) {
    out[0] = squared_norm;
    out[1] = 1.0;
    out[2] = 0.0;
    return;
  }
  const double sum = square_ + squared_norm;
  out[0] = square_ * (3.0 * squared_norm - square_) / sum;
  out[1] = 4.0 * square_ * square_ / (sum * sum);
  out[2] = -2.0 * out[1] / sum;
}

}  // namespace berm
