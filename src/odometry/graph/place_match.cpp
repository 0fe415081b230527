#include "place_match.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include "rotations.hpp"

namespace berm {
namespace {

constexpr std::size_t kFewestMatched = 200;
/// Starts around the guess: so far apart, with so many points each.
constexpr double kStart_m = 1.0;
constexpr std::size_t kStartPoints = 250;
constexpr std::size_t kStarts = 3;
constexpr double kApart_m = 1.5;
/// Steps of the match; points farther from their surface than the gate count for nothing, and it shrinks to the last.
constexpr int kSteps = 30;
constexpr double kFirstGate_m = 1.5;
constexpr double kLastGate_m = 0.25;
constexpr double kGateShare = 0.85;
/// Neighbouring points err together: so many count for one.
constexpr double kPointsPerFact = 20.0;
/// What a match is off even where everything fits, one sigma.
constexpr double kLeastSigma_m = 0.03;
constexpr double kLeastSigma_rad = 0.002;
/// Two matches that fit alike, this far apart in sigmas of their own: nothing tells which is right.
constexpr double kAlike = 0.9;
constexpr double kAlikeSigmas = 4.0;

double distance_m(const PlaceSurface& surface, const Eigen::Vector3d& off_m) {
  return surface.normal.isZero() ? off_m.norm() : std::abs(surface.normal.dot(off_m));
}

class Matcher {
 public:
  Matcher(const PlaceSurfaces& first, std::span<const Eigen::Vector3d> points, const PoseGraphConfig& config)
      : first_(first), points_(points), config_(config) {
    const std::size_t stride = std::max<std::size_t>(1, points.size() / kStartPoints);
    for (std::size_t i = 0; i < points.size(); i += stride) {
      few_.push_back(points[i]);
    }
  }

  struct Start {
    Pose T_first_second;
    double score = 0.0;
  };
  /// The best starts, each apart from those before.
  [[nodiscard]] std::vector<Start> starts(const PlaceGuess& guess) const {
    const int rings = static_cast<int>(std::ceil(guess.reach_m / kStart_m));
    std::vector<Start> all;
    for (int i = -rings; i <= rings; ++i) {
      for (int j = -rings; j <= rings; ++j) {
        if (i * i + j * j <= rings * rings) {
          all.push_back(start_at(guess.T_first_second, Eigen::Vector3d(i * kStart_m, j * kStart_m, 0.0)));
        }
      }
    }
    std::stable_sort(all.begin(), all.end(), [](const Start& a, const Start& b) { return a.score > b.score; });
    std::vector<Start> best;
    for (const Start& start : all) {
      const bool apart = std::all_of(best.begin(), best.end(), [&](const Start& other) {
        const Eigen::Vector3d way_m = other.T_first_second.translation_m() - start.T_first_second.translation_m();
        return way_m.head<2>().norm() > kApart_m;
      });
      if (apart && best.size() < kStarts) {
        best.push_back(start);
      }
    }
    return best;
  }

  [[nodiscard]] PlaceMatch match(const Pose& start) const {
    PlaceMatch result;
    result.T_first_second = start;
    double gate_m = kFirstGate_m;
    Matrix6d information;
    for (int step = 0; step < kSteps; ++step) {
      Vector6d gradient;
      weigh(result.T_first_second, gate_m, information, gradient);
      const Vector6d move = -(information + 1e-3 * Matrix6d::Identity()).ldlt().solve(gradient);
      if (!move.allFinite() || move.head<3>().norm() > 3.0 || move.tail<3>().norm() > 0.5) {
        return result;
      }
      result.T_first_second = Pose(result.T_first_second.rotation() * rotation_exp(move.tail<3>()),
                                   result.T_first_second.translation_m() + move.head<3>());
      if (gate_m == kLastGate_m && move.head<3>().norm() < 1e-4 && move.tail<3>().norm() < 1e-5) {
        break;
      }
      gate_m = std::max(kLastGate_m, kGateShare * gate_m);
    }
    judge(information, result);
    return result;
  }

 private:
  /// A start beside the guess, moved up or down until the ground is at one height.
  [[nodiscard]] Start start_at(const Pose& guess, const Eigen::Vector3d& off_m) const {
    const Pose beside(guess.rotation(), guess.translation_m() + off_m);
    std::vector<double> heights_m;
    for (const Eigen::Vector3d& point_m : few_) {
      const Eigen::Vector3d there_m = beside * point_m;
      if (const auto ground_m = first_.ground_m(there_m.x(), there_m.y())) {
        heights_m.push_back(*ground_m - there_m.z());
      }
    }
    if (heights_m.size() < few_.size() / 4) {
      return {beside, 0.0};
    }
    const auto middle = heights_m.begin() + static_cast<std::ptrdiff_t>(heights_m.size() / 2);
    std::nth_element(heights_m.begin(), middle, heights_m.end());
    Start start{Pose(guess.rotation(), beside.translation_m() + Eigen::Vector3d(0.0, 0.0, *middle))};
    for (const Eigen::Vector3d& point_m : few_) {
      const Eigen::Vector3d there_m = start.T_first_second * point_m;
      const PlaceSurface* surface = first_.find(there_m);
      if (surface != nullptr) {
        const double off = distance_m(*surface, there_m - surface->mean_m) / 0.3;
        start.score += 1.0 / (1.0 + off * off);
      }
    }
    return start;
  }

