// berm_edge_accuracy RECORDING...: the edge points of single scans against the truth of simulated roads, the methods
// beside each other. With --dump FILE the points of the last method of the last recording go there.

#include <algorithm>
#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <fmt/format.h>

#include "berm/core/mount.hpp"
#include "berm/core/scan.hpp"
#include "berm/core/stamp.hpp"
#include "berm/edge/ring_edges.hpp"
#include "berm/edge/trace_edges.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/recording.hpp"
#include "berm_height.hpp"
#include "edge_kerbs.hpp"
#include "edge_score.hpp"

namespace berm::bench {
namespace {

struct Method {
  std::string name;
  std::function<std::unique_ptr<EdgeDetector>()> make;
};

Method trace_edges(std::string name, const std::function<void(TraceEdgesConfig&)>& change) {
  TraceEdgesConfig config;
  change(config);
  return {std::move(name), [config] { return std::make_unique<TraceEdges>(config); }};
}

std::vector<Method> all_methods() {
  using C = TraceEdgesConfig;
  return {{"reference: method E", [] { return std::make_unique<RingEdges>(RingEdgesConfig{}); }},
          trace_edges("default", [](C&) {}),
          trace_edges("without across", [](C& c) { c.across = false; }),
          trace_edges("without sub_cell", [](C& c) { c.sub_cell = false; }),
          trace_edges("without own_road", [](C& c) { c.own_road = false; }),
          trace_edges("without face", [](C& c) { c.face = false; }),
          trace_edges("without hide", [](C& c) { c.hide = false; }),
          trace_edges("without agree", [](C& c) { c.agree = false; }),
          trace_edges("without outline", [](C& c) { c.outline = false; }),
          trace_edges("without find_drops", [](C& c) { c.find_drops = false; }),
          trace_edges("min_run_m 2", [](C& c) { c.min_run_m = 2.0; }),
          trace_edges("road_noise_m 0.03", [](C& c) { c.road_noise_m = 0.03; }),
          trace_edges("max_road_slope 0.08", [](C& c) { c.max_road_slope = 0.08; }),
          trace_edges("min_height_m 0.4", [](C& c) { c.min_height_m = 0.4; }),
          trace_edges("min_flank_slope 0.15", [](C& c) { c.min_flank_slope = 0.15; }),
          trace_edges("min_radius_m 80", [](C& c) { c.min_radius_m = 80.0; })};
}

/// For streets: a kerb is a decimetre high, and its flank a step.
std::vector<Method> kerb_methods() {
  using C = TraceEdgesConfig;
  const auto street = [](C& c) {
    c.min_height_m = 0.06;
    c.flank_m = 1.0;
    c.max_range_m = 25.0;
  };
  return {{"reference: method E", [] { return std::make_unique<RingEdges>(RingEdgesConfig{}); }},
          trace_edges("default", [](C&) {}),
          trace_edges("default, min_height_m 0.06, flank_m 1", street)};
}

RoadTruth read_truth(const Recording& recording) {
  RoadTruth truth;
  truth.edges = read_edges(recording.path() / "edges.csv");
  truth.terrain = read_true_terrain(recording.path());
  const std::vector<StampedPose> poses = recording.read_truth_poses().value().poses();
  for (std::size_t i = 0; i < poses.size(); i += 50) {
    truth.path_m.push_back(poses[i].T_world_base.translation_m());
  }
  return truth;
}

/// Takes scans one by one through the ground stage.
class Ground {
 public:
  EdgeInput process(const Scan& scan) {
    const GroundResult result = ground_.process(scan.cloud.view(), scan.T_base_sensor);
    labels_.clear();
    for (const GroundClass one : result.classes) {
      labels_.push_back(label_of(one));
    }
    return {
        .points = scan.cloud.view(), .labels = labels_, .surface = result.surface, .T_base_sensor = scan.T_base_sensor};
  }

