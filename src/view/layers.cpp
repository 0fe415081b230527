#include "layers.hpp"

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include <nlohmann/json.hpp>

#include "berm/io/edge_lines_file.hpp"
#include "berm/io/edges_file.hpp"
#include "berm/io/file_reader.hpp"
#include "berm/map/edge_map.hpp"
#include "byte_writer.hpp"

namespace berm {
namespace {

using Json = nlohmann::ordered_json;

void append_row(std::string& table, const ShownScan& scan, const std::optional<Pose>& T_world_base,
                const Eigen::Vector3d& origin_m) {
  append_bytes(table, scan.stamp_ns);
  append_bytes(table, scan.points);
  std::array<float, 7> pose{};
  pose.fill(std::numeric_limits<float>::quiet_NaN());
  if (T_world_base) {
    const Eigen::Vector3f t_m = (T_world_base->translation_m() - origin_m).cast<float>();
    const Eigen::Vector4f q = T_world_base->rotation().coeffs().cast<float>();  // x y z w
    pose = {t_m.x(), t_m.y(), t_m.z(), q[0], q[1], q[2], q[3]};
  }
  append_array<float>(table, pose);
  append_bytes(table, static_cast<std::uint32_t>(scan.health));  // the health and three zeros
}

std::vector<EdgeLine> read_truth_lines(const std::filesystem::path& file) {
  std::vector<EdgeLine> lines;
  for (const Edge& edge : read_edges(file)) {
    EdgeLine line{edge.left ? EdgeSide::left : EdgeSide::right, {}};
    for (const Eigen::Vector3d& vertex_m : edge.vertices_m) {
      line.vertices.push_back({vertex_m, 1.0});
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Millimetres are enough, and a tenth of the text.
double rounded(double value, double step) {
  return std::round(value / step) * step;
}

Json to_feature(const EdgeLine& line, std::size_t number, const Eigen::Vector3d& origin_m) {
  Json coordinates = Json::array();
  Json confidence = Json::array();
  for (const EdgeLine::Vertex& vertex : line.vertices) {
    const Eigen::Vector3d p_m = vertex.position_m - origin_m;
    coordinates.push_back({rounded(p_m.x(), 1e-3), rounded(p_m.y(), 1e-3), rounded(p_m.z(), 1e-3)});
    confidence.push_back(rounded(vertex.confidence, 1e-3));
  }
  return {{"type", "Feature"},
          {"properties",
           {{"line", number},
            {"side", line.side == EdgeSide::left ? "left" : "right"},
            {"confidence", std::move(confidence)}}},
          {"geometry", {{"type", "LineString"}, {"coordinates", std::move(coordinates)}}}};
}

}  // namespace

std::string make_scan_table(std::span<const ShownScan> scans, const Trajectory& trajectory,
                            const Eigen::Vector3d& origin_m) {
  std::string table;
  append_bytes(table, static_cast<std::uint32_t>(scans.size()));
  for (const ShownScan& scan : scans) {
    append_row(table, scan, trajectory.at(scan.stamp_ns), origin_m);
  }
  return table;
}

std::string make_pose_table(const Trajectory& trajectory, const Eigen::Vector3d& origin_m) {
  std::string table;
  append_bytes(table, static_cast<std::uint32_t>(trajectory.size()));
  for (const StampedPose& pose : trajectory.poses()) {
    append_row(table, ShownScan{.name = {}, .stamp_ns = pose.stamp_ns}, pose.T_world_base, origin_m);
  }
  return table;
}

std::string make_edges_json(const std::filesystem::path& file, bool truth, const Eigen::Vector3d& origin_m) {
  const std::vector<EdgeLine> lines = truth ? read_truth_lines(file) : read_edge_lines(file);
  Json features = Json::array();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    features.push_back(to_feature(lines[i], i, origin_m));
  }
  const Json collection = {{"type", "FeatureCollection"},
                           {"origin", {origin_m.x(), origin_m.y(), origin_m.z()}},
                           {"truth", truth},
                           {"features", std::move(features)}};
  return collection.dump();
}

std::string make_octree_payload(const std::filesystem::path& file, const Eigen::Vector3d& origin_m) {
  FileBuffer buffer;
  read_file(file, buffer);
  const EdgeMap map = EdgeMap::from_octomap(buffer.text(), file.string(), {});
  const auto size_m = static_cast<float>(map.config().voxel_m);
  std::string payload;
  std::uint32_t count = 0;
  append_bytes(payload, count);
  map.for_each([&](const VoxelKey& key, const EdgeVoxel& voxel) {
    if (voxel.left == 0 && voxel.right == 0) {
      return;
    }
    const Eigen::Vector3d middle_m =
        (Eigen::Vector3d(key.x, key.y, key.z).array() + 0.5).matrix() * map.config().voxel_m - origin_m;
    for (const double coordinate_m : middle_m) {
      append_bytes(payload, static_cast<float>(coordinate_m));
    }
    append_bytes(payload, size_m);
    append_bytes(payload, static_cast<std::uint8_t>(voxel.right > voxel.left));
    const double probability = 1.0 / (1.0 + std::exp(-map.log_odds(voxel)));
    append_bytes(payload, static_cast<std::uint8_t>(std::lround(probability * 255.0)));
    append_bytes(payload, std::uint16_t{0});
    ++count;
  });
  std::memcpy(payload.data(), &count, sizeof(count));
  return payload;
}

}  // namespace berm
