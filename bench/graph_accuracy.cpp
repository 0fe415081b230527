// berm_graph_accuracy RECORDING...: the pose graph on the GNSS/INS of simulated recordings, whole and with faults,
// against truth. The odometry is truth with a drift of about 0.5 %, or that of a run: --odometry OUT/trajectory.tum.

#include <algorithm>
#include <cmath>
#include <ctime>
#include <filesystem>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <Eigen/Core>
#include <fmt/format.h>

#include "berm/core/stamp.hpp"
#include "berm/eval/trajectory_metrics.hpp"
#include "berm/io/trajectory_file.hpp"
#include "berm/odometry/pose_graph.hpp"

namespace berm::bench {
namespace {

namespace fs = std::filesystem;

Eigen::Vector3d normal3(std::mt19937& random, double sigma) {
  std::normal_distribution<double> normal(0.0, sigma);
  const double x = normal(random);
  const double y = normal(random);
  const double z = normal(random);
  return {x, y, z};
}

/// Half of its error is steady, half at random.
std::vector<OdometryStep> drifting(const Trajectory& truth) {
  constexpr Stamp kScan_ns = 100'000'000;
  std::mt19937 random(5);
  Vector6d steady;
  steady << 0.003, 0.0, 0.001, normal3(random, 5e-5);
  std::vector<OdometryStep> steps;
  Pose T_odom_base;
  std::optional<Pose> last;
  for (Stamp at_ns = truth.poses().front().stamp_ns; at_ns <= truth.poses().back().stamp_ns; at_ns += kScan_ns) {
    const auto here = truth.at(at_ns);
    if (last) {
      const Pose step = last->inverse() * *here;
      const double way_m = step.translation_m().norm();
      Vector6d noise;
      noise << normal3(random, 0.01 * std::sqrt(way_m)), normal3(random, 0.0005 * std::sqrt(way_m));
      T_odom_base = T_odom_base * step * Pose::exp(steady * way_m + noise);
    }
    last = here;
    steps.push_back({.stamp_ns = at_ns, .T_odom_base = T_odom_base});
  }
  return steps;
}

std::vector<OdometryStep> steps_of(const Trajectory& trajectory) {
  std::vector<OdometryStep> steps;
  for (const StampedPose& pose : trajectory.poses()) {
    steps.push_back({.stamp_ns = pose.stamp_ns, .T_odom_base = pose.T_world_base});
  }
  return steps;
}

struct Fault {
  std::string name;
  std::function<void(std::vector<Fix>&, Stamp, Stamp)> make;  ///< from one time to another
  double seconds = 0.0;
};

std::vector<Fault> all_faults() {
  const auto shift = [](const Eigen::Vector3d& by_m) {
    return [by_m](std::vector<Fix>& fixes, Stamp from_ns, Stamp to_ns) {
      for (Fix& fix : fixes) {
        fix.position_m += fix.stamp_ns > from_ns && fix.stamp_ns < to_ns ? by_m : Eigen::Vector3d(0.0, 0.0, 0.0);
      }
    };
  };
  const auto cut = [](std::vector<Fix>& fixes, Stamp from_ns, Stamp to_ns) {
    std::erase_if(fixes, [&](const Fix& fix) { return fix.stamp_ns > from_ns && fix.stamp_ns < to_ns; });
  };
  return {{"none", [](std::vector<Fix>&, Stamp, Stamp) {}, 5.0},
          {"60 s without", cut, 60.0},
          {"jump of 50 m for 5 s", shift({30.0, -40.0, 5.0}), 5.0},
          {"jump of 1 m for 5 s", shift({0.6, -0.8, 0.2}), 5.0},
          {"0.3 s late",
           [](std::vector<Fix>& fixes, Stamp, Stamp) {
             for (Fix& fix : fixes) {
               fix.stamp_ns += 300'000'000;
             }
           },
           5.0},
          {"no attitudes",
           [](std::vector<Fix>& fixes, Stamp, Stamp) {
             for (Fix& fix : fixes) {
               fix.R_world_base.reset();
             }
           },
           5.0}};
}

double most_off_m(const Trajectory& trajectory, const Trajectory& truth) {
  double most_m = 0.0;
  for (const PosePair& pair : pair_poses(trajectory, truth)) {
    most_m = std::max(most_m, (pair.estimate.translation_m() - pair.truth.translation_m()).norm());
  }
  return most_m;
}

void measure(const fs::path& recording, const std::string& odometry_file) {
  const Trajectory truth = read_tum(recording / "truth.tum");
  const auto odometry = odometry_file.empty() ? drifting(truth) : steps_of(read_tum(odometry_file));
  const PoseGraphConfig config;
  const auto fixes = fixes_of(read_tum(recording / "gnss.tum"), config);
  const Stamp begin_ns = odometry.front().stamp_ns;
  const double seconds = to_seconds(odometry.back().stamp_ns - begin_ns);
  for (const Fault& fault : all_faults()) {
    const double length_s = std::min(fault.seconds, 0.5 * seconds);
    const Stamp from_ns = begin_ns + from_seconds(0.5 * (seconds - length_s));
    auto some = fixes;
    fault.make(some, from_ns, from_ns + from_seconds(length_s));
    const std::clock_t clock = std::clock();
    const PoseGraphResult result = solve_pose_graph(odometry, some, {}, config);
    const double cpu_s = static_cast<double>(std::clock() - clock) / CLOCKS_PER_SEC;
    const auto ate_m = absolute_error_m(pair_poses(result.trajectory, truth));
    fmt::print("{:<12} {:<22} {:6.0f} s  ATE {:.3f} m  most {:.3f} m  offset {:6.3f} s  used {} of {}  {:.2f} s CPU\n",
               recording.filename().string(), fault.name, seconds, ate_m.value_or(std::nan("")),
               most_off_m(result.trajectory, truth), result.time_offset_s,
               result.fixes[static_cast<std::size_t>(FixFate::used)], some.size(), cpu_s);
  }
}

}  // namespace
}  // namespace berm::bench

int main(int argc, char** argv) {
  CLI::App app("The pose graph on simulated recordings");
  std::vector<std::string> recordings;
  std::string odometry;
  app.add_option("recordings", recordings)->required();
  app.add_option("--odometry", odometry);
  CLI11_PARSE(app, argc, argv);
  for (const std::string& recording : recordings) {
    berm::bench::measure(recording, odometry);
  }
}
