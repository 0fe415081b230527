#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "berm/geometry/voxel_hash.hpp"
#include "berm/odometry/pose_graph_places.hpp"
#include "closure_search.hpp"
#include "scenery.hpp"

namespace berm {
namespace {

/// Way between scans that are kept, at first; it doubles whenever more points would be kept than this: 48 MB.
constexpr double kScansApart_m = 2.0;
constexpr double kScansApart_rad = 0.5;
constexpr std::size_t kMostKeptPoints = 4'000'000;
/// Of a scan.
constexpr std::size_t kScanPoints = 1500;
constexpr double kSpacing_m = 0.25;
constexpr double kMinRange_m = 1.5;
constexpr double kMaxRange_m = 40.0;

}  // namespace

struct PlaceMemory::State {
  std::vector<SeenScan> scans;
  double apart_m = kScansApart_m;
  std::size_t points = 0;
  std::size_t session = 0;
  VoxelHash<char> met{kSpacing_m};

  [[nodiscard]] bool wants(const OdometryResult& result) const {
    if (result.health == OdometryHealth::lost) {
      return false;
    }
    if (scans.empty() || result.session != session) {
      return true;
    }
    const Pose step = scans.back().T_odom_base.inverse() * result.T_world_begin;
    return step.translation_m().norm() >= apart_m ||
           Eigen::Quaterniond::Identity().angularDistance(step.rotation()) >= kScansApart_rad;
  }

  [[nodiscard]] std::vector<Eigen::Vector3f> thin(const OdometryInput& input, const OdometryResult& result) {
    met.clear();
    std::vector<Eigen::Vector3f> kept;
    const PointsView& points_view = input.points;
    const double last_s = last_time_s(points_view.time);
    const Vector6d displacement = (result.T_world_begin.inverse() * result.T_world_end).log();
    for (std::size_t i = 0; i < points_view.size(); ++i) {
      const Eigen::Vector3d sensor_m(points_view.x[i], points_view.y[i], points_view.z[i]);
      const double range_m = sensor_m.norm();
      const auto key = voxel_key(sensor_m, kSpacing_m);
      if (!is_scenery(input.labels[i]) || !(range_m > kMinRange_m && range_m < kMaxRange_m) || !key ||
          met.find(*key) != nullptr) {
        continue;
      }
      met.at_or_new(*key) = 1;
      const double share = last_s > 0.0 ? static_cast<double>(points_view.time[i]) / last_s : 0.0;
      if (share >= 0.0 && share <= 1.0) {
        kept.emplace_back((Pose::exp(share * displacement) * (input.T_base_sensor * sensor_m)).cast<float>());
      }
    }
    if (kept.size() > kScanPoints) {
      for (std::size_t i = 0; i < kScanPoints; ++i) {
        kept[i] = kept[i * kept.size() / kScanPoints];
      }
      kept.resize(kScanPoints);
      kept.shrink_to_fit();
    }
    return kept;
  }

  void keep_every_other() {
    apart_m *= 2.0;
    std::size_t left = 0;
    points = 0;
    for (std::size_t i = 0; i < scans.size(); i += 2) {
      points += scans[i].points_m.size();
      std::swap(scans[left++], scans[i]);
    }
    scans.resize(left);
  }
};

PlaceMemory::PlaceMemory() : state_(std::make_unique<State>()) {}
PlaceMemory::~PlaceMemory() = default;

void PlaceMemory::add(std::size_t step, const OdometryInput& input, const OdometryResult& result) {
  if (!state_->wants(result)) {
    return;
  }
  SeenScan scan{step, result.T_world_begin, state_->thin(input, result)};
  state_->points += scan.points_m.size();
  state_->scans.push_back(std::move(scan));
  state_->session = result.session;
  if (state_->points > kMostKeptPoints) {
    state_->keep_every_other();
  }
}

FoundClosures PlaceMemory::find(std::span<const OdometryStep> odometry, const PoseGraphResult& estimate,
                                const PoseGraphConfig& config) const {
  return search_closures(state_->scans, odometry, estimate, config);
}

std::size_t PlaceMemory::size() const {
  return state_->scans.size();
}

}  // namespace berm
