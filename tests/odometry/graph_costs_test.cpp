#include "graph/graph_costs.hpp"

#include <array>

#include <Eigen/LU>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "graph/chain_covariance.hpp"
#include "graph/rotations.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;

double number(double bound) {
  return *rc::gen::map(rc::gen::inRange(-100000, 100001), [bound](int i) { return bound * i * 1e-5; });
}

Vector6d twist(double move_m, double turn_rad) {
  Vector6d result;
  result << number(move_m), number(move_m), number(move_m), number(turn_rad), number(turn_rad), number(turn_rad);
  return result;
}

/// Analytic Jacobians against differences.
template <int rows, std::size_t nodes>
void check_jacobians(const ceres::CostFunction& cost, std::array<Vector6d, nodes> steps) {
  using Residual = Eigen::Matrix<double, rows, 1>;
  std::array<const double*, nodes> parameters;
  std::array<Eigen::Matrix<double, rows, 6, Eigen::RowMajor>, nodes> analytic;
  std::array<double*, nodes> jacobians;
  for (std::size_t n = 0; n < nodes; ++n) {
    parameters[n] = steps[n].data();
    jacobians[n] = analytic[n].data();
  }
  Residual residual;
  RC_ASSERT(cost.Evaluate(parameters.data(), residual.data(), jacobians.data()));
  constexpr double kStep = 1e-6;
  for (std::size_t n = 0; n < nodes; ++n) {
    for (Eigen::Index i = 0; i < 6; ++i) {
      const double before = steps[n][i];
      Residual high;
      Residual low;
      steps[n][i] = before + kStep;
      RC_ASSERT(cost.Evaluate(parameters.data(), high.data(), nullptr));
      steps[n][i] = before - kStep;
      RC_ASSERT(cost.Evaluate(parameters.data(), low.data(), nullptr));
      steps[n][i] = before;
      RC_ASSERT(((high - low) / (2.0 * kStep) - analytic[n].col(i)).norm() < 1e-4 * (1.0 + analytic[n].norm()));
    }
  }
}

TEST(GraphCosts, JacobiansAreThoseOfTheResiduals) {
  EXPECT_TRUE(rc::check([] {
    NodeState a{Pose::exp(twist(10.0, 1.5))};
    NodeState b{a.reference * Pose::exp(twist(2.0, 0.4))};
    const Pose T_a_b = a.reference.inverse() * b.reference * Pose::exp(twist(0.3, 0.3));
    const Matrix6d root = root_information(Vector6d::LinSpaced(0.01, 0.5).asDiagonal());
    const std::array<Vector6d, 2> steps = {twist(0.5, 0.3), twist(0.5, 0.3)};
    check_jacobians<6, 2>(LinkCost(a, b, T_a_b, root), steps);
    const Vector3d sigma(0.1, 0.2, 0.3);
    check_jacobians<3, 1>(PositionCost(a, twist(3.0, 0.0).head<3>(), twist(10.0, 0.0).head<3>(), sigma),
                          std::array<Vector6d, 1>{steps[0]});
    check_jacobians<3, 1>(AttitudeCost(a, a.reference.rotation() * rotation_exp(twist(0.0, 0.5).tail<3>()), sigma),
                          std::array<Vector6d, 1>{steps[0]});
  }));
}

TEST(GraphCosts, LossIsSmoothAndBounded) {
  SwitchLoss loss;
  loss.set_scale(2.0);
  double before = 0.0;
  for (double square = 0.0; square < 500.0; square += 0.25) {
    std::array<double, 3> out{};
    loss.Evaluate(square, out.data());
    std::array<double, 3> next{};
    loss.Evaluate(square + 1e-6, next.data());
    EXPECT_NEAR((next[0] - out[0]) / 1e-6, out[1], 1e-5);
    EXPECT_GE(out[0], before);
    EXPECT_LE(out[0], 3.0 * 4.0);
    before = out[0];
  }
}

TEST(ChainCovariance, IsTheDiagonalOfTheInverse) {
  EXPECT_TRUE(rc::check([] {
    constexpr std::size_t kNodes = 5;
    ChainInformation chain(kNodes);
    Eigen::Matrix<double, 6 * kNodes, 6 * kNodes> whole;
    whole.setZero();
    const auto add = [&](std::size_t node, const Matrix6d& information) {
      chain.add(node, information);
      whole.block<6, 6>(6 * static_cast<Eigen::Index>(node), 6 * static_cast<Eigen::Index>(node)) += information;
    };
    for (std::size_t i = 0; i + 1 < kNodes; ++i) {
      Eigen::Matrix<double, 6, 12> by;
      for (Eigen::Index k = 0; k < by.size(); ++k) {
        by(k) = number(1.0);
      }
      by.leftCols<6>() += 3.0 * Matrix6d::Identity();
      by.rightCols<6>() -= 3.0 * Matrix6d::Identity();
      chain.add_link(i, by.leftCols<6>(), by.rightCols<6>());
      whole.block<12, 12>(6 * static_cast<Eigen::Index>(i), 6 * static_cast<Eigen::Index>(i)) += by.transpose() * by;
    }
    add(0, Matrix6d::Identity());
    add(3, 2.0 * Matrix6d::Identity());
    const Eigen::Matrix<double, 6 * kNodes, 6 * kNodes> inverse = whole.inverse();
    const auto covariances = chain.covariances();
    for (std::size_t i = 0; i < kNodes; ++i) {
      const auto at = 6 * static_cast<Eigen::Index>(i);
      RC_ASSERT((covariances[i] - inverse.block<6, 6>(at, at)).norm() < 1e-6 * inverse.norm());
    }
  }));
}

}  // namespace
}  // namespace berm
