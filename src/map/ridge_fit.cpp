#include "ridge_fit.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace berm {
namespace {

/// Samples so far along the edge have a say: the first length at which they are enough. A parabola of the first follows
/// bends of 5 m radius; of the last, those of 20 m.
constexpr double kReaches_m[] = {2.0, 2.8, 4.0};
constexpr double kEnoughHits = 6.0;
/// Without a sample this near along the edge, as a share of the reach, it was not seen here.
constexpr double kBeside = 0.2;
/// Half the width of the band: what lies farther to the side is another thing. Four times the scatter of good edges.
constexpr double kHalfWidth_m = 0.5;
/// Samples farther above or below belong to another bench.
constexpr double kHalfHeight_m = 1.0;
/// How sure the guess is, in hits that say the same: little, it decides where there are hardly any samples.
constexpr double kPlacePrior = 0.05;
constexpr double kSlopePrior = 0.25;  // (scatter 0.15 m / slope 0.3)^2
constexpr double kBendPrior = 9.0;    // (scatter 0.15 m / half a curvature of 1 / 10 m)^2
constexpr int kRounds = 3;
/// Least ratio of the spreads along and across for a band.
constexpr double kMinElongation = 2.0;

double falling(double share) {
  const double rest = 1.0 - share * share;
  return rest > 0.0 ? rest * rest : 0.0;
}

struct Local {
  double along_m = 0.0;
  double aside_m = 0.0;
  double up_m = 0.0;
};

Local local(const Ridge& frame, const Eigen::Vector3d& position_m) {
  const Eigen::Vector3d to = position_m - frame.position_m;
  return {to.x() * frame.direction.x() + to.y() * frame.direction.y(),
          to.y() * frame.direction.x() - to.x() * frame.direction.y(), to.z()};
}

/// Height and the slope of it along the edge, weighted as the course.
struct Heights {
  double weight = 0.0;
  double up = 0.0;
};

std::optional<Ridge> fit_within(double reach_m, const EdgeEvidence& evidence, std::span<const std::uint8_t> taken,
                                const Ridge& guess) {
  Eigen::Vector3d course(0.0, 0.0, 0.5 * guess.bend_per_m);
  Ridge fitted = guess;
  fitted.reach_m = reach_m;
  for (int round = 0; round < kRounds; ++round) {
    const bool last = round + 1 == kRounds;
    Eigen::Matrix3d normal = Eigen::Vector3d(kPlacePrior, kSlopePrior, kBendPrior).asDiagonal();
    Eigen::Vector3d right(0.0, 0.0, kBendPrior * 0.5 * guess.bend_per_m);
    Heights heights;
    fitted.left = fitted.right = fitted.here = 0.0;
    fitted.ahead_m = -reach_m;
    evidence.around(guess.position_m, reach_m + kHalfWidth_m, [&](std::size_t i) {
      const EdgeSample& sample = evidence.samples()[i];
      const Local at = local(guess, sample.position_m);
      if (taken[i] != 0 || std::abs(at.up_m) > kHalfHeight_m || std::abs(at.along_m) >= reach_m) {
        return;
      }
      const Eigen::Vector3d powers(1.0, at.along_m, at.along_m * at.along_m);
      const double near = falling(at.along_m / reach_m);
      const double inside = falling((at.aside_m - course.dot(powers)) / kHalfWidth_m);
      const double w = near * inside * sample.hits();
      normal += w * powers * powers.transpose();
      right += w * at.aside_m * powers;
      heights.weight += w;
      heights.up += w * at.up_m;
      if (last && inside > 0.0) {
        fitted.left += near * sample.left;
        fitted.right += near * sample.right;
        fitted.ahead_m = std::max(fitted.ahead_m, at.along_m);
        fitted.here += std::abs(at.along_m) <= kBeside * reach_m ? sample.hits() : 0.0;
      }
    });
    if (heights.weight <= 0.0) {
      return std::nullopt;
    }
    course = normal.ldlt().solve(right);
    fitted.position_m.z() = guess.position_m.z() + heights.up / heights.weight;
  }
  // Integral of `falling` over the reach.
  const double metres = reach_m * 16.0 / 15.0;
  fitted.left /= metres;
  fitted.right /= metres;
  const Eigen::Vector2d aside(-guess.direction.y(), guess.direction.x());
  fitted.position_m.head<2>() += course[0] * aside;
  fitted.direction = (guess.direction + course[1] * aside).normalized();
  fitted.bend_per_m = 2.0 * course[2] / std::pow(1.0 + course[1] * course[1], 1.5);
  return fitted;
}

}  // namespace

