#include "berm/odometry/feature_odometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "berm/core/error.hpp"
#include "feature_finder.hpp"
#include "feature_map.hpp"
#include "registration.hpp"
#include "voxel_means.hpp"

namespace berm {
namespace {

/// LOAM-Livox matches with nothing less in its map.
constexpr std::size_t kLeastMapPlanes = 50;
/// Below this share of the residuals across it, a direction is held by noise alone: ours.
constexpr double kWeakDirection = 0.01;
/// Poses closer than this in time tell no speed.
constexpr double kShortest_s = 1e-3;
/// Of a pose that is only that of the scan before: ours.
constexpr double kLost_m = 1.0;
constexpr double kLost_rad = 0.1;

struct Knot {
  Stamp stamp_ns = 0;
  Pose T_world_base;
};

/// A part of the scan, of which the pose is searched.
struct Piece {
  double begin_s = 0.0;
  double end_s = 0.0;
  Knot before;  ///< the pose that the displacement counts from
  std::vector<TimedFeature> features;
};

/// On the line through two poses, also beyond them.
Pose pose_at(const Knot& a, const Knot& b, Stamp stamp_ns) {
  const double step_s = to_seconds(b.stamp_ns - a.stamp_ns);
  if (step_s < kShortest_s) {
    return b.T_world_base;
  }
  return interpolate(a.T_world_base, b.T_world_base, to_seconds(stamp_ns - a.stamp_ns) / step_s);
}

Pose pose_of(const Displacement& displacement) {
  const Eigen::Vector3d turn = displacement.tail<3>();
  const double angle_rad = turn.norm();
  const Eigen::Vector3d axis = angle_rad > 0.0 ? Eigen::Vector3d(turn / angle_rad) : Eigen::Vector3d::UnitX();
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, axis)), displacement.head<3>()};
}

Matrix6d turned(const Matrix6d& covariance, const Pose& T_world_before) {
  Matrix6d axes = Matrix6d::Zero();
  axes.topLeftCorner<3, 3>() = T_world_before.rotation().toRotationMatrix();
  axes.bottomRightCorner<3, 3>() = axes.topLeftCorner<3, 3>();
  return axes * covariance * axes.transpose();
}

Matrix6d covariance_of_lost() {
  Matrix6d covariance = Matrix6d::Zero();
  covariance.diagonal().head<3>().setConstant(kLost_m * kLost_m);
  covariance.diagonal().tail<3>().setConstant(kLost_rad * kLost_rad);
  return covariance;
}

double last_feature_s(const std::vector<Feature>& features) {
  double last_s = 0.0;
  for (const Feature& feature : features) {
    last_s = std::max(last_s, feature.time_s);
  }
  return last_s;
}

}  // namespace

struct FeatureOdometry::State {
  explicit State(const FeatureOdometryConfig& settings)
      : config(settings), map(settings), thin_edges(settings.edge_spacing_m), thin_planes(settings.plane_spacing_m) {}

  FeatureOdometryConfig config;
  FeatureFinder finder;
  FeatureMap map;
  VoxelMeans thin_edges;
  VoxelMeans thin_planes;
  std::optional<Knot> last;
  std::optional<Stamp> last_ns;
  std::size_t scans = 0;

  OdometryResult add(const OdometryInput& input);
  void fill(Piece& piece, const std::vector<Feature>& features, Stamp stamp_ns, Stamp knot_ns);
  [[nodiscard]] bool is_possible(const Displacement& displacement, double step_s) const;
  Displacement match(const Piece& piece, double step_s, OdometryResult& result) const;
};

/// The features of the piece, thinned by voxels, each class for itself, at their share of the time between the knots.
void FeatureOdometry::State::fill(Piece& piece, const std::vector<Feature>& features, Stamp stamp_ns, Stamp knot_ns) {
  const double before_s = to_seconds(piece.before.stamp_ns - stamp_ns);
  const double step_s = std::max(to_seconds(knot_ns - piece.before.stamp_ns), kShortest_s);
  for (std::size_t i = 0; i < kFeatureClasses; ++i) {
    const auto kind = static_cast<FeatureClass>(i);
    VoxelMeans& thin = is_edge(kind) ? thin_edges : thin_planes;
    thin.clear();
    for (const Feature& feature : features) {
      if (feature.kind == kind && feature.time_s >= piece.begin_s && feature.time_s < piece.end_s) {
        thin.add(feature.base_m, feature.time_s, 0);
      }
    }
    const std::vector<VoxelMean>& means = thin.means();
    const std::size_t count = std::min(means.size(), static_cast<std::size_t>(config.max_class_features));
    for (std::size_t j = 0; j < count; ++j) {
      const VoxelMean& mean = means[j * means.size() / count];
      const double share = config.deskew == "pieces" ? 1.0 : std::clamp((mean.time_s - before_s) / step_s, 0.0, 1.0);
      piece.features.push_back({mean.mean_m, share, kind});
    }
  }
}

