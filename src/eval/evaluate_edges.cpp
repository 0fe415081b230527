#include "evaluate_edges.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <vector>

#include "berm/eval/trajectory_metrics.hpp"
#include "berm/io/edge_lines_file.hpp"
#include "berm/io/edges_file.hpp"
#include "berm/io/trajectory_file.hpp"
#include "is_there.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

/// Half of the poses of a run and of truth that are farther apart than this lie in different worlds.
constexpr double kOtherWorld_m = 50.0;

std::vector<EdgeLine> to_lines(const std::vector<Edge>& edges) {
  std::vector<EdgeLine> lines;
  lines.reserve(edges.size());
  for (const Edge& edge : edges) {
    EdgeLine& line = lines.emplace_back();
    line.side = edge.left ? EdgeSide::left : EdgeSide::right;
    for (const Eigen::Vector3d& vertex_m : edge.vertices_m) {
      line.vertices.push_back({vertex_m});
    }
  }
  return lines;
}

std::vector<Eigen::Vector3d> places_m(const Trajectory& trajectory) {
  std::vector<Eigen::Vector3d> places;
  places.reserve(trajectory.size());
  for (const StampedPose& pose : trajectory.poses()) {
    places.push_back(pose.T_world_base.translation_m());
  }
  return places;
}

bool are_of_other_worlds(const std::vector<PosePair>& pairs) {
  const auto far = std::count_if(pairs.begin(), pairs.end(), [](const PosePair& pair) {
    const Eigen::Vector3d between_m = pair.estimate.translation_m() - pair.truth.translation_m();
    return between_m.head<2>().norm() > kOtherWorld_m;
  });
  return 2 * static_cast<std::size_t>(far) > pairs.size();
}

/// Where the machine was; empty, with the reason, if the run is in another world or nothing says where.
std::vector<Eigen::Vector3d> find_path_m(const fs::path& run_folder, const Recording& recording, std::string& reason) {
  const auto truth = recording.read_truth_poses();
  // With fixes, edges lie in their world, and trajectory.tum begins at the first scan.
  const bool is_joined = is_there(run_folder / "trajectory_global.tum");
  const fs::path file = run_folder / (is_joined ? "trajectory_global.tum" : "trajectory.tum");
  if (!is_there(file)) {
    reason = "neither trajectory.tum of the run nor truth.tum says where the machine was";
    return truth ? places_m(*truth) : std::vector<Eigen::Vector3d>();
  }
  const Trajectory driven = read_tum(file);
  const std::vector<PosePair> pairs = truth ? pair_poses(driven, *truth) : std::vector<PosePair>();
  if (pairs.empty()) {
    reason = file.filename().string() + " of the run is empty";
    return places_m(driven);
  }
  if (are_of_other_worlds(pairs)) {
    reason = "the poses of the run lie more than 50 m from truth.tum: another world frame";
    return {};
  }
  std::vector<Eigen::Vector3d> path_m;
  path_m.reserve(pairs.size());
  std::transform(pairs.begin(), pairs.end(), std::back_inserter(path_m),
                 [](const PosePair& pair) { return pair.truth.translation_m(); });
  return path_m;
}

}  // namespace

EdgeEvaluation evaluate_edges(const fs::path& run_folder, const Recording& recording) {
  if (!is_there(run_folder / "edges.csv")) {
    return {.reason = "the run has no edges.csv"};
  }
  if (!is_there(recording.path() / "edges.csv")) {
    return {.reason = "the recording has no edges.csv"};
  }
  EdgeEvaluation evaluation;
  const std::vector<Eigen::Vector3d> path_m = find_path_m(run_folder, recording, evaluation.reason);
  if (path_m.empty()) {
    return evaluation;
  }
  const std::vector<EdgeLine> truth = to_lines(read_edges(recording.path() / "edges.csv"));
  return {.score = judge_edges(read_edge_lines(run_folder / "edges.csv"), truth, path_m)};
}

}  // namespace berm
