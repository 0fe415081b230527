#include "map_parts.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <nlohmann/json.hpp>

namespace berm {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kPoses = 2000;
constexpr std::size_t kVertices = 4000;

double centimetres(double value_m) {
  return std::round(value_m * 100.0) / 100.0;
}

/// Noise of the poses makes a standing machine travel: steps count once they add up to this.
constexpr double kStep_m = 0.5;

double path_length_m(const std::vector<StampedPose>& poses) {
  double sum_m = 0.0;
  Eigen::Vector3d last_m = poses.empty() ? Eigen::Vector3d::Zero() : poses.front().T_world_base.translation_m();
  for (const StampedPose& pose : poses) {
    const double step_m = (pose.T_world_base.translation_m() - last_m).norm();
    if (step_m >= kStep_m) {
      sum_m += step_m;
      last_m = pose.T_world_base.translation_m();
    }
  }
  return sum_m;
}

/// Every `stride`-th of `count`, and the last.
template <typename Take>
void each_kept(std::size_t count, std::size_t stride, Take take) {
  for (std::size_t i = 0; i < count; i += stride) {
    take(i);
  }
  if (count > 0 && (count - 1) % stride != 0) {
    take(count - 1);
  }
}

void put_position(Json& json, const Eigen::Vector3d& position_m) {
  json["x_m"].push_back(centimetres(position_m.x()));
  json["y_m"].push_back(centimetres(position_m.y()));
  json["z_m"].push_back(centimetres(position_m.z()));
}

}  // namespace

nlohmann::ordered_json trajectory_part(const Trajectory& trajectory, Stamp start_ns, const Eigen::Vector3d& origin_m) {
  const std::vector<StampedPose>& poses = trajectory.poses();
  Json json = {{"poses", poses.size()}, {"path_m", centimetres(path_length_m(poses))}};
  each_kept(poses.size(), poses.size() / kPoses + 1, [&](std::size_t i) {
    json["t_s"].push_back(std::round(to_seconds(poses[i].stamp_ns - start_ns) * 1e4) / 1e4);
    put_position(json, poses[i].T_world_base.translation_m() - origin_m);
  });
  return json;
}

nlohmann::ordered_json edges_part(std::span<const EdgeLine> lines, const Eigen::Vector3d& origin_m) {
  std::size_t vertices = 0;
  for (const EdgeLine& line : lines) {
    vertices += line.vertices.size();
  }
  Json json = Json::array();
  for (const EdgeLine& line : lines) {
    Json shown = {{"side", line.side == EdgeSide::left ? "left" : "right"}};
    each_kept(line.vertices.size(), vertices / kVertices + 1,
              [&](std::size_t i) { put_position(shown, line.vertices[i].position_m - origin_m); });
    json.push_back(std::move(shown));
  }
  return json;
}

}  // namespace berm