bool FeatureOdometry::State::is_possible(const Displacement& displacement, double step_s) const {
  const double max_turn_rad = config.max_turn_rate_degps * std::numbers::pi / 180.0 * step_s;
  return displacement.head<3>().norm() <= config.max_speed_mps * step_s &&
         displacement.tail<3>().norm() <= max_turn_rad;
}

/// What the piece moved by; nothing where it is lost, as in LOAM-Livox.
Displacement FeatureOdometry::State::match(const Piece& piece, double step_s, OdometryResult& result) const {
  const Registration found = register_features(piece.features, map, piece.before.T_world_base, config);
  result.inliers += found.inliers;
  result.iterations += found.iterations;
  result.weakest = std::min(result.weakest, found.weakest);
  if (!found.is_sound || !is_possible(found.displacement, std::max(step_s, kShortest_s))) {
    result.health = OdometryHealth::lost;
    result.covariance = covariance_of_lost();
    return Displacement::Zero();
  }
  result.health = std::max(result.health, found.weakest < kWeakDirection ? OdometryHealth::weak : OdometryHealth::good);
  result.covariance = turned(found.covariance, piece.before.T_world_base);
  return found.displacement;
}

OdometryResult FeatureOdometry::State::add(const OdometryInput& input) {
  const std::vector<Feature>& features = finder.process(input, config);
  OdometryResult result{.duration_s = last_feature_s(features)};
  const bool has_map = map.planes() >= kLeastMapPlanes;
  result.health = has_map ? OdometryHealth::good : OdometryHealth::starting;
  const int pieces = result.duration_s > 0.0 ? config.pieces : 1;
  const bool rigid = config.deskew == "pieces";
  std::vector<Knot> knots;
  if (last) {
    knots.push_back(*last);
  }
  for (int i = 0; i < pieces; ++i) {
    Piece piece;
    piece.begin_s = result.duration_s * i / pieces;
    piece.end_s = result.duration_s * (i + 1) / pieces;
    const double knot_s = rigid ? 0.5 * (piece.begin_s + piece.end_s) : piece.end_s;
    const Stamp knot_ns = input.stamp_ns + from_seconds(knot_s);
    if (i + 1 == pieces) {
      piece.end_s = result.duration_s + 1.0;  // the last point as well
    }
    piece.before = knots.empty() ? Knot{input.stamp_ns, Pose()} : knots.back();
    fill(piece, features, input.stamp_ns, knot_ns);
    result.samples += piece.features.size();
    const double step_s = to_seconds(knot_ns - piece.before.stamp_ns);
    const Displacement displacement = has_map ? match(piece, step_s, result) : Displacement(Displacement::Zero());
    knots.push_back({knot_ns, piece.before.T_world_base * pose_of(displacement)});
    if (result.health != OdometryHealth::lost) {
      for (const TimedFeature& feature : piece.features) {
        map.add(piece.before.T_world_base * displaced_m(displacement, feature.base_m, feature.share), feature.kind,
                scans);
      }
    }
  }
  const Knot& newest = knots.back();
  const Knot& before = knots[knots.size() - std::min<std::size_t>(knots.size(), 2)];
  result.T_world_begin = last ? pose_at(knots[0], knots[1], input.stamp_ns) : knots[0].T_world_base;
  result.T_world_end = pose_at(before, newest, input.stamp_ns + from_seconds(result.duration_s));
  last = newest;
  map.update(newest.T_world_base.translation_m(), scans);
  ++scans;
  return result;
}

FeatureOdometry::FeatureOdometry(const FeatureOdometryConfig& config) {
  config.check();
  state_ = std::make_unique<State>(config);
}

FeatureOdometry::~FeatureOdometry() = default;

OdometryResult FeatureOdometry::process(const OdometryInput& input) {
  if (input.labels.size() != input.points.size()) {
    throw Error(ErrorCode::invalid_argument, "odometry: expected a label for every point");
  }
  if (state_->last_ns && input.stamp_ns <= *state_->last_ns) {
    throw Error(ErrorCode::invalid_argument, "odometry: the stamp of a scan is not later than that of the one before");
  }
  state_->last_ns = input.stamp_ns;
  return state_->add(input);
}

}  // namespace berm
