#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "berm/edge/edge.hpp"
#include "berm/map/edge_lines.hpp"
#include "berm/map/edge_map.hpp"

namespace berm::bench {

/// A way from scans to lines.
struct RoadMethod {
  std::string name;
  std::function<std::unique_ptr<EdgeDetector>()> make;
  EdgeMapConfig map;
  EdgeLinesConfig lines;
  bool reference_map = false;
};

/// The default, then the reference.
[[nodiscard]] std::vector<RoadMethod> main_road_methods();
/// The default with one step left out, or set otherwise.
[[nodiscard]] std::vector<RoadMethod> road_methods_without_a_step();

}  // namespace berm::bench
