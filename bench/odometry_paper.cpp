// berm_odometry_paper RECORDING [--pieces N] [--deskew pieces|interpolate] [--cap N]: CPU time per scan of the
// published odometry in the three variants that P compares in its figure 23, along one recording, as CSV on standard
// output: stamp_s and the ms of each. On standard error what each variant comes to: mean time, drift over 10 to 50 m
// against truth, if there is any, and how many scans it calls weak or lost. Features, matching and map count; labels,
// the same for all three, do not.

#include <algorithm>
#include <cmath>
#include <ctime>
#include <deque>
#include <exception>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "berm/core/mount.hpp"
#include "berm/core/scan.hpp"
#include "berm/eval/trajectory_metrics.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "berm/io/recording.hpp"
#include "berm/odometry/feature_odometry.hpp"
#include "berm/snow/sparse_snow.hpp"

namespace berm::bench {
namespace {

constexpr const char* kVariants[] = {"one_class", "four_classes", "four_classes_capped"};

double cpu_ms() {
  timespec time{};
  (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// Labels by the default stages: ground counts as piste.
class Labeller {
 public:
  const std::vector<Label>& process(const Scan& scan) {
    PointsView points = scan.cloud.view();
    const SnowResult snow = snow_.process(points, scan.T_base_sensor);
    x_.assign(points.x.begin(), points.x.end());
    for (std::size_t i = 0; i < x_.size(); ++i) {
      if (snow.falling[i] != 0) {
        x_[i] = std::numeric_limits<float>::quiet_NaN();
      }
    }
    points.x = x_;
    const GroundResult ground = ground_.process(points, scan.T_base_sensor);
    labels_.clear();
    for (std::size_t i = 0; i < x_.size(); ++i) {
      labels_.push_back(snow.falling[i] != 0 ? Label::falling_snow : label_of(ground.classes[i]));
    }
    return labels_;
  }

 private:
  SparseSnow snow_{SparseSnowConfig{}};
  TerrainGround ground_{TerrainGroundConfig{}};
  std::vector<float> x_;
  std::vector<Label> labels_;
};

/// One variant along the recording.
struct Course {
  explicit Course(const FeatureOdometryConfig& config) : name(config.variant), odometry(config) {}

  void add(const OdometryInput& input) {
    const double start_ms = cpu_ms();
    const OdometryResult result = odometry.process(input);
    times_ms.push_back(cpu_ms() - start_ms);
    poses.append(input.stamp_ns, result.T_world_begin);
    weak += result.health == OdometryHealth::weak ? 1U : 0U;
    lost += result.health == OdometryHealth::lost ? 1U : 0U;
  }

  std::string name;
  FeatureOdometry odometry;
  std::vector<double> times_ms;
  Trajectory poses;
  std::size_t weak = 0;
  std::size_t lost = 0;
};

void print_sum(const Course& course, const std::optional<Trajectory>& truth) {
  double sum_ms = 0.0;
  for (const double time_ms : course.times_ms) {
    sum_ms += time_ms;
  }
  std::vector<double> sorted_ms = course.times_ms;
  std::sort(sorted_ms.begin(), sorted_ms.end());
  fmt::print(stderr, "{:<20} mean {:6.2f} ms  p99 {:6.2f} ms", course.name,
             sum_ms / static_cast<double>(sorted_ms.size()), sorted_ms[sorted_ms.size() * 99 / 100]);
  if (truth) {
    constexpr double kLengths_m[] = {10.0, 25.0, 50.0};
    const auto pairs = pair_poses(course.poses, *truth);
    const auto drift = mean_error(relative_errors(pairs, kLengths_m));
    fmt::print(stderr, "  drift {:6.2f} %  ATE {:6.3f} m", drift ? drift->translation_percent : NAN,
               absolute_error_m(pairs).value_or(NAN));
  }
  fmt::print(stderr, "  weak {}  lost {}  of {} scans\n", course.weak, course.lost, sorted_ms.size());
}

void run(const std::string& path, FeatureOdometryConfig config) {
  const Recording recording = Recording::open(path);
  MountConfig mount;
  mount.height_m = recording.sheet().height_m.value_or(0.0);
  mount.pitch_deg = recording.sheet().pitch_rad.value_or(0.0) * 180.0 / std::numbers::pi;
  std::deque<Course> courses;
  for (const char* variant : kVariants) {
    config.variant = variant;
    courses.emplace_back(config);
  }
  Labeller labeller;
  Scan scan;
  fmt::print("stamp_s,one_class_ms,four_classes_ms,four_classes_capped_ms\n");
  for (std::size_t i = 0; i < recording.size(); ++i) {
    recording.read(i, scan);
    scan.T_base_sensor = mount.T_base_sensor();
    const OdometryInput input{.points = scan.cloud.view(),
                              .labels = labeller.process(scan),
                              .stamp_ns = scan.stamp_ns,
                              .T_base_sensor = scan.T_base_sensor};
    for (Course& course : courses) {
      course.add(input);
    }
    fmt::print("{:.3f},{:.3f},{:.3f},{:.3f}\n", to_seconds(scan.stamp_ns), courses[0].times_ms.back(),
               courses[1].times_ms.back(), courses[2].times_ms.back());
  }
  const std::optional<Trajectory> truth = recording.read_truth_poses();
  for (const Course& course : courses) {
    print_sum(course, truth);
  }
}

}  // namespace
}  // namespace berm::bench

int main(int argc, char** argv) {
  CLI::App app("CPU time of the published odometry per scan, in three variants");
  std::string recording;
  berm::FeatureOdometryConfig config;
  app.add_option("recording", recording, "folder of the recording")->required();
  app.add_option("--pieces", config.pieces, "pieces of a scan");
  app.add_option("--deskew", config.deskew, "pieces or interpolate");
  app.add_option("--cap", config.max_piste_planes, "planes of the piste, in the variant that limits them");
  CLI11_PARSE(app, argc, argv);
  try {
    berm::bench::run(recording, config);
  } catch (const std::exception& error) {
    fmt::print(stderr, "berm_odometry_paper: {}\n", error.what());
    return 1;
  }
  return 0;
}
