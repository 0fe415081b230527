#include "odometry/made_drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "berm/core/stamp.hpp"

namespace berm::test {
namespace {

constexpr double kFar_m = 60.0;
constexpr double kTurn_s = 0.1;
constexpr std::size_t kColumns = 1200;
constexpr int kRings = 16;
constexpr double kNoise_m = 0.02;

const Pose& T_base_made_sensor() {
  static const Pose T_base_sensor(Eigen::Quaterniond::Identity(), Eigen::Vector3d(0.0, 0.0, 2.0));
  return T_base_sensor;
}

/// Distance along the ray to the box; none if it misses or starts inside.
std::optional<double> range_to(const Box& box, const Eigen::Vector3d& from_m, const Eigen::Vector3d& direction) {
  double enter = 0.0;
  double leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.low_m[axis] - from_m[axis]) / direction[axis];
    const double b = (box.high_m[axis] - from_m[axis]) / direction[axis];
    enter = std::max(enter, std::min(a, b));
    leave = std::min(leave, std::max(a, b));
  }
  return enter > 0.0 && enter <= leave ? std::optional(enter) : std::nullopt;
}

}  // namespace

MadePlace made_yard() {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  MadePlace place;
  for (double x_m = -30.0; x_m < 100.0; x_m += 4.0 + 6.0 * share(random)) {
    for (const double side : {-1.0, 1.0}) {
      const double y_m = side * (6.0 + 8.0 * share(random));
      const Eigen::Vector3d half_m(0.2 + 2.0 * share(random), 0.2 + share(random), 1.0 + 2.0 * share(random));
      const Eigen::Vector3d middle_m(x_m, y_m, half_m.z());
      place.boxes.push_back({middle_m - half_m, middle_m + half_m});
    }
  }
  return place;
}

MadePlace bare_ground() {
  return {};
}

MadeMotion straight(double speed_mps, double heave_rad) {
  return [speed_mps, heave_rad](double time_s) {
    const double pitch_rad = heave_rad * std::sin(2.0 * std::numbers::pi * time_s);
    return Pose::from_yaw_pitch_roll(0.0, pitch_rad, 0.0, {speed_mps * time_s, 0.0, 0.0});
  };
}

MadeScan::MadeScan(const MadePlace& place, const MadeMotion& motion, double begin_s, std::size_t turns)
    : stamp_ns(from_seconds(begin_s)) {
  std::mt19937 random(static_cast<unsigned>(stamp_ns / 1000 + 1));
  std::normal_distribution<double> noise_m(0.0, kNoise_m);
  for (std::size_t column = 0; column < turns * kColumns; ++column) {
    const double turn = static_cast<double>(column) / static_cast<double>(kColumns);
    const double time_s = kTurn_s * turn;
    const Pose T_world_sensor = motion(begin_s + time_s) * T_base_made_sensor();
    const double azimuth_rad = 2.0 * std::numbers::pi * turn;
    for (int ring = 0; ring < kRings; ++ring) {
      const double elevation_rad = (-15.0 + 2.0 * ring) * std::numbers::pi / 180.0;
      const Eigen::Vector3d direction(std::cos(elevation_rad) * std::cos(azimuth_rad),
                                      std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad));
      cast(place, T_world_sensor, direction, time_s, noise_m(random));
    }
  }
}

void MadeScan::cast(const MadePlace& place, const Pose& T_world_sensor, const Eigen::Vector3d& direction, double time_s,
                    double noise_m) {
  const Eigen::Vector3d from_m = T_world_sensor.translation_m();
  const Eigen::Vector3d world = T_world_sensor.rotation() * direction;
  double range_m = kFar_m;
  Label label = Label::no_return;
  if (place.has_ground && world.z() < 0.0 && -from_m.z() / world.z() < range_m) {
    range_m = -from_m.z() / world.z();
    label = Label::drivable;
  }
  for (const Box& box : place.boxes) {
    if (const auto hit_m = range_to(box, from_m, world); hit_m && *hit_m < range_m) {
      range_m = *hit_m;
      label = Label::obstacle;
    }
  }
  const Eigen::Vector3d point_m =
      label == Label::no_return ? Eigen::Vector3d::Zero() : Eigen::Vector3d((range_m + noise_m) * direction);
  channels.x.push_back(static_cast<float>(point_m.x()));
  channels.y.push_back(static_cast<float>(point_m.y()));
  channels.z.push_back(static_cast<float>(point_m.z()));
  channels.time.push_back(static_cast<float>(time_s));
  labels.push_back(label);
}

OdometryInput MadeScan::input() const {
  return {.points = {.x = channels.x, .y = channels.y, .z = channels.z, .time = channels.time},
          .labels = labels,
          .stamp_ns = stamp_ns,
          .T_base_sensor = T_base_made_sensor()};
}

std::vector<Pose> follow(Odometry& odometry, const MadePlace& place, const MadeMotion& motion, std::size_t scans,
                         const std::function<void(const OdometryResult&)>& look, std::size_t turns) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < scans; ++i) {
    const MadeScan scan(place, motion, kTurn_s * static_cast<double>(turns * i), turns);
    const OdometryResult result = odometry.process(scan.input());
    std::copy(result.revised.begin(), result.revised.end(),
              poses.end() - static_cast<std::ptrdiff_t>(result.revised.size()));
    poses.push_back(result.T_world_begin);
    if (look) {
      look(result);
    }
  }
  return poses;
}

}  // namespace berm::test
