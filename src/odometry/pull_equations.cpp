#include "pull_equations.hpp"

#include <algorithm>
#include <cmath>

#include "berm/core/multiversion.hpp"

namespace berm {
namespace {

/// Vectors of the compiler: left to itself it shuffles what lies ready.
constexpr std::size_t kLanes = 4;
using Lanes = double __attribute__((vector_size(kLanes * sizeof(double))));
/// Six unknowns, the distance, and one that fills the last lane.
constexpr Eigen::Index kDistance = 6;
constexpr std::size_t kUnknowns = 6;
using Row = std::array<Lanes, 2>;
/// Every unknown times the whole row.
using Products = std::array<Row, kUnknowns>;

/// The products of all rows, times 1, s and s squared: what the blocks of the equations are made of.
struct Moments {
  Products plain{};
  Products by_share{};
  Products by_square{};
};

/// Adds the products of how the distance along `row_per_m` changes with a step, and of the distance.
inline void add_row(const Eigen::Vector3d& row_per_m, const Eigen::Vector3d& arm_m, double distance, double weight,
                    double share, Moments& moments) {
  const Eigen::Vector3d turn = arm_m.cross(row_per_m);
  const std::array<double, kUnknowns> unknowns = {row_per_m.x(), row_per_m.y(), row_per_m.z(),
                                                  turn.x(),      turn.y(),      turn.z()};
  const double by_share = weight * share;
  const double by_square = by_share * share;
  for (std::size_t half = 0; half < 2; ++half) {
    const Lanes row = half == 0 ? Lanes{unknowns[0], unknowns[1], unknowns[2], unknowns[3]}
                                : Lanes{unknowns[4], unknowns[5], distance, 0.0};
    const Lanes plain = weight * row;
    const Lanes shared = by_share * row;
    const Lanes squared = by_square * row;
    for (std::size_t i = 0; i < kUnknowns; ++i) {
      moments.plain[i][half] += unknowns[i] * plain;
      moments.by_share[i][half] += unknowns[i] * shared;
      moments.by_square[i][half] += unknowns[i] * squared;
    }
  }
}

/// Geman and McClure's weight of a residual at `gates` times the gate.
inline double robust_weight(double gates_squared) {
  const double u = 1.0 / (1.0 + gates_squared);
  return u * u;
}

BERM_MULTIVERSION std::size_t add_pulls(std::span<const Pull> pulls, const PoseSteps& steps,
                                        const Eigen::Vector3d& center_m, double gate_squared, double inlier_squared,
                                        Moments& moments) {
  std::size_t inliers = 0;
  for (const Pull& pull : pulls) {
    const Eigen::Vector3d world_m = steps.to_world(pull.base_m, pull.share);
    const Eigen::Vector3d error_m = world_m - pull.mean_m;
    std::array<double, 2> distances{};
    double squared = 0.0;
    for (std::size_t i = 0; i < pull.row_count; ++i) {
      distances[i] = pull.rows_per_m[i].dot(error_m);
      squared += distances[i] * distances[i];
    }
    const double weight = robust_weight(squared / gate_squared);
    for (std::size_t i = 0; i < pull.row_count; ++i) {
      add_row(pull.rows_per_m[i], world_m - center_m, distances[i], weight, pull.share, moments);
    }
    inliers += squared < inlier_squared ? 1U : 0U;
  }
  return inliers;
}

/// Row `i` of the products: six of the information, then the gradient.
Eigen::Map<const Eigen::Matrix<double, 6, 8, Eigen::RowMajor>> matrix_of(const Products& products) {
  return Eigen::Map<const Eigen::Matrix<double, 6, 8, Eigen::RowMajor>>(
      reinterpret_cast<const double*>(products.data()));  // NOLINT(cppcoreguidelines-pro-type-reinterpret-cast)
}

Matrix6d information_of(const Products& products) {
  return matrix_of(products).leftCols<6>();
}

Vector6d gradient_of(const Products& products) {
  return matrix_of(products).col(kDistance);
}

}  // namespace

void Pull::set_plane(const Eigen::Vector3d& normal, double variance_m2) {
  rows_per_m[0] = normal / std::sqrt(variance_m2);
  row_count = 1;
}

void Pull::set_cloud(const Eigen::Matrix3d& information_per_m2, const Eigen::Vector3d& up) {
  // The information of the marginal distribution lies across `up`: there it is a matrix of two rows with a root.
  const Eigen::Vector3d along = information_per_m2 * up;
  const Eigen::Matrix3d across = information_per_m2 - along * along.transpose() / up.dot(along);
  const Eigen::Vector3d first = up.unitOrthogonal();
  const Eigen::Vector3d second = up.cross(first);
  const double a = first.dot(across * first);
  const double b = first.dot(across * second);
  const double c = second.dot(across * second);
  const double root = std::sqrt(a);
  rows_per_m[0] = root * first + (b / root) * second;
  rows_per_m[1] = std::sqrt(std::max(0.0, c - b * b / a)) * second;
  row_count = 2;
}

PullEquations sum_pulls(std::span<const Pull> pulls, const PoseSteps& steps, const Eigen::Vector3d& center_m,
                        double gate_sigmas, double inlier_sigmas) {
  Moments moments;
  PullEquations equations;
  equations.inliers =
      add_pulls(pulls, steps, center_m, gate_sigmas * gate_sigmas, inlier_sigmas * inlier_sigmas, moments);
  const Matrix6d all = information_of(moments.plain);
  const Matrix6d shared = information_of(moments.by_share);
  equations.end = information_of(moments.by_square);
  equations.mixed = shared - equations.end;
  equations.begin = all - shared - equations.mixed;
  equations.end_gradient = gradient_of(moments.by_share);
  equations.begin_gradient = gradient_of(moments.plain) - equations.end_gradient;
  return equations;
}

}  // namespace berm
