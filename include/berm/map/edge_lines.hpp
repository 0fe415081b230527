#pragma once

#include <vector>

#include "berm/core/config.hpp"
#include "berm/core/edge.hpp"
#include "berm/map/edge_map.hpp"

namespace berm {

/// Settings of turning voxels into lines.
struct EdgeLinesConfig {
  double spacing_m = 0.5;
  double max_gap_m = 11.0;
  double max_hidden_m = 25.0;
  double min_length_m = 3.0;

  static void fields(auto&& field) {
    field("spacing_m", &EdgeLinesConfig::spacing_m, Range{0.05, 10.0}, "between vertices");
    field("max_gap_m", &EdgeLinesConfig::max_gap_m, Range{0.1, 50.0},
          "a line is carried on across gaps up to this: less than a road that leaves is wide");
    field("max_hidden_m", &EdgeLinesConfig::max_hidden_m, Range{0.1, 100.0},
          "and so far where nothing was seen, behind parked trucks");
    field("min_length_m", &EdgeLinesConfig::min_length_m, Range{0.0, 1000.0},
          "shorter lines are left out; what is half sure counts half");
  }
  void check() const { check_fields(*this, "lines"); }
};

/// The edges of a map as lines: ordered along the edge, smooth within the noise and not beyond, gaps kept as gaps. A
/// line runs as who drives with the edge on its side: the road lies to the right of a left edge. The confidence of a
/// vertex is the probability, clamped as in the map, that there is an edge in the half metre around it (a metre where
/// little was seen); 0.5 on a stretch that was not seen. The same map gives the same lines. Throws ConfigError as
/// `EdgeLinesConfig::check`.
[[nodiscard]] std::vector<EdgeLine> extract_lines(const EdgeMap& map, const EdgeLinesConfig& config);

}  // namespace berm
