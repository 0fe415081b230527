#include "road_measure.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/core/mount.hpp"
#include "berm/core/ordered_parallel.hpp"
#include "berm/core/scan.hpp"
#include "berm/core/stamp.hpp"
#include "berm/edge/ring_edges.hpp"
#include "berm/edge/trace_edges.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "berm/io/edges_file.hpp"
#include "berm/io/recording.hpp"
#include "berm/io/settings.hpp"
#include "berm/map/reference_edge_map.hpp"
#include "berm/map/road_survey.hpp"
#include "berm/sim/scenario.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/simulate.hpp"
#include "berm/snow/sparse_snow.hpp"
#include "berm_height.hpp"
#include "support/temp_folder.hpp"

namespace berm::bench {
namespace {

constexpr double kPathStep_m = 0.5;
constexpr int kSeedsTried = 5;
constexpr std::uint64_t kSeedStep = 100;

/// What is true of the road of a recording.
struct Truth {
  std::vector<EdgeLine> edges;
  std::shared_ptr<const sim::Terrain> terrain;
  std::vector<Eigen::Vector3d> path_m;
  double length_m = 0.0;
};

Truth read_truth(const Recording& recording) {
  Truth truth;
  for (const Edge& edge : read_edges(recording.path() / "edges.csv")) {
    EdgeLine line{edge.left ? EdgeSide::left : EdgeSide::right, {}};
    for (const Eigen::Vector3d& vertex_m : edge.vertices_m) {
      line.vertices.push_back({vertex_m, 1.0});
    }
    truth.edges.push_back(std::move(line));
  }
  truth.terrain = read_true_terrain(recording.path());
  const Stamp last_ns = recording.scan(recording.size() - 1).stamp_ns;
  const Trajectory driven = recording.read_truth_poses().value();
  for (const StampedPose& pose : driven.poses()) {
    const Eigen::Vector3d& place_m = pose.T_world_base.translation_m();
    const double step_m = truth.path_m.empty() ? kPathStep_m : (place_m - truth.path_m.back()).norm();
    if (step_m >= kPathStep_m && pose.stamp_ns <= last_ns) {
      truth.length_m += truth.path_m.empty() ? 0.0 : step_m;
      truth.path_m.push_back(place_m);
    }
  }
  return truth;
}

double cpu_ms() {
  timespec time{};
  (void)clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double median(std::vector<double>& values) {
  if (values.empty()) {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A place on an edge in the world, with what the scan said of it.
struct Seen {
  Eigen::Vector3d place_m;
  EdgePoint point;
};

/// The poses of one scan: as if it were taken at once for what lies within the same millisecond.
class ScanPoses {
 public:
  ScanPoses(const Trajectory& poses, const Scan& scan) : poses_(poses), scan_(scan) {}

  [[nodiscard]] std::optional<Eigen::Vector3d> to_world(const Eigen::Vector3d& place_m, float time_s) {
    const auto slot_ns = static_cast<Stamp>(std::floor(double{time_s} * 1e3)) * 1'000'000;
    if (!is_known_ || slot_ns != slot_ns_) {
      slot_ns_ = slot_ns;
      is_known_ = true;
      pose_ = poses_.at(scan_.stamp_ns + slot_ns + 500'000);
      if (pose_) {
        pose_ = *pose_ * scan_.T_base_sensor;
      }
    }
    return pose_ ? std::optional<Eigen::Vector3d>(*pose_ * place_m) : std::nullopt;
  }

 private:
  const Trajectory& poses_;
  const Scan& scan_;
  bool is_known_ = false;
  Stamp slot_ns_ = 0;
  std::optional<Pose> pose_;
};

/// One method on its way along a road.
class Passage {
 public:
  /// `measures_heights`: by a survey along the poses, at another millisecond a scan.
  Passage(const RoadMethod& method, const Trajectory& poses, bool measures_heights)
      : method_(method), map_(method.settings.map), reference_map_(method.settings.map) {
    if (measures_heights) {
      survey_.emplace(RoadConfig{}, poses);
    }
    if (method.is_reference) {
      detector_ = std::make_unique<RingEdges>(RingEdgesConfig{});
    } else {
      detector_ = std::make_unique<TraceEdges>(method.settings.edge);
    }
  }

  void process(const EdgeInput& input, const Scan& scan, const Trajectory& poses) {
    const double start_ms = cpu_ms();
    const EdgeResult result = detector_->process(input);
    const double found_ms = cpu_ms();
    ScanPoses scan_poses(poses, scan);
    edges_.clear();
    surveyed_.clear();
    plain_m_.clear();
    for (const EdgePoint& edge : result.edges) {
      const Eigen::Vector3d place_m(double{edge.x_m}, double{edge.y_m}, double{edge.z_m});
      if (const auto world_m = scan_poses.to_world(place_m, edge.time_s)) {
        edges_.push_back({*world_m, edge.side});
        surveyed_.push_back({*world_m, edge.height_m, edge.width_m, edge.kind});
        seen_.push_back({*world_m, edge});
      }
    }
    const PointsView& points = input.points;
    for (const std::uint32_t i : result.plain) {
      const Eigen::Vector3d place_m(double{points.x[i]}, double{points.y[i]}, double{points.z[i]});
      if (const auto world_m = scan_poses.to_world(place_m, points.time.empty() ? 0.0F : points.time[i])) {
        plain_m_.push_back(*world_m);
      }
    }
    if (method_.is_reference) {
      reference_map_.add_scan(edges_, plain_m_);
    } else {
      map_.add_scan(edges_, plain_m_);
    }
    detect_ms_.push_back(found_ms - start_ms);
    map_ms_.push_back(cpu_ms() - found_ms);
    if (survey_) {
      survey(input, scan, result, scan_poses);
    }
  }

  RoadScore judge(const Truth& truth) {
    RoadScore score;
    const double start_ms = cpu_ms();
    lines_ = extract_lines(method_.is_reference ? reference_map_.edges() : map_, method_.settings.lines);
    score.lines_ms = cpu_ms() - start_ms;
    if (survey_) {
      set_berm_heights(survey_->stations(lines_), lines_);
    }
    score.lines = judge_edges(lines_, truth.edges, truth.path_m, {});
    score.detect_ms = median(detect_ms_);
    score.map_ms = median(map_ms_);
    judge_heights(truth, score);
    return score;
  }

  void dump(const std::filesystem::path& folder) const;

 private:
  void judge_heights(const Truth& truth, RoadScore& score) const;

  /// What is solid and no plain road is for the berms.
  void survey(const EdgeInput& input, const Scan& scan, const EdgeResult& result, ScanPoses& poses) {
    const PointsView& points = input.points;
    std::vector<bool> is_plain(points.size(), false);
    for (const std::uint32_t i : result.plain) {
      is_plain[i] = true;
    }
    raised_m_.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Label label = input.labels[i];
      if (!is_plain[i] && (label == Label::drivable || label == Label::terrain || label == Label::obstacle)) {
        const Eigen::Vector3d place_m(double{points.x[i]}, double{points.y[i]}, double{points.z[i]});
        if (const auto world_m = poses.to_world(place_m, points.time.empty() ? 0.0F : points.time[i])) {
          raised_m_.push_back(*world_m);
        }
      }
    }
    survey_->add_scan(scan.stamp_ns, surveyed_, plain_m_, raised_m_);
  }

  const RoadMethod& method_;
  std::unique_ptr<EdgeDetector> detector_;
  EdgeMap map_;
  ReferenceEdgeMap reference_map_;
  std::vector<EdgeLine> lines_;
  std::vector<MappedEdge> edges_;
  std::vector<Eigen::Vector3d> plain_m_;
  std::optional<RoadSurvey> survey_;
  std::vector<SurveyedEdge> surveyed_;
  std::vector<Eigen::Vector3d> raised_m_;
  std::vector<Seen> seen_;
  std::vector<double> detect_ms_;
  std::vector<double> map_ms_;
};

/// At places a metre apart on the true edges: what the nearest vertex within a metre says.
void Passage::judge_heights(const Truth& truth, RoadScore& score) const {
  constexpr double kAround_m = 1.0;
  VoxelHash<std::vector<EdgeLine::Vertex>> cells(kAround_m);
  const auto flat = [](const Eigen::Vector3d& place_m) { return Eigen::Vector3d(place_m.x(), place_m.y(), 0.5); };
  for (const EdgeLine& line : lines_) {
    for (const EdgeLine::Vertex& vertex : line.vertices) {
      if (vertex.berm_height_m.value_or(0.0) > 0.0) {
        cells.at_or_new(*cells.key_of(flat(vertex.position_m))).push_back(vertex);
      }
    }
  }
  std::vector<double> errors_m;
  for (const EdgeLine& edge : truth.edges) {
    double next_m = 0.0;
    for (std::size_t i = 0; i + 1 < edge.vertices.size(); ++i) {
      const Eigen::Vector3d toe_m = flat(edge.vertices[i].position_m);
      const Eigen::Vector2d along_m = (edge.vertices[i + 1].position_m - edge.vertices[i].position_m).head<2>();
      next_m -= along_m.norm();
      if (next_m > 0.0) {
        continue;
      }
      next_m = 1.0;
      double nearest_m = kAround_m;
      std::optional<double> height_m;
      const VoxelKey middle = *cells.key_of(toe_m);
      for (int cell = 0; cell < 9; ++cell) {
        if (const auto* those = cells.find({middle.x + cell % 3 - 1, middle.y + cell / 3 - 1, middle.z})) {
          for (const EdgeLine::Vertex& vertex : *those) {
            const double off_m = (flat(vertex.position_m) - toe_m).norm();
            height_m = off_m < nearest_m ? vertex.berm_height_m : height_m;
            nearest_m = std::min(nearest_m, off_m);
          }
        }
      }
      const auto true_m = true_berm_height_beside_m(*truth.terrain, toe_m.head<2>(), along_m.normalized());
      if (true_m && height_m) {
        errors_m.push_back(std::abs(*height_m - *true_m));
      }
    }
  }
  score.heights = errors_m.size();
  if (!errors_m.empty()) {
    score.height_error_m = median(errors_m);
  }
}

void Passage::dump(const std::filesystem::path& folder) const {
  std::filesystem::create_directories(folder);
  std::ofstream lines(folder / "lines.csv");
  lines << "line,left,x,y,z,confidence,berm_height\n";
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    for (const EdgeLine::Vertex& vertex : lines_[i].vertices) {
      lines << fmt::format("{},{},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f}\n", i, lines_[i].side == EdgeSide::left ? 1 : 0,
                           vertex.position_m.x(), vertex.position_m.y(), vertex.position_m.z(), vertex.confidence,
                           vertex.berm_height_m.value_or(-1.0));
    }
  }
  std::ofstream points(folder / "points.csv");
  points << "x,y,z,left,drop,confidence,height,width,range,time\n";
  for (const Seen& seen : seen_) {
    points << fmt::format("{:.3f},{:.3f},{:.3f},{},{},{:.3f},{:.3f},{:.3f},{:.2f},{:.4f}\n", seen.place_m.x(),
                          seen.place_m.y(), seen.place_m.z(), seen.point.side == EdgeSide::left ? 1 : 0,
                          seen.point.kind == EdgeKind::drop ? 1 : 0, seen.point.confidence, seen.point.height_m,
                          seen.point.width_m, std::hypot(seen.point.x_m, seen.point.y_m), seen.point.time_s);
  }
}

MountConfig mount_of(const SensorSheet& sheet) {
  MountConfig mount;
  mount.height_m = sheet.height_m.value_or(0.0);
  mount.pitch_deg = sheet.pitch_rad.value_or(0.0) * 180.0 / std::numbers::pi;
  return mount;
}

void simulate(test::RunPlan& plan, const std::filesystem::path& folder) {
  sim::Scenario scenario = sim::read_scenario(std::filesystem::path(BERM_SCENARIOS) / (plan.scenario + ".yaml"));
  for (const std::string& setting : plan.settings) {
    (void)set_value(scenario, setting, plan.name);
  }
  scenario.scenario.seconds = plan.seconds;
  scenario.check();
  const sim::Sensor sensor = sim::read_sensor(std::filesystem::path(BERM_SENSORS) / (plan.sensor + ".yaml"));
  for (int attempt = 1;; ++attempt) {
    try {
      sim::SimulateOptions options;
      options.output = folder;
      options.seed = plan.seed;
      (void)sim::simulate(scenario, sensor, options);
      return;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::invalid_argument || attempt == kSeedsTried) {
        throw;
      }
      plan.seed += kSeedStep;
    }
  }
}

/// What a scan holds before edges are looked for, with the snow stage or without, as the chain of `berm run` does it.
class Labelled {
 public:
  explicit Labelled(bool with_snow) {
    if (with_snow) {
      snow_ = std::make_unique<SparseSnow>(SparseSnowConfig{});
    }
  }

  EdgeInput process(const Scan& scan) {
    PointsView points = scan.cloud.view();
    std::span<const std::uint8_t> falling;
    if (snow_) {
      falling = snow_->process(points, scan.T_base_sensor).falling;
      x_.assign(points.x.begin(), points.x.end());
      for (std::size_t i = 0; i < x_.size(); ++i) {
        x_[i] = falling[i] != 0 ? std::numeric_limits<float>::quiet_NaN() : x_[i];
      }
      points.x = x_;
    }
    const GroundResult found = ground_.process(points, scan.T_base_sensor);
    labels_.clear();
    for (std::size_t i = 0; i < found.classes.size(); ++i) {
      labels_.push_back(!falling.empty() && falling[i] != 0 ? Label::falling_snow : label_of(found.classes[i]));
    }
    return {
        .points = scan.cloud.view(), .labels = labels_, .surface = found.surface, .T_base_sensor = scan.T_base_sensor};
  }

 private:
  std::unique_ptr<SparseSnow> snow_;
  TerrainGround ground_{TerrainGroundConfig{}};
  std::vector<float> x_;
  std::vector<Label> labels_;
};

}  // namespace

RoadResult measure_recording(const std::filesystem::path& folder, const std::vector<RoadMethod>& methods,
                             const std::filesystem::path& dump_folder) {
  const Recording recording = Recording::open(folder);
  const Truth truth = read_truth(recording);
  const Trajectory poses = recording.read_given_poses().value().trajectory;
  RoadResult result;
  result.name = folder.filename().string();
  result.scans = recording.size();
  result.length_m = truth.length_m;
  std::vector<std::unique_ptr<Passage>> passages;
  passages.reserve(methods.size());
  for (const RoadMethod& method : methods) {
    passages.push_back(std::make_unique<Passage>(method, poses, passages.empty()));
  }
  Labelled bare(false);
  Labelled clean(true);
  const auto with_snow = [](const RoadMethod& method) { return method.with_snow; };
  const bool any_clean = std::any_of(methods.begin(), methods.end(), with_snow);
  const bool all_clean = std::all_of(methods.begin(), methods.end(), with_snow);
  Scan scan;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    recording.read(i, scan);
    scan.T_base_sensor = mount_of(recording.sheet()).T_base_sensor();
    result.points_a_scan += static_cast<double>(scan.cloud.size()) / static_cast<double>(recording.size());
    const EdgeInput with_all = all_clean ? EdgeInput{} : bare.process(scan);
    const EdgeInput without_flakes = any_clean ? clean.process(scan) : EdgeInput{};
    for (std::size_t m = 0; m < methods.size(); ++m) {
      passages[m]->process(methods[m].with_snow ? without_flakes : with_all, scan, poses);
    }
  }
  for (const auto& passage : passages) {
    result.scores.push_back(passage->judge(truth));
  }
  if (!dump_folder.empty()) {
    passages.front()->dump(dump_folder / result.name);
  }
  return result;
}

std::vector<RoadResult> measure_roads(const std::vector<test::RunPlan>& runs, const std::vector<RoadMethod>& methods,
                                      std::size_t threads, const std::filesystem::path& kept) {
  std::vector<RoadResult> results;
  OrderedParallel<RoadResult> work(
      runs.size(), threads,
      [&](std::size_t /*worker*/, std::size_t index, RoadResult& result) {
        test::RunPlan plan = runs[index];
        const test::TempFolder folder;
        const auto recording =
            kept.empty() ? folder.path() / "recording" : kept / fmt::format("{} {}", plan.name, plan.seed);
        // The last file of a recording that is whole.
        if (!std::filesystem::exists(recording / "sequence.json")) {
          simulate(plan, recording);
        }
        result = measure_recording(recording, methods, {});
        result.name = plan.name;
        result.seed = Recording::open(recording).sheet().seed.value_or(plan.seed);
      },
      [&results](std::size_t /*index*/, RoadResult& result) {
        results.push_back(std::move(result));
        return true;
      });
  work.run();
  return results;
}

}  // namespace berm::bench