 private:
  TerrainGround ground_{TerrainGroundConfig{}};
  std::vector<Label> labels_;
};

MountConfig mount_of(const SensorSheet& sheet, double height_m) {
  MountConfig mount;
  mount.height_m = sheet.height_m.value_or(height_m);
  mount.pitch_deg = sheet.pitch_rad.value_or(0.0) * 180.0 / std::numbers::pi;
  return mount;
}

/// The edges that every method finds in every `step`-th scan.
std::vector<std::vector<WorldEdge>> find_edges(const Recording& recording, const std::vector<Method>& methods,
                                               std::size_t step, std::size_t& scans) {
  const Trajectory poses = recording.read_truth_poses().value();
  Ground ground;
  std::vector<std::unique_ptr<EdgeDetector>> detectors;
  detectors.reserve(methods.size());
  for (const Method& method : methods) {
    detectors.push_back(method.make());
  }
  std::vector<std::vector<WorldEdge>> found(methods.size());
  Scan scan;
  scans = 0;
  for (std::size_t i = 0; i < recording.size(); i += step) {
    recording.read(i, scan);
    scan.T_base_sensor = mount_of(recording.sheet(), 0.0).T_base_sensor();
    const EdgeInput input = ground.process(scan);
    ++scans;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      for (const EdgePoint& edge : detectors[m]->process(input).edges) {
        const auto pose = poses.at(scan.stamp_ns + static_cast<Stamp>(double{edge.time_s} * 1e9));
        if (pose) {
          const Eigen::Vector3d place(double{edge.x_m}, double{edge.y_m}, double{edge.z_m});
          found[m].push_back({edge, *pose * (scan.T_base_sensor * place)});
        }
      }
    }
  }
  return found;
}

void print(const std::string& name, const EdgeScore& score) {
  fmt::print("{:<44} {:6.1f} {:8.2f} {:8.3f} {:7.2f} {:7.2f} {:7.1f} {:8.3f}\n", name, score.points_a_scan,
             100.0 * score.within, score.median_m, score.p95_m, 100.0 * score.wrong_side, 100.0 * score.seen,
             score.height_median_m);
}

void add_to(EdgeScore& sum, const EdgeScore& one, double weight) {
  sum.scans = 1;
  sum.points_a_scan += weight * one.points_a_scan;
  sum.within += weight * one.within;
  sum.median_m += weight * one.median_m;
  sum.p95_m += weight * one.p95_m;
  sum.wrong_side += weight * one.wrong_side;
  sum.seen += weight * one.seen;
  sum.height_median_m += weight * one.height_median_m;
}

/// The first two methods on every recording, then the means of all over the recordings.
void run_roads(const std::vector<std::string>& folders, const std::vector<Method>& methods, std::size_t step,
               const std::string& dump_file) {
  fmt::print("{:<44} {:>6} {:>8} {:>8} {:>7} {:>7} {:>7} {:>8}\n", "", "a scan", "0.5 m, %", "median", "p95", "side, %",
             "seen, %", "height");
  std::vector<EdgeScore> means(methods.size());
  for (const std::string& folder : folders) {
    const Recording recording = Recording::open(folder);
    const RoadTruth truth = read_truth(recording);
    std::size_t scans = 0;
    const auto found = find_edges(recording, methods, step, scans);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const EdgeScore one = score(found[m], truth, scans);
      add_to(means[m], one, 1.0 / static_cast<double>(folders.size()));
      if (m < 2) {
        print(std::filesystem::path(folder).filename().string() + " " + methods[m].name, one);
      }
    }
    if (!dump_file.empty() && !found.empty()) {
      dump(dump_file, found.back(), truth);
    }
  }
  for (std::size_t m = 0; m < methods.size(); ++m) {
    print("mean " + methods[m].name, means[m]);
  }
}

void run_kerbs(const std::vector<std::string>& folders, const std::vector<Method>& methods) {
  constexpr double kCarSensor_m = 1.73;
  fmt::print("{:<44} {:>10} {:>10}\n", "kerbs", "precision", "recall");
  for (const std::string& folder : folders) {
    const Recording recording = Recording::open(folder);
    for (const Method& method : methods) {
      Ground ground;
      const std::unique_ptr<EdgeDetector> detector = method.make();
      KerbCounts counts;
      Scan scan;
      for (std::size_t i = 0; i < recording.size(); ++i) {
        const std::optional<std::filesystem::path> labels = recording.scan(i).truth_labels;
        if (!labels) {
          continue;
        }
        recording.read(i, scan);
        scan.T_base_sensor = mount_of(recording.sheet(), kCarSensor_m).T_base_sensor();
        const auto truth = read_labels(*labels, scan.cloud.size());
        count_kerbs(scan.cloud.view(), truth, detector->process(ground.process(scan)).edges, counts);
      }
      const auto percent = [](std::size_t part, std::size_t whole) {
        return 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(whole, 1));
      };
      fmt::print("{:<44} {:>10.1f} {:>10.1f}\n", method.name, percent(counts.found_true, counts.found),
                 percent(counts.kerbs_seen, counts.kerbs));
    }
  }
}

}  // namespace
}  // namespace berm::bench

int main(int argc, char** argv) {
  CLI::App app("Edge points of single scans against the truth of simulated roads, or against kerbs in labels");
  std::vector<std::string> folders;
  std::size_t step = 1;
  std::string dump_file;
  std::string only;
  bool kerbs = false;
  app.add_option("recordings", folders)->required();
  app.add_option("--step", step, "every n-th scan")->check(CLI::PositiveNumber);
  app.add_option("--dump", dump_file);
  app.add_option("--only", only, "methods whose name holds this");
  app.add_flag("--kerbs", kerbs, "labels of SemanticKITTI are the truth");
  CLI11_PARSE(app, argc, argv);
  std::vector<berm::bench::Method> methods = kerbs ? berm::bench::kerb_methods() : berm::bench::all_methods();
  std::erase_if(methods, [&](const auto& method) { return method.name.find(only) == std::string::npos; });
  if (kerbs) {
    berm::bench::run_kerbs(folders, methods);
  } else {
    berm::bench::run_roads(folders, methods, step, dump_file);
  }
  return 0;
}