  /// Normal equations of a step: translation along the axes of the first, rotation about those of the second.
  void weigh(const Pose& T_first_second, double gate_m, Matrix6d& information, Vector6d& gradient) const {
    information.setZero();
    gradient.setZero();
    const Eigen::Matrix3d R = T_first_second.rotation().toRotationMatrix();
    for (const Eigen::Vector3d& point_m : points_) {
      const Eigen::Vector3d there_m = T_first_second * point_m;
      const PlaceSurface* surface = first_.find(there_m);
      if (surface == nullptr) {
        continue;
      }
      const Eigen::Vector3d off_m = there_m - surface->mean_m;
      const double share = distance_m(*surface, off_m) / gate_m;
      if (share > 3.0) {
        continue;
      }
      const double weight = std::pow(1.0 / (1.0 + share * share), 2) / kPointsPerFact;
      Eigen::Matrix<double, 3, 6> by_step;
      by_step << Eigen::Matrix3d::Identity(), -R * skew(point_m);
      const Eigen::Matrix<double, 6, 3> weighted = weight * by_step.transpose() * surface->information;
      information.noalias() += weighted * by_step;
      gradient.noalias() += weighted * off_m;
    }
  }

  void judge(const Matrix6d& information, PlaceMatch& result) const {
    std::vector<double> distances_m;
    std::size_t met = 0;
    for (const Eigen::Vector3d& point_m : points_) {
      const Eigen::Vector3d there_m = result.T_first_second * point_m;
      const PlaceSurface* surface = first_.find(there_m);
      if (surface == nullptr) {
        continue;
      }
      const double off_m = distance_m(*surface, there_m - surface->mean_m);
      met += off_m < 2.0 * kLastGate_m ? 1U : 0U;
      if (!surface->normal.isZero()) {
        distances_m.push_back(off_m);
      }
    }
    result.overlap = static_cast<double>(met) / static_cast<double>(points_.size());
    if (result.overlap < config_.closure_overlap || distances_m.size() < kFewestMatched) {
      result.fate = ClosureFate::too_little;
      return;
    }
    const auto middle = distances_m.begin() + static_cast<std::ptrdiff_t>(distances_m.size() / 2);
    std::nth_element(distances_m.begin(), middle, distances_m.end());
    result.residual_m = *middle;
    result.fate = result.residual_m > config_.closure_residual_m ? ClosureFate::misfit : ClosureFate::used;
    // Directions of which the surfaces say nothing get a sigma of metres, not of infinity.
    Matrix6d least = Matrix6d::Zero();
    least.diagonal() << 0.01, 0.01, 0.01, 1.0, 1.0, 1.0;
    result.covariance = (information + least).ldlt().solve(Matrix6d::Identity());
    result.covariance = 0.5 * (result.covariance + result.covariance.transpose()).eval();
    result.covariance.diagonal().head<3>().array() += kLeastSigma_m * kLeastSigma_m;
    result.covariance.diagonal().tail<3>().array() += kLeastSigma_rad * kLeastSigma_rad;
  }

  const PlaceSurfaces& first_;
  std::span<const Eigen::Vector3d> points_;
  std::vector<Eigen::Vector3d> few_;
  const PoseGraphConfig& config_;
};

bool fit_alike(const PlaceMatch& best, const PlaceMatch& other) {
  if (other.fate != ClosureFate::used || other.overlap < kAlike * best.overlap) {
    return false;
  }
  const Eigen::Vector3d way_m = other.T_first_second.translation_m() - best.T_first_second.translation_m();
  const Eigen::Matrix3d covariance = best.covariance.topLeftCorner<3, 3>();
  return way_m.norm() > 0.5 && std::sqrt(way_m.dot(covariance.ldlt().solve(way_m))) > kAlikeSigmas;
}

}  // namespace

PlaceMatch match_places(const PlaceSurfaces& first, std::span<const Eigen::Vector3d> points, const PlaceGuess& guess,
                        const PoseGraphConfig& config) {
  PlaceMatch best;
  best.T_first_second = guess.T_first_second;
  if (points.size() < kFewestMatched) {
    return best;
  }
  const Matcher matcher(first, points, config);
  std::vector<PlaceMatch> matches;
  for (const Matcher::Start& start : matcher.starts(guess)) {
    matches.push_back(matcher.match(start.T_first_second));
    const PlaceMatch& match = matches.back();
    const bool better = best.fate == ClosureFate::used
                            ? match.fate == ClosureFate::used && match.overlap > best.overlap
                            : match.fate == ClosureFate::used || match.overlap > best.overlap;
    if (better) {
      best = match;
    }
  }
  if (best.fate == ClosureFate::used &&
      std::any_of(matches.begin(), matches.end(), [&](const PlaceMatch& match) { return fit_alike(best, match); })) {
    best.fate = ClosureFate::misfit;
  }
  return best;
}

}  // namespace berm
