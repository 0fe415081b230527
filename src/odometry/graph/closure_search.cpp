#include "closure_search.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include "place_match.hpp"
#include "place_surfaces.hpp"
#include "rotations.hpp"

namespace berm {
namespace {

/// Places are looked at so far apart along the way, and so many at most.
constexpr double kPlaceApart_m = 8.0;
constexpr std::size_t kMostCandidates = 300;
/// A place is what was seen on so much of the way before and behind it; that a machine which comes back the other way
/// sees the same, it has to be more than what is in front of it.
constexpr double kPlaceWay_m = 20.0;
constexpr double kPlaceRadius_m = 30.0;
constexpr double kPointSpacing_m = 0.4;
constexpr std::size_t kMostPoints = 3000;
/// Both places known to this, one sigma: a closure would say nothing new.
constexpr double kSure_m = 0.1;
/// What an odometry may drift on the way between: more than the best do, less than a false closure asks for.
constexpr double kDriftShare = 0.02;
constexpr double kDrift_m = 0.5;
constexpr double kDriftRadPerM = 0.0004;
constexpr double kDrift_rad = 0.05;
/// Closures confirm each other on so much of the way, up to this difference, or so many sigmas.
constexpr double kConfirmWay_m = 30.0;
constexpr double kConfirm_m = 0.25;
constexpr double kConfirm_rad = 0.03;
constexpr double kConfirmSigmas = 4.0;

struct Candidate {
  std::size_t first = 0;  ///< of the scans
  std::size_t second = 0;
};

struct Found {
  Candidate pair;
  PlaceMatch match;
};

class Search {
 public:
  Search(std::span<const SeenScan> scans, std::span<const OdometryStep> odometry, const PoseGraphResult& estimate,
         const PoseGraphConfig& config)
      : scans_(scans), odometry_(odometry), estimate_(estimate), config_(config) {
    double path_m = 0.0;
    std::size_t step = 0;
    for (const SeenScan& scan : scans) {
      for (; step < scan.step; ++step) {
        const Pose& to = odometry[step + 1].T_odom_base;
        const bool same = odometry[step + 1].session == odometry[step].session;
        path_m += same ? (to.translation_m() - odometry[step].T_odom_base.translation_m()).norm() : 0.0;
      }
      path_m_.push_back(path_m);
      sigma_m_.push_back(sigma_at(scan.step));
    }
  }

