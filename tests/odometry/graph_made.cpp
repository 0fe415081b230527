#include "odometry/graph_made.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace berm::test {
namespace {

using Eigen::Vector3d;

Vector3d normal3(std::mt19937& random, double sigma) {
  std::normal_distribution<double> normal(0.0, sigma);
  const double x = normal(random);
  const double y = normal(random);
  const double z = normal(random);
  return {x, y, z};
}

Vector6d twist_of(const Vector3d& move_m, const Vector3d& turn_rad) {
  Vector6d twist;
  twist << move_m, turn_rad;
  return twist;
}

}  // namespace

Pose MadeDrive::truth(double time_s) const {
  // Bends of 60 m, a hill of 300 m: by the way, so that a faster drive is the same path.
  const double way_m = speed_mps * (time_s + (is_even ? 0.0 : 3.0 * std::sin(0.2 * time_s)));
  const double yaw = 0.7 + 0.8 * std::sin(way_m / 60.0) + 0.002 * way_m;
  const double x = 400.0 + way_m * std::cos(0.7) + 20.0 * std::sin(way_m / 60.0);
  const double y = -250.0 + way_m * std::sin(0.7) - 20.0 * std::cos(way_m / 60.0);
  const double z = 1300.0 + 30.0 * std::sin(way_m / 50.0);
  const double pitch = -0.3 * std::cos(way_m / 50.0) + 0.03 * std::sin(6.0 * time_s);
  return Pose::from_yaw_pitch_roll(yaw, pitch, 0.05 * std::sin(way_m / 17.0), Vector3d(x, y, z));
}

std::vector<OdometryStep> MadeDrive::odometry() const {
  std::mt19937 random(seed);
  // Half of it steady, half of it at random: an odometry errs in both ways.
  const Vector6d steady = drift * twist_of(Vector3d(0.003, 0.0, 0.001), normal3(random, 5e-5));
  std::vector<OdometryStep> steps;
  Pose T_odom_base;
  const auto count = static_cast<std::size_t>(seconds * rate_hz);
  for (std::size_t i = 0; i < count; ++i) {
    const double time_s = static_cast<double>(i) / rate_hz;
    if (i > 0) {
      const Pose step = truth(time_s - 1.0 / rate_hz).inverse() * truth(time_s);
      const double way_m = step.translation_m().norm();
      const Vector3d move_m = normal3(random, 0.01 * std::sqrt(way_m));
      const Vector3d turn_rad = normal3(random, 0.0005 * std::sqrt(way_m));
      T_odom_base = T_odom_base * step * Pose::exp(steady * way_m + drift * twist_of(move_m, turn_rad));
    }
    steps.push_back({.stamp_ns = from_seconds(time_s), .T_odom_base = T_odom_base});
  }
  return steps;
}

std::vector<Fix> MadeFixes::of(const MadeDrive& drive) const {
  std::mt19937 random(seed);
  std::vector<Fix> fixes;
  const auto count = static_cast<std::size_t>(drive.seconds * rate_hz);
  for (std::size_t i = 0; i < count; ++i) {
    const double time_s = (static_cast<double>(i) + 0.37) / rate_hz;
    const Pose truth = drive.truth(time_s);
    Fix fix;
    fix.stamp_ns = from_seconds(time_s + clock_late_s);
    fix.position_m = truth * antenna_m + normal3(random, sigma_m);
    fix.sigma_m.setConstant(sigma_m);
    const Vector3d turn_rad = normal3(random, attitude_sigma_rad);
    if (has_attitude) {
      fix.R_world_base = (truth * Pose::exp(twist_of(Vector3d::Zero(), turn_rad))).rotation();
      fix.tilt_sigma_rad = attitude_sigma_rad;
      fix.heading_sigma_rad = attitude_sigma_rad;
    }
    fixes.push_back(fix);
  }
  return fixes;
}

std::vector<Fix> without(std::vector<Fix> fixes, double from_s, double to_s) {
  std::erase_if(
      fixes, [&](const Fix& fix) { return fix.stamp_ns >= from_seconds(from_s) && fix.stamp_ns < from_seconds(to_s); });
  return fixes;
}

std::vector<Fix> moved(std::vector<Fix> fixes, double from_s, double to_s, const Vector3d& by_m) {
  for (Fix& fix : fixes) {
    if (fix.stamp_ns >= from_seconds(from_s) && fix.stamp_ns < from_seconds(to_s)) {
      fix.position_m += by_m;
    }
  }
  return fixes;
}

PathError error_of(const Trajectory& trajectory, const MadeDrive& drive, double from_s, double to_s) {
  PathError error;
  double sum = 0.0;
  double count = 0.0;
  for (const StampedPose& pose : trajectory.poses()) {
    const double time_s = to_seconds(pose.stamp_ns);
    if (time_s < from_s || time_s >= to_s) {
      continue;
    }
    const Pose truth = drive.truth(time_s);
    const double off_m = (pose.T_world_base.translation_m() - truth.translation_m()).norm();
    sum += off_m * off_m;
    count += 1.0;
    error.most_m = std::max(error.most_m, off_m);
    error.most_rad = std::max(error.most_rad, pose.T_world_base.rotation().angularDistance(truth.rotation()));
  }
  error.rms_m = std::sqrt(sum / std::max(count, 1.0));
  return error;
}

double drift_share(const std::vector<OdometryStep>& odometry, const MadeDrive& drive) {
  double sum = 0.0;
  double count = 0.0;
  constexpr std::size_t kApart = 300;
  for (std::size_t i = 0; i + kApart < odometry.size(); i += 10) {
    const Pose step = odometry[i].T_odom_base.inverse() * odometry[i + kApart].T_odom_base;
    const Pose truth = drive.truth(to_seconds(odometry[i].stamp_ns)).inverse() *
                       drive.truth(to_seconds(odometry[i + kApart].stamp_ns));
    const double way_m = drive.speed_mps * static_cast<double>(kApart) / drive.rate_hz;
    sum += (truth.inverse() * step).translation_m().norm() / way_m;
    count += 1.0;
  }
  return sum / count;
}

std::size_t count_of(const PoseGraphResult& result, FixFate fate) {
  return result.fixes[static_cast<std::size_t>(fate)];
}

std::size_t count_of(const PoseGraphResult& result, ClosureFate fate) {
  return result.closures[static_cast<std::size_t>(fate)];
}

}  // namespace berm::test
