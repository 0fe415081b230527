#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "berm/core/edge.hpp"
#include "berm/io/datum.hpp"

namespace berm {

[[nodiscard]] std::string_view side_name(EdgeSide side);

/// Throws Error(invalid_argument) for what no file of edges can hold, see `write_edge_lines`.
void check_edge_lines(std::span<const EdgeLine> lines);

/// A line, or the part of one on one side of the date line, on the earth.
struct GeoLine {
  struct Vertex {
    Geodetic place;
    double confidence = 1.0;
    std::optional<double> berm_height_m = std::nullopt;
  };

  std::size_t number = 0;  ///< of the line that it is a part of
  EdgeSide side = EdgeSide::left;
  std::vector<Vertex> vertices;
};

/// The lines on the earth, cut at the date line. Throws Error(invalid_argument) for a vertex too far from the datum.
[[nodiscard]] std::vector<GeoLine> to_geo_lines(std::span<const EdgeLine> lines, const LocalFrame& frame);

/// `value` at `decimals`, so that its shortest text has no more of them; never -0.
[[nodiscard]] double rounded(double value, int decimals);

}  // namespace berm
