// berm_odometry_paper RECORDING [--figure FILE.png] [--pieces N] [--deskew pieces|interpolate] [--cap N]: CPU time per
// scan of the published odometry in the three variants that P compares in its figure 23, and of the default, along one
// recording, as CSV on standard output: stamp_s and the ms of each; --figure draws them. On standard error what each
// comes to: mean time, drift over 10 to 50 m against truth, if there is any, and how many scans it calls weak or lost.
// Features, matching and map count; labels, the same for all, do not.

#include <algorithm>
#include <cmath>
#include <ctime>
#include <deque>
#include <exception>
#include <filesystem>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "berm/core/mount.hpp"
#include "berm/core/scan.hpp"
#include "berm/eval/trajectory_metrics.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/recording.hpp"
#include "berm/odometry/feature_odometry.hpp"
#include "berm/odometry/surface_odometry.hpp"
#include "berm/render/draw_figure.hpp"
#include "berm/render/png.hpp"
#include "berm/snow/sparse_snow.hpp"

namespace berm::bench {
namespace {

namespace fs = std::filesystem;

/// A line of the figure.
struct Variant {
  const char* name;
  const char* title;
  Label color;  ///< as points of this label: they stay apart for everybody's eyes
};
constexpr Variant kVariants[] = {{"one_class", "one class", Label::obstacle},
                                 {"four_classes", "four classes", Label::terrain},
                                 {"four_classes_capped", "four classes, limit", Label::drivable}};
constexpr Variant kDefault = {"default", "default of berm", Label::falling_snow};

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

/// One method along the recording.
struct Course {
  Course(const Variant& method, std::unique_ptr<Odometry> with) : variant(method), odometry(std::move(with)) {}

  void add(const OdometryInput& input) {
    const double start_ms = cpu_ms();
    const OdometryResult result = odometry->process(input);
    times_ms.push_back(cpu_ms() - start_ms);
    stamps_ns.push_back(input.stamp_ns);
    std::copy(result.revised.begin(), result.revised.end(),
              poses.end() - static_cast<std::ptrdiff_t>(result.revised.size()));
    poses.push_back(result.T_world_begin);
    weak += result.health == OdometryHealth::weak ? 1U : 0U;
    lost += result.health == OdometryHealth::lost ? 1U : 0U;
  }

  [[nodiscard]] Trajectory trajectory() const {
    Trajectory result;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      result.append(stamps_ns[i], poses[i]);
    }
    return result;
  }

  Variant variant;
  std::unique_ptr<Odometry> odometry;
  std::vector<double> times_ms;
  std::vector<Stamp> stamps_ns;
  std::vector<Pose> poses;
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
  fmt::print(stderr, "{:<20} mean {:6.2f} ms  p99 {:6.2f} ms", course.variant.name,
             sum_ms / static_cast<double>(sorted_ms.size()), sorted_ms[sorted_ms.size() * 99 / 100]);
  if (truth) {
    constexpr double kLengths_m[] = {10.0, 25.0, 50.0};
    const auto pairs = pair_poses(course.trajectory(), *truth);
    const auto drift = mean_error(relative_errors(pairs, kLengths_m));
    fmt::print(stderr, "  drift {:6.2f} %  ATE {:6.3f} m", drift ? drift->translation_percent : NAN,
               absolute_error_m(pairs).value_or(NAN));
  }
  fmt::print(stderr, "  weak {}  lost {}  of {} scans\n", course.weak, course.lost, sorted_ms.size());
}

void draw(const std::deque<Course>& courses, const fs::path& file) {
  DrawOptions options{.background = Background::light, .height_px = 700};
  options.title = "CPU time per scan";
  std::vector<Curve> curves;
  for (const Course& course : courses) {
    Curve& curve = curves.emplace_back();
    curve.name = course.variant.title;
    curve.color = label_color(course.variant.color, options.background);
    for (std::size_t i = 0; i < course.times_ms.size(); ++i) {
      curve.points.emplace_back(to_seconds(course.stamps_ns[i] - course.stamps_ns.front()), course.times_ms[i]);
    }
  }
  write_file_atomically(
      file, encode_png(draw_curves(curves, {"time along the run, s", "CPU time of the odometry, ms"}, options)));
}

void run(const fs::path& path, FeatureOdometryConfig config, const fs::path& figure) {
  const Recording recording = Recording::open(path);
  MountConfig mount;
  mount.height_m = recording.sheet().height_m.value_or(0.0);
  mount.pitch_deg = recording.sheet().pitch_rad.value_or(0.0) * 180.0 / std::numbers::pi;
  std::deque<Course> courses;
  for (const Variant& variant : kVariants) {
    config.variant = variant.name;
    courses.emplace_back(variant, std::make_unique<FeatureOdometry>(config));
  }
  courses.emplace_back(kDefault, std::make_unique<SurfaceOdometry>(SurfaceOdometryConfig{}));
  Labeller labeller;
  Scan scan;
  fmt::print("stamp_s,one_class_ms,four_classes_ms,four_classes_capped_ms,default_ms\n");
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
    fmt::print("{:.3f}", to_seconds(scan.stamp_ns));
    for (const Course& course : courses) {
      fmt::print(",{:.3f}", course.times_ms.back());
    }
    fmt::print("\n");
  }
  const std::optional<Trajectory> truth = recording.read_truth_poses();
  for (const Course& course : courses) {
    print_sum(course, truth);
  }
  if (!figure.empty()) {
    draw(courses, figure);
  }
}

}  // namespace
}  // namespace berm::bench

int main(int argc, char** argv) {
  CLI::App app("CPU time of the odometry per scan: as published in three variants, and the default");
  std::string recording;
  std::string figure;
  berm::FeatureOdometryConfig config;
  app.add_option("recording", recording, "folder of the recording")->required();
  app.add_option("--figure", figure, "picture of the times, PNG");
  app.add_option("--pieces", config.pieces, "pieces of a scan");
  app.add_option("--deskew", config.deskew, "pieces or interpolate");
  app.add_option("--cap", config.max_piste_planes, "planes of the piste, in the variant that limits them");
  CLI11_PARSE(app, argc, argv);
  try {
    berm::bench::run(recording, config, figure);
  } catch (const std::exception& error) {
    fmt::print(stderr, "berm_odometry_paper: {}\n", error.what());
    return 1;
  }
  return 0;
}
