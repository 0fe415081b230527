#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "berm/io/datum.hpp"
#include "command_map.hpp"
#include "console.hpp"
#include "exit_code.hpp"

namespace berm::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kMapInfoExamples = R"(Examples:
  berm map info edges.ot
  berm map info edges.ot --json | jq .lines)";

/// A stretch of line that was not seen has this confidence, see `extract_lines`.
constexpr double kUnseen = 0.5;

struct SideSummary {
  std::size_t voxels = 0;  ///< that are edge
  std::size_t lines = 0;
  double length_m = 0.0;
  std::size_t gaps = 0;  ///< stretches that a line was carried across
  double gaps_m = 0.0;
};

struct MapSummary {
  std::size_t voxels = 0;
  Eigen::Vector3d low_m = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
  Eigen::Vector3d high_m = Eigen::Vector3d::Constant(std::numeric_limits<double>::lowest());
  SideSummary left;
  SideSummary right;
};

void add_line(const EdgeLine& line, SideSummary& side) {
  ++side.lines;
  bool was_seen = true;
  for (std::size_t i = 0; i + 1 < line.vertices.size(); ++i) {
    const EdgeLine::Vertex& a = line.vertices[i];
    const EdgeLine::Vertex& b = line.vertices[i + 1];
    const double length_m = (b.position_m - a.position_m).norm();
    const bool is_seen = a.confidence > kUnseen && b.confidence > kUnseen;
    side.length_m += length_m;
    side.gaps += was_seen && !is_seen ? 1U : 0U;
    side.gaps_m += is_seen ? 0.0 : length_m;
    was_seen = is_seen;
  }
}

MapSummary summarise(const EdgeMap& map, const EdgeLinesConfig& config) {
  MapSummary summary;
  summary.voxels = map.size();
  const double half_m = 0.5 * map.config().voxel_m;
  map.for_each([&](const VoxelKey& key, const EdgeMap::Voxel& voxel) {
    const Eigen::Vector3d center_m = voxel_center_m(key, map.config().voxel_m);
    summary.low_m = summary.low_m.cwiseMin(center_m - Eigen::Vector3d::Constant(half_m));
    summary.high_m = summary.high_m.cwiseMax(center_m + Eigen::Vector3d::Constant(half_m));
    summary.left.voxels += map.is_edge(voxel, EdgeSide::left) ? 1U : 0U;
    summary.right.voxels += map.is_edge(voxel, EdgeSide::right) ? 1U : 0U;
  });
  for (const EdgeLine& line : extract_lines(map, config)) {
    add_line(line, line.side == EdgeSide::left ? summary.left : summary.right);
  }
  return summary;
}

std::string side_text(const SideSummary& side) {
  return fmt::format("{} edge voxels, {} lines, {:.1f} m, of these {:.1f} m unseen in {} gaps", side.voxels, side.lines,
                     side.length_m, side.gaps_m, side.gaps);
}

std::string world_text(const EdgeMap& map) {
  if (const std::optional<Geodetic> datum = datum_of(map.world())) {
    return fmt::format("origin at latitude {} deg, longitude {} deg, height {} m (WGS 84)", datum->lat_deg,
                       datum->lon_deg, datum->h_m);
  }
  return map.world().empty() ? "not known" : map.world();
}

std::string to_text(const EdgeMap& map, const MapSummary& summary) {
  std::string text = fmt::format("world     {}\n", world_text(map));
  if (!map.empty()) {
    text +=
        fmt::format("extent    x {:.1f} to {:.1f}, y {:.1f} to {:.1f}, z {:.1f} to {:.1f} m\n", summary.low_m.x(),
                    summary.high_m.x(), summary.low_m.y(), summary.high_m.y(), summary.low_m.z(), summary.high_m.z());
  }
  text += fmt::format("voxels    {} of {} m\n", summary.voxels, map.config().voxel_m);
  text += "left      " + side_text(summary.left) + "\n";
  text += "right     " + side_text(summary.right) + "\n";
  text += fmt::format("memory    {:.1f} MB\n", static_cast<double>(map.memory_bytes()) / 1e6);
  return text;
}

/// To a tenth of a millimetre: no 0.20000000000000001.
double rounded(double value) {
  constexpr double kPerM = 1e4;
  return std::round(value * kPerM) / kPerM;
}

Json side_json(const SideSummary& side) {
  return {{"edge_voxels", side.voxels},
          {"lines", side.lines},
          {"length_m", rounded(side.length_m)},
          {"gaps", side.gaps},
          {"gaps_m", rounded(side.gaps_m)}};
}

std::string to_json_text(const EdgeMap& map, const MapSummary& summary) {
  const auto triple = [](const Eigen::Vector3d& place) {
    Json json = Json::array();
    for (const double value : {place.x(), place.y(), place.z()}) {
      json.push_back(rounded(value));
    }
    return json;
  };
  Json json;
  json["voxel_m"] = map.config().voxel_m;
  json["world"] = map.world();
  json["datum"] = nullptr;
  if (const std::optional<Geodetic> datum = datum_of(map.world())) {
    json["datum"] = {{"lat_deg", datum->lat_deg}, {"lon_deg", datum->lon_deg}, {"h_m", datum->h_m}};
  }
  json["extent_m"] = nullptr;
  if (!map.empty()) {
    json["extent_m"] = {{"low", triple(summary.low_m)}, {"high", triple(summary.high_m)}};
  }
  json["voxels"] = summary.voxels;
  json["left"] = side_json(summary.left);
  json["right"] = side_json(summary.right);
  json["memory_bytes"] = map.memory_bytes();
  return json.dump(2) + "\n";
}

struct MapInfoCommand {
  std::string map;
  bool json = false;
  LinesOption lines;
};

int execute_map_info(const MapInfoCommand& command) {
  const EdgeLinesConfig config = command.lines.choose();
  const EdgeMap map = read_map(command.map);
  const MapSummary summary = summarise(map, config);
  write_result("-", command.json ? to_json_text(map, summary) : to_text(map, summary));
  return kWhole;
}

}  // namespace

void add_map_info(CLI::App& app, int& exit_code) {
  auto command = std::make_shared<MapInfoCommand>();
  CLI::App* sub = app.add_subcommand("info", "Say what is in a map");
  sub->footer(kMapInfoExamples);
  sub->add_option("MAP", command->map, "Map of road edges (.ot)")->required()->type_name("FILE");
  sub->add_flag("--json", command->json, "One JSON object, for programs");
  command->lines.add_options(*sub);
  sub->callback([command, &exit_code] { exit_code = execute_map_info(*command); });
}

}  // namespace berm::app
