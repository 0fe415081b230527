#include "edges_json.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "berm/core/edge.hpp"
#include "berm/io/road_file.hpp"

namespace berm {
namespace {

using Json = nlohmann::ordered_json;

/// Whole milliseconds, or millimetres.
double thousandths(double value) {
  return std::round(value * 1e3) / 1e3;
}

Json describe(const PoseLogCounts& counts) {
  return {{"records", counts.records},      {"bad_checksum", counts.bad_checksum}, {"malformed", counts.malformed},
          {"no_fix", counts.no_fix},        {"poor_fix", counts.poor_fix},         {"no_attitude", counts.no_attitude},
          {"not_rising", counts.not_rising}};
}

/// Reasons without a value are left out.
template <typename Value>
Json by_reason(const std::array<Value, kPoseTrusts>& values) {
  Json json = Json::object();
  for (std::size_t reason = 0; reason < kPoseTrusts; ++reason) {
    if (values[reason] > Value{}) {
      std::string name(trust_name(static_cast<PoseTrust>(reason)));
      std::replace(name.begin(), name.end(), ' ', '_');
      json[name] = values[reason];
    }
  }
  return json;
}

/// Verdicts that no station has are left out.
Json by_verdict(const std::array<std::size_t, kRuleVerdicts>& stations) {
  Json json = Json::object();
  for (std::size_t verdict = 0; verdict < kRuleVerdicts; ++verdict) {
    if (stations[verdict] > 0) {
      const std::string_view name = verdict_name(static_cast<RuleVerdict>(verdict));
      json[name.empty() ? "unknown" : std::string(name)] = stations[verdict];
    }
  }
  return json;
}

Json describe(const RoadCounts& road) {
  return {{"stations", road.stations},
          {"width_rule", by_verdict(road.width)},
          {"grade_rule", by_verdict(road.grade)},
          {"left_berm_rule", by_verdict(road.left_berm)},
          {"right_berm_rule", by_verdict(road.right_berm)}};
}

}  // namespace

Json to_json(const PoseFigures& poses) {
  Json json = {{"file", poses.file}, {"poses", poses.poses}, {"jumps", poses.jumps}};
  std::array<double, kPoseTrusts> distrusted_s = poses.distrusted_s;
  std::transform(distrusted_s.begin(), distrusted_s.end(), distrusted_s.begin(), thousandths);
  json["distrusted_s"] = by_reason(distrusted_s);
  if (poses.datum) {
    json["datum"] = {{"lat_deg", poses.datum->lat_deg}, {"lon_deg", poses.datum->lon_deg}, {"h_m", poses.datum->h_m}};
  }
  if (poses.log) {
    json["log"] = describe(*poses.log);
  }
  return json;
}

Json to_json(const SurfaceCounts& surface) {
  Json json = {{"scans_mapped", surface.mapped},
               {"scans_not_mapped", by_reason(surface.not_mapped)},
               {"points", surface.points},
               {"points_left_out", surface.left_out},
               {"voxels", surface.voxels},
               {"voxels_moved", surface.moved},
               {"tiles", surface.tiles},
               {"origin_m", surface.origin_m},
               {"elevation_cells", surface.elevation_cells}};
  if (surface.median_depth_m) {
    json["snow_depth"] = {{"cells", surface.depth_cells}, {"median_m", thousandths(*surface.median_depth_m)}};
  }
  return json;
}

Json to_json(const EdgeCounts& edges) {
  Json json = {{"points", edges.points}};
  if (!edges.has_map) {
    return json;
  }
  json["scans_mapped"] = edges.mapped;
  json["scans_not_mapped"] = by_reason(edges.not_mapped);
  json["points_left_out"] = edges.left_out;
  json["world"] = edges.world;
  json["voxels"] = edges.voxels;
  for (const EdgeSide side : {EdgeSide::left, EdgeSide::right}) {
    const auto i = static_cast<std::size_t>(side);
    json[side == EdgeSide::left ? "left" : "right"] = {{"lines", edges.lines[i]},
                                                       {"km", thousandths(edges.lines_m[i] * 1e-3)}};
  }
  json["road"] = describe(edges.road);
  return json;
}

}  // namespace berm
