// berm_edge_accuracy RECORDING...: the edge points of single scans against the truth of simulated roads, the methods
// beside each other. With --dump FILE the points of the last method of the last recording go there.

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <fmt/format.h>

#include "berm/core/mount.hpp"
#include "berm/core/scan.hpp"
#include "berm/core/stamp.hpp"
#include "berm/edge/ring_edges.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "berm/io/recording.hpp"
#include "edge_score.hpp"

namespace berm::bench {
namespace {

struct Method {
  std::string name;
  std::function<std::unique_ptr<EdgeDetector>()> make;
};

std::vector<Method> all_methods() {
  return {{"reference: method E", [] { return std::make_unique<RingEdges>(RingEdgesConfig{}); }}};
}

Label to_label(GroundClass ground) {
  switch (ground) {
    case GroundClass::ground:
      return Label::drivable;
    case GroundClass::not_ground:
      return Label::obstacle;
    case GroundClass::no_return:
      return Label::no_return;
    case GroundClass::invalid:
      break;
  }
  return Label::unlabeled;
}

RoadTruth read_truth(const Recording& recording) {
  RoadTruth truth;
  truth.edges = read_edges(recording.path() / "edges.csv");
  truth.terrain = read_height_raster(recording.path() / "terrain.asc");
  const std::vector<StampedPose> poses = recording.read_truth_poses().value().poses();
  for (std::size_t i = 0; i < poses.size(); i += 50) {
    truth.path_m.push_back(poses[i].T_world_base.translation_m());
  }
  return truth;
}

/// The edges that every method finds in every `step`-th scan.
std::vector<std::vector<WorldEdge>> find_edges(const Recording& recording, const std::vector<Method>& methods,
                                               std::size_t step, std::size_t& scans) {
  const Trajectory poses = recording.read_truth_poses().value();
  TerrainGround ground{TerrainGroundConfig{}};
  std::vector<std::unique_ptr<EdgeDetector>> detectors;
  for (const Method& method : methods) {
    detectors.push_back(method.make());
  }
  std::vector<std::vector<WorldEdge>> found(methods.size());
  MountConfig mount;
  mount.height_m = recording.sheet().height_m.value_or(0.0);
  Scan scan;
  scans = 0;
  for (std::size_t i = 0; i < recording.size(); i += step) {
    recording.read(i, scan);
    scan.T_base_sensor = mount.T_base_sensor();
    const GroundResult result = ground.process(scan.cloud.view(), scan.T_base_sensor);
    std::vector<Label> labels;
    for (const GroundClass one : result.classes) {
      labels.push_back(to_label(one));
    }
    ++scans;
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const EdgeResult edges = detectors[m]->process({.points = scan.cloud.view(),
                                                      .labels = labels,
                                                      .surface = result.surface,
                                                      .T_base_sensor = scan.T_base_sensor});
      for (const EdgePoint& edge : edges.edges) {
        const auto pose = poses.at(scan.stamp_ns + static_cast<Stamp>(double{edge.time_s} * 1e9));
        if (pose) {
          found[m].push_back({edge, *pose * (scan.T_base_sensor *
                                             Eigen::Vector3d(double{edge.x_m}, double{edge.y_m}, double{edge.z_m}))});
        }
      }
    }
  }
  return found;
}

void print(const std::string& name, const EdgeScore& score) {
  fmt::print("{:<44} {:6.1f} {:8.2f} {:8.3f} {:7.2f} {:7.2f} {:7.1f} {:8.3f}\n", name,
             static_cast<double>(score.points) / static_cast<double>(std::max<std::size_t>(score.scans, 1)),
             100.0 * score.within, score.median_m, score.p95_m, 100.0 * score.wrong_side, 100.0 * score.seen,
             score.height_median_m);
}

int run(const std::vector<std::string>& folders, std::size_t step, const std::string& dump_file,
        const std::string& only) {
  std::vector<Method> methods = all_methods();
  std::erase_if(methods, [&](const Method& method) { return method.name.find(only) == std::string::npos; });
  fmt::print("{:<44} {:>6} {:>8} {:>8} {:>7} {:>7} {:>7} {:>8}\n", "", "a scan", "0.5 m, %", "median", "p95", "side, %",
             "seen, %", "height");
  for (const std::string& folder : folders) {
    const Recording recording = Recording::open(folder);
    const RoadTruth truth = read_truth(recording);
    std::size_t scans = 0;
    const auto found = find_edges(recording, methods, step, scans);
    for (std::size_t m = 0; m < methods.size(); ++m) {
      print(std::filesystem::path(folder).filename().string() + " " + methods[m].name, score(found[m], truth, scans));
    }
    if (!dump_file.empty() && !found.empty()) {
      dump(dump_file, found.back(), truth);
    }
  }
  return 0;
}

}  // namespace
}  // namespace berm::bench

int main(int argc, char** argv) {
  CLI::App app("Edge points of single scans against the truth of simulated roads");
  std::vector<std::string> folders;
  std::size_t step = 1;
  std::string dump_file;
  std::string only;
  app.add_option("recordings", folders)->required();
  app.add_option("--step", step, "every n-th scan")->check(CLI::PositiveNumber);
  app.add_option("--dump", dump_file);
  app.add_option("--only", only, "methods whose name holds this");
  CLI11_PARSE(app, argc, argv);
  return berm::bench::run(folders, step, dump_file, only);
}
