#include <cstddef>
#include <string>

#include <fmt/format.h>

#include "edge_formats.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

/// Lanelet2 makes metres of it again: 0.1 mm.
constexpr int kOsmDegreeDecimals = 9;

std::string fixed(double value, int decimals) {
  std::string text;
  append_fixed(text, value, decimals);
  return text;
}

std::string tag(std::string_view indent, std::string_view key, std::string_view value) {
  return fmt::format("{}<tag k=\"{}\" v=\"{}\"/>\n", indent, key, value);
}

std::string node(std::size_t id, const GeoLine::Vertex& vertex) {
  const std::string height =
      vertex.berm_height_m ? tag("    ", "berm_height", fixed(*vertex.berm_height_m, kMetreDecimals)) : "";
  return fmt::format("  <node id=\"{}\" visible=\"true\" version=\"1\" lat=\"{}\" lon=\"{}\">\n{}{}{}  </node>\n", id,
                     fixed(vertex.place.lat_deg, kOsmDegreeDecimals), fixed(vertex.place.lon_deg, kOsmDegreeDecimals),
                     tag("    ", "ele", fixed(vertex.place.h_m, kMetreDecimals)),
                     tag("    ", "confidence", fixed(vertex.confidence, kConfidenceDecimals)), height);
}

std::string way(std::size_t id, std::size_t first_node, const GeoLine& line) {
  std::string text = fmt::format("  <way id=\"{}\" visible=\"true\" version=\"1\">\n", id);
  for (std::size_t i = 0; i < line.vertices.size(); ++i) {
    text += fmt::format("    <nd ref=\"{}\"/>\n", first_node + i);
  }
  text += tag("    ", "type", "road_border");
  text += tag("    ", "side", side_name(line.side));
  text += tag("    ", "line", fmt::format("{}", line.number));
  return text + "  </way>\n";
}

}  // namespace

std::string to_osm(std::span<const GeoLine> lines) {
  // All nodes before all ways, and numbers that nodes and ways share: Lanelet2 has one kind of number.
  std::string nodes;
  std::size_t id = 0;
  for (const GeoLine& line : lines) {
    for (const GeoLine::Vertex& vertex : line.vertices) {
      nodes += node(++id, vertex);
    }
  }
  std::string ways;
  std::size_t first_node = 1;
  for (const GeoLine& line : lines) {
    ways += way(++id, first_node, line);
    first_node += line.vertices.size();
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<osm version=\"0.6\" generator=\"berm\">\n" + nodes + ways +
         "</osm>\n";
}

}  // namespace berm
