#include "run_odometry.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "berm/core/stamp.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/trajectory_file.hpp"
#include "berm/odometry/feature_odometry.hpp"
#include "berm/odometry/surface_odometry.hpp"
#include "run_graph.hpp"
#include "scan_table.hpp"

namespace berm {
namespace {

/// Along the axis in which it is largest.
double largest_sigma(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, axes.eigenvalues()[2]));
}

}  // namespace

std::unique_ptr<Odometry> make_odometry(const Machine& machine) {
  machine.methods.check();
  if (machine.methods.odometry == "none") {
    return nullptr;
  }
  if (machine.methods.odometry == "reference") {
    return std::make_unique<FeatureOdometry>(machine.odometry_reference);
  }
  return std::make_unique<SurfaceOdometry>(machine.odometry);
}

RunOdometry::RunOdometry(const Machine& machine) : machine_(machine), odometry_(make_odometry(machine)) {}

OdometryResult RunOdometry::add(const std::string& name, const Scan& scan, std::span<const Label> labels) {
  const OdometryInput input{
      .points = scan.cloud.view(), .labels = labels, .stamp_ns = scan.stamp_ns, .T_base_sensor = scan.T_base_sensor};
  const OdometryResult result = odometry_->process(input);
  places_.add(steps_.size(), input, result);
  const std::size_t revised = std::min(result.revised.size(), steps_.size());
  for (std::size_t i = 0; i < revised; ++i) {
    steps_[steps_.size() - revised + i].T_odom_base = result.revised[result.revised.size() - revised + i];
  }
  steps_.push_back({.stamp_ns = scan.stamp_ns,
                    .T_odom_base = result.T_world_begin,
                    .covariance = result.covariance,
                    .health = result.health,
                    .session = result.session});
  qualities_.push_back({.name = name,
                        .T_odom_end = result.T_world_end,
                        .duration_s = result.duration_s,
                        .weakest = result.weakest,
                        .samples = result.samples,
                        .inliers = result.inliers,
                        .iterations = result.iterations});
  return result;
}

Trajectory RunOdometry::trajectory() const {
  Trajectory trajectory;
  trajectory.reserve(steps_.size());
  for (const OdometryStep& step : steps_) {
    trajectory.append(step.stamp_ns, step.T_odom_base);
  }
  return trajectory;
}

std::size_t RunOdometry::longest_session() const {
  std::vector<std::size_t> scans(steps_.empty() ? 1 : steps_.back().session + 1);
  for (const OdometryStep& step : steps_) {
    ++scans[step.session];
  }
  return static_cast<std::size_t>(std::max_element(scans.begin(), scans.end()) - scans.begin());
}

Trajectory RunOdometry::trusted() const {
  const std::size_t session = longest_session();
  Trajectory trajectory;
  std::size_t last = 0;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    if (steps_[i].session == session && steps_[i].health != OdometryHealth::lost) {
      trajectory.append(steps_[i].stamp_ns, joined_ ? joined_->poses()[i].T_world_base : steps_[i].T_odom_base);
      last = i;
    }
  }
  if (!trajectory.empty() && qualities_[last].duration_s > 0.0) {
    const Pose T_begin_end = steps_[last].T_odom_base.inverse() * qualities_[last].T_odom_end;
    trajectory.append(steps_[last].stamp_ns + from_seconds(qualities_[last].duration_s),
                      trajectory.poses().back().T_world_base * T_begin_end);
  }
  return trajectory;
}

void RunOdometry::join(const RunPoses* fixes, const OutputFolder& output, RunFiles& files, RunSummary& summary) {
  PoseGraphResult graph = write_global_trajectory(steps_, places_, fixes, machine_.pose_graph, output, files, summary);
  if (graph.closures[static_cast<std::size_t>(ClosureFate::used)] > 0) {
    joined_ = std::move(graph.trajectory);
  }
}

OdometryCounts RunOdometry::count() const {
  OdometryCounts counts{.scans = steps_.size()};
  counts.sessions = steps_.empty() ? 0 : steps_.back().session + 1;
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    ++counts.health[static_cast<std::size_t>(steps_[i].health)];
    if (i > 0 && steps_[i].session == steps_[i - 1].session) {
      counts.path_m += (steps_[i].T_odom_base.translation_m() - steps_[i - 1].T_odom_base.translation_m()).norm();
    }
  }
  return counts;
}

void RunOdometry::write_table(const OutputFolder& output) const {
  AtomicFile file(output / "odometry.csv");
  file.write("scan,stamp,health,session,weakest,sigma_m,sigma_rad,samples,inliers,iterations\n");
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const OdometryStep& step = steps_[i];
    const Quality& quality = qualities_[i];
    file.write(fmt::format("{},{},{},{},{:.4f},{:.6f},{:.7f},{},{},{}\n", csv_field(quality.name),
                           stamp_field(step.stamp_ns), health_name(step.health), step.session, quality.weakest,
                           largest_sigma(step.covariance.topLeftCorner<3, 3>()),
                           largest_sigma(step.covariance.bottomRightCorner<3, 3>()), quality.samples, quality.inliers,
                           quality.iterations));
  }
  file.commit();
}

void RunOdometry::write(const OutputFolder& output, RunFiles& files, RunSummary& summary) const {
  write_tum(output / "trajectory.tum", trajectory());
  files.emplace_back("trajectory", "trajectory.tum");
  write_table(output);
  files.emplace_back("odometry", "odometry.csv");
  const OdometryCounts& counts = summary.odometry.emplace(count());
  if (counts.sessions > 1) {
    summary.notes.push_back(
        fmt::format("the odometry lost the machine {} times for good and began a new map: the trajectory jumps there",
                    counts.sessions - 1));
  }
  const std::size_t lost = counts.health[static_cast<std::size_t>(OdometryHealth::lost)];
  if (lost > 0) {
    summary.notes.push_back(
        fmt::format("{} of {} poses of the odometry are lost: guessed from the motion before", lost, counts.scans));
  }
}

}  // namespace berm
