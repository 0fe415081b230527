#include "map/road_made.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berm::test {
namespace {

constexpr double kSpeed_mps = 5.0;
constexpr double kPosesPerSecond = 10.0;
constexpr double kSeen_m = 30.0;
constexpr int kGround = 1500;

Stamp stamp_of(double seconds) {
  return static_cast<Stamp>(std::llround(seconds * 1e9));
}

/// The same on every platform, unlike std::normal_distribution: the sum of twelve uniform numbers.
class Noise {
 public:
  explicit Noise(unsigned seed) : random_(seed) {}
  double uniform(double least, double most) {
    return least + (most - least) * (static_cast<double>(random_() >> 11U) * 0x1p-53);
  }
  double normal(double sigma) {
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) {
      sum += uniform(0.0, 1.0);
    }
    return sigma * sum;
  }

 private:
  std::mt19937_64 random_;
};

}  // namespace

Eigen::Vector3d MadeRoad::at(double s_m, double left) const {
  const double turn = curvature * s_m;
  const double x = curvature == 0.0 ? s_m : std::sin(turn) / curvature;
  const double y = curvature == 0.0 ? 0.0 : (1.0 - std::cos(turn)) / curvature;
  const Eigen::Vector3d level_m(x - left * std::sin(turn), y + left * std::cos(turn), 0.0);
  return start_m + Eigen::AngleAxisd(heading_rad, Eigen::Vector3d::UnitZ()) * level_m +
         Eigen::Vector3d(0.0, 0.0, grade * s_m + cross_fall * left);
}

Pose MadeRoad::pose_at(double s_m) const {
  return Pose::from_yaw_pitch_roll(heading_rad + curvature * s_m, -std::atan(grade), 0.0, at(s_m, 0.0));
}

Trajectory MadeRoad::path(double from_m, double to_m, double start_s) const {
  Trajectory path;
  const double seconds = std::abs(to_m - from_m) / kSpeed_mps;
  const int count = static_cast<int>(std::lround(seconds * kPosesPerSecond));
  for (int i = 0; i <= count; ++i) {
    const double share = count > 0 ? static_cast<double>(i) / count : 0.0;
    path.append(stamp_of(start_s + share * seconds), pose_at(from_m + share * (to_m - from_m)));
  }
  return path;
}

std::vector<StampedPose> MadeRoad::poses(double from_m, double to_m, double start_s) const {
  const Trajectory driven = path(from_m, to_m, start_s);
  return driven.poses();
}

EdgeLine MadeRoad::line(EdgeSide side, double from_m, double to_m) const {
  EdgeLine line;
  line.side = side;
  for (double s_m = from_m; s_m <= to_m; s_m += 0.5) {
    line.vertices.push_back({at(s_m, side == EdgeSide::left ? left_m : -right_m), 0.97});
  }
  return line;
}

std::vector<EdgeLine> MadeRoad::lines(double from_m, double to_m) const {
  return {line(EdgeSide::left, from_m, to_m), line(EdgeSide::right, from_m, to_m)};
}

std::vector<MadeScan> made_scans(const MadeRoad& road, double from_m, double to_m, const ScanNoise& noise,
                                 unsigned seed) {
  Noise random(seed);
  std::vector<MadeScan> scans;
  const int count = static_cast<int>(std::abs(to_m - from_m)) + 1;
  const double ahead = to_m < from_m ? -1.0 : 1.0;
  double height_error_m = 0.0;
  double pitch_error = 0.0;
  double roll_error = 0.0;
  double berm_error_m = 0.0;
  for (int i = 0; i < count; ++i) {
    if (i % 5 == 0) {
      height_error_m = random.normal(noise.shared_m);
      pitch_error = random.normal(noise.shared_slope);
      roll_error = random.normal(noise.shared_slope);
      berm_error_m = random.normal(noise.shared_m);
    }
    const double here_m = from_m + ahead * i;
    MadeScan scan;
    scan.stamp_ns = stamp_of(std::abs(here_m - from_m) / kSpeed_mps);
    for (int k = 0; k < kGround; ++k) {
      const double off_m = random.uniform(-kSeen_m, kSeen_m);
      const double left_m = random.uniform(-road.right_m - 2.0, road.left_m + 2.0);
      const double beyond_m = std::max({left_m - road.left_m, -road.right_m - left_m, 0.0});
      const double error_m = height_error_m + pitch_error * off_m + roll_error * left_m + random.normal(noise.ground_m);
      scan.ground_m.emplace_back(road.at(here_m + off_m, left_m) + Eigen::Vector3d(0.0, 0.0, 0.7 * beyond_m + error_m));
    }
    for (int k = 0; k < 4; ++k) {
      const bool left = k % 2 == 0;
      const double off_m = random.uniform(-kSeen_m, kSeen_m);
      const double left_m = (left ? road.left_m : -road.right_m) + random.normal(noise.edge_m);
      const double berm_m = (left ? road.left_berm_m : road.right_berm_m) + berm_error_m + random.normal(noise.berm_m);
      scan.edges.push_back({road.at(here_m + off_m, left_m), static_cast<float>(std::max(berm_m, 0.01)),
                            static_cast<float>(2.0 * std::max(berm_m, 0.01))});
    }
    scans.push_back(std::move(scan));
  }
  return scans;
}

std::vector<RoadStation> survey(const RoadConfig& config, const Trajectory& path, std::span<const MadeScan> scans,
                                std::span<const EdgeLine> lines) {
  RoadSurvey survey(config, path);
  for (const MadeScan& scan : scans) {
    survey.add_scan(scan.stamp_ns, scan.edges, scan.ground_m, scan.raised_m);
  }
  return survey.stations(lines);
}

}  // namespace berm::test