std::optional<Eigen::Vector2d> band_direction(const EdgeEvidence& evidence, std::span<const std::uint8_t> taken,
                                              const Eigen::Vector3d& place_m) {
  double weight = 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d square = Eigen::Matrix2d::Zero();
  constexpr double kRadius_m = 2.0;
  evidence.around(place_m, kRadius_m, [&](std::size_t i) {
    const EdgeSample& sample = evidence.samples()[i];
    const Eigen::Vector3d to = sample.position_m - place_m;
    if (taken[i] != 0 || std::abs(to.z()) > kHalfHeight_m) {
      return;
    }
    const double w = sample.hits() * falling(to.head<2>().norm() / kRadius_m);
    weight += w;
    mean += w * to.head<2>();
    square += w * to.head<2>() * to.head<2>().transpose();
  });
  if (weight <= 0.0) {
    return std::nullopt;
  }
  mean /= weight;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(square / weight - mean * mean.transpose());
  if (!(axes.eigenvalues()[1] > kMinElongation * kMinElongation * std::max(axes.eigenvalues()[0], 0.0))) {
    return std::nullopt;
  }
  return axes.eigenvectors().col(1);
}

std::optional<Ridge> fit_ridge(const EdgeEvidence& evidence, std::span<const std::uint8_t> taken, const Ridge& guess) {
  std::optional<Ridge> fitted;
  for (const double reach_m : kReaches_m) {
    fitted = fit_within(reach_m, evidence, taken, guess);
    if (fitted && fitted->hits() * reach_m >= kEnoughHits) {
      break;
    }
  }
  return fitted;
}

double seen_through(const EdgeMap& map, const Ridge& ridge) {
  constexpr double kAlong_m[] = {-0.6, -0.3, 0.0, 0.3, 0.6};
  // Beyond the scatter of toes; the flank of a berm that was taken for road is above the last.
  constexpr double kAside_m[] = {0.4, 0.7, 1.0};
  const Eigen::Vector3d along(ridge.direction.x(), ridge.direction.y(), 0.0);
  const Eigen::Vector3d aside(-ridge.direction.y(), ridge.direction.x(), 0.0);
  double least = std::numeric_limits<double>::infinity();
  for (const double sign : {-1.0, 1.0}) {
    for (const double aside_m : kAside_m) {
      double misses = 0.0;
      for (const double along_m : kAlong_m) {
        const Eigen::Vector3d place_m = ridge.position_m + along_m * along + sign * aside_m * aside;
        if (const auto key = voxel_key(place_m, map.config().voxel_m)) {
          for (const int up : {-1, 0, 1}) {
            misses += map.at({key->x, key->y, key->z + up}).miss;
          }
        }
      }
      least = std::min(least, misses);
    }
  }
  return least / static_cast<double>(std::size(kAlong_m)) / map.config().voxel_m;
}

Ridge advance(const Ridge& ridge, double step_m) {
  Ridge next = ridge;
  const double turn_rad = ridge.bend_per_m * step_m;
  const auto turned = [&](double angle_rad) {
    const double c = std::cos(angle_rad);
    const double s = std::sin(angle_rad);
    return Eigen::Vector2d(c * ridge.direction.x() - s * ridge.direction.y(),
                           s * ridge.direction.x() + c * ridge.direction.y());
  };
  next.position_m.head<2>() += step_m * turned(0.5 * turn_rad);
  next.direction = turned(turn_rad);
  return next;
}

}  // namespace berm
