#pragma once

#include <string>
#include <vector>

#include "berm/edge/trace_edges.hpp"
#include "berm/map/edge_lines.hpp"
#include "berm/map/edge_map.hpp"

namespace berm::bench {

/// All that can be set on the way from scans to lines; `set_value` takes it.
struct RoadSettings {
  TraceEdgesConfig edge;
  EdgeMapConfig map;
  EdgeLinesConfig lines;

  static void sections(auto&& section) {
    section("edge", &RoadSettings::edge);
    section("map", &RoadSettings::map);
    section("lines", &RoadSettings::lines);
  }
  void check() const {
    edge.check();
    map.check();
    lines.check();
  }
};

/// A way from scans to lines.
struct RoadMethod {
  std::string name;
  RoadSettings settings;
  bool is_reference = false;  ///< detector and map as published; the lines as by default
  bool with_snow = true;      ///< the snow stage before the others, which takes dust for snow
};

/// The default, with other values for keys: "section.key=value".
[[nodiscard]] RoadMethod road_method(std::string name, const std::vector<std::string>& changes);
/// The default, then the reference.
[[nodiscard]] std::vector<RoadMethod> main_road_methods();
/// The default, then the same with the snow stage.
[[nodiscard]] std::vector<RoadMethod> dust_methods();
/// The default with one step left out, or set otherwise.
[[nodiscard]] std::vector<RoadMethod> changed_road_methods();

}  // namespace berm::bench
