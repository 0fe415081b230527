#include "run_graph.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "berm/io/atomic_file.hpp"
#include "berm/io/trajectory_file.hpp"
#include "scan_table.hpp"

namespace berm {
namespace {

/// "12 jump, 3 no scan"; empty where all were used.
template <typename Fate, std::size_t count>
std::string losses(const std::array<std::size_t, count>& counts) {
  std::string text;
  for (std::size_t i = 1; i < count; ++i) {  // the first fate is `used`
    if (counts[i] > 0) {
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[i], fate_name(static_cast<Fate>(i)));
    }
  }
  return text;
}

void note_fixes(const PoseGraphResult& result, RunSummary& summary) {
  const std::string lost = losses<FixFate>(result.fixes);
  summary.notes.push_back(fmt::format("trajectory_global.tum: {} fixes used{}{}", result.fixes[0],
                                      lost.empty() ? "" : ", left out: ", lost));
  if (result.bad_attitudes + result.lost_attitudes > 0) {
    summary.notes.push_back(fmt::format("trajectory_global.tum: attitudes of fixes left out: {} broken, {} outvoted",
                                        result.bad_attitudes, result.lost_attitudes));
  }
  if (result.is_in_world && !result.has_heading) {
    summary.notes.emplace_back("trajectory_global.tum: the fixes do not say how the path is turned about the vertical");
  }
}

void write_nodes(const PoseGraphResult& result, const OutputFolder& output) {
  AtomicFile file(output / "trajectory_global.csv");
  file.write("stamp,sigma_x_m,sigma_y_m,sigma_z_m,sigma_turn_rad\n");
  for (const GraphNode& node : result.nodes) {
    const Vector6d sigma = node.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    file.write(fmt::format("{},{:.4f},{:.4f},{:.4f},{:.6f}\n",
                           stamp_field(result.trajectory.poses()[node.step].stamp_ns), sigma[0], sigma[1], sigma[2],
                           sigma.tail<3>().maxCoeff()));
  }
  file.commit();
}

}  // namespace

PoseGraphResult write_global_trajectory(std::span<const OdometryStep> odometry, const PlaceMemory& places,
                                        const RunPoses* fixes, const PoseGraphConfig& config,
                                        const OutputFolder& output, RunFiles& files, RunSummary& summary) {
  std::vector<Fix> all;
  if (fixes != nullptr) {
    all = fixes_of(fixes->trajectory, config);
  }
  PoseGraphResult result = solve_pose_graph(odometry, all, {}, config);
  const FoundClosures found = places.find(odometry, result, config);
  if (!found.closures.empty()) {
    result = solve_pose_graph(odometry, all, found.closures, config);
  }
  for (std::size_t i = 0; i < kClosureFates; ++i) {
    result.closures[i] += found.rejected[i];
  }
  for (const std::string& note : result.notes) {
    summary.notes.push_back("trajectory_global.tum: " + note);
  }
  if (fixes != nullptr) {
    note_fixes(result, summary);
  }
  const std::string lost = losses<ClosureFate>(result.closures);
  if (result.closures[0] > 0 || !lost.empty()) {
    summary.notes.push_back(fmt::format("trajectory_global.tum: {} places were passed again{}{}", result.closures[0],
                                        lost.empty() ? "" : ", pairs that were left out: ", lost));
  }
  if (result.trajectory.empty() || (!result.is_in_world && result.closures[0] == 0)) {
    return result;
  }
  write_tum(output / "trajectory_global.tum", result.trajectory);
  files.emplace_back("trajectory_global", "trajectory_global.tum");
  write_nodes(result, output);
  files.emplace_back("trajectory_global_sigma", "trajectory_global.csv");
  return result;
}

}  // namespace berm