  [[nodiscard]] FoundClosures run() {
    std::vector<Found> found;
    for (const Candidate& pair : candidates()) {
      const PlaceMatch match = compare(pair);
      if (match.fate == ClosureFate::used) {
        found.push_back({pair, match});
      } else {
        ++result_.rejected[static_cast<std::size_t>(match.fate)];
      }
    }
    for (const Found& one : found) {
      const bool is_confirmed =
          std::any_of(found.begin(), found.end(), [&](const Found& other) { return confirms(one, other); });
      if (!is_confirmed) {
        ++result_.rejected[static_cast<std::size_t>(ClosureFate::alone)];
        continue;
      }
      result_.closures.push_back(
          {scans_[one.pair.first].step, scans_[one.pair.second].step, one.match.T_first_second, one.match.covariance});
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] double sigma_at(std::size_t step) const {
    const auto& nodes = estimate_.nodes;
    const auto after = std::upper_bound(nodes.begin(), nodes.end(), step,
                                        [](std::size_t s, const GraphNode& node) { return s < node.step; });
    const GraphNode& node = after == nodes.begin() ? nodes.front() : *(after - 1);
    return std::sqrt(std::max(0.0, node.covariance.diagonal().head<3>().maxCoeff()));
  }

  [[nodiscard]] const Pose& T_world_base(std::size_t scan) const {
    return estimate_.trajectory.poses()[scans_[scan].step].T_world_base;
  }
  [[nodiscard]] std::size_t session(std::size_t scan) const { return odometry_[scans_[scan].step].session; }

  /// For every place the nearest one of each time that it was passed before.
  [[nodiscard]] std::vector<Candidate> candidates() const {
    std::vector<Candidate> all;
    double last_m = -kPlaceApart_m;
    for (std::size_t j = 0; j < scans_.size(); ++j) {
      if (path_m_[j] - last_m < kPlaceApart_m) {
        continue;
      }
      last_m = path_m_[j];
      bool has_nearest = false;
      std::size_t nearest = 0;
      double nearest_m = 0.0;
      for (std::size_t i = 0; i < j; ++i) {
        const double apart_m = (T_world_base(i).translation_m() - T_world_base(j).translation_m()).norm();
        const bool is_near = apart_m < config_.closure_reach_m && path_m_[j] - path_m_[i] > config_.closure_detour_m &&
                             std::max(sigma_m_[i], sigma_m_[j]) > kSure_m;
        // That far beyond the nearest, what comes is another time.
        if (has_nearest &&
            path_m_[i] - path_m_[nearest] > std::max(config_.closure_detour_m, 2.0 * config_.closure_reach_m)) {
          all.push_back({nearest, j});
          has_nearest = false;
        }
        if (is_near && (!has_nearest || apart_m < nearest_m)) {
          has_nearest = true;
          nearest = i;
          nearest_m = apart_m;
        }
      }
      if (has_nearest) {
        all.push_back({nearest, j});
      }
    }
    if (all.size() > kMostCandidates) {
      for (std::size_t i = 0; i < kMostCandidates; ++i) {
        all[i] = all[i * all.size() / kMostCandidates];
      }
      all.resize(kMostCandidates);
    }
    return all;
  }

  /// Calls `use` with the points around a scan, in its frame as the odometry links the scans.
  template <typename Use>
  void each_point(std::size_t scan, const Use& use) const {
    const Pose T_base_odom = odometry_[scans_[scan].step].T_odom_base.inverse();
    const auto add = [&](std::size_t other) {
      const Pose T_scan_other = T_base_odom * odometry_[scans_[other].step].T_odom_base;
      for (const Eigen::Vector3f& point_m : scans_[other].points_m) {
        const Eigen::Vector3d here_m = T_scan_other * point_m.cast<double>();
        if (here_m.norm() < kPlaceRadius_m) {
          use(here_m);
        }
      }
    };
    const auto in_place = [&](std::size_t other) {
      return session(other) == session(scan) && std::abs(path_m_[other] - path_m_[scan]) < kPlaceWay_m;
    };
    std::size_t begin = scan;
    while (begin > 0 && in_place(begin - 1)) {
      --begin;
    }
    for (std::size_t other = begin; other < scans_.size() && in_place(other); ++other) {
      add(other);
    }
  }

  [[nodiscard]] std::vector<Eigen::Vector3d> points_of(std::size_t scan) const {
    std::vector<Eigen::Vector3d> points;
    VoxelHash<char> met(kPointSpacing_m);
    each_point(scan, [&](const Eigen::Vector3d& point_m) {
      const auto key = met.key_of(point_m);
      if (key && met.find(*key) == nullptr) {
        met.at_or_new(*key) = 1;
        points.push_back(point_m);
      }
    });
    if (points.size() > kMostPoints) {
      for (std::size_t i = 0; i < kMostPoints; ++i) {
        points[i] = points[i * points.size() / kMostPoints];
      }
      points.resize(kMostPoints);
    }
    return points;
  }

  [[nodiscard]] PlaceMatch compare(const Candidate& pair) const {
    PlaceSurfaces surfaces;
    each_point(pair.first, [&](const Eigen::Vector3d& point_m) { surfaces.add(point_m); });
    surfaces.fit();
    const double way_m = path_m_[pair.second] - path_m_[pair.first];
    double drift_m = kDriftShare * way_m;
    if (estimate_.is_in_world) {
      drift_m = std::min(drift_m, 4.0 * (sigma_m_[pair.first] + sigma_m_[pair.second]));
    }
    drift_m += kDrift_m;
    const PlaceGuess guess{T_world_base(pair.first).inverse() * T_world_base(pair.second),
                           std::min(drift_m, config_.closure_reach_m)};
    PlaceMatch match = match_places(surfaces, points_of(pair.second), guess, config_);
    if (match.fate == ClosureFate::used) {
      const Pose off = guess.T_first_second.inverse() * match.T_first_second;
      const double turn_rad = Eigen::Quaterniond::Identity().angularDistance(off.rotation());
      if (off.translation_m().norm() > drift_m + 1.0 || turn_rad > kDrift_rad + kDriftRadPerM * way_m) {
        match.fate = ClosureFate::too_far;
      }
    }
    return match;
  }

  /// Whether `other` says of the places of `one` what `one` does.
  [[nodiscard]] bool confirms(const Found& one, const Found& other) const {
    const double first_way_m = std::abs(path_m_[one.pair.first] - path_m_[other.pair.first]);
    const double second_way_m = std::abs(path_m_[one.pair.second] - path_m_[other.pair.second]);
    if (&one == &other || std::max(first_way_m, second_way_m) > kConfirmWay_m || second_way_m == 0.0 ||
        session(one.pair.first) != session(other.pair.first) ||
        session(one.pair.second) != session(other.pair.second)) {
      return false;
    }
    const auto between = [this](std::size_t a, std::size_t b) {
      return odometry_[scans_[a].step].T_odom_base.inverse() * odometry_[scans_[b].step].T_odom_base;
    };
    const Pose told = between(one.pair.first, other.pair.first) * other.match.T_first_second *
                      between(other.pair.second, one.pair.second);
    Vector6d off;
    off << told.translation_m() - one.match.T_first_second.translation_m(),
        rotation_log(one.match.T_first_second.rotation().conjugate() * told.rotation());
    const Matrix6d covariance = one.match.covariance + other.match.covariance;
    const Eigen::Vector3d move_m = off.head<3>();
    const Eigen::Matrix3d moves = covariance.topLeftCorner<3, 3>();
    const bool is_near =
        move_m.norm() < kConfirm_m || std::sqrt(move_m.dot(moves.ldlt().solve(move_m))) < kConfirmSigmas;
    return is_near && off.tail<3>().norm() < kConfirm_rad;
  }

  std::span<const SeenScan> scans_;
  std::span<const OdometryStep> odometry_;
  const PoseGraphResult& estimate_;
  const PoseGraphConfig& config_;
  std::vector<double> path_m_;
  std::vector<double> sigma_m_;
  FoundClosures result_;
};

}  // namespace

FoundClosures search_closures(std::span<const SeenScan> scans, std::span<const OdometryStep> odometry,
                              const PoseGraphResult& estimate, const PoseGraphConfig& config) {
  if (!config.use_closures || scans.empty() || estimate.nodes.empty()) {
    return {};
  }
  return Search(scans, odometry, estimate, config).run();
}

}  // namespace berm
