#include <string>

#include <nlohmann/json.hpp>

#include "edge_formats.hpp"

namespace berm {
namespace {

nlohmann::ordered_json feature(const GeoLine& line) {
  nlohmann::ordered_json coordinates = nlohmann::ordered_json::array();
  nlohmann::ordered_json confidence = nlohmann::ordered_json::array();
  nlohmann::ordered_json height_m = nlohmann::ordered_json::array();
  for (const GeoLine::Vertex& vertex : line.vertices) {
    coordinates.push_back({rounded(vertex.place.lon_deg, kDegreeDecimals),
                           rounded(vertex.place.lat_deg, kDegreeDecimals), rounded(vertex.place.h_m, kMetreDecimals)});
    confidence.push_back(rounded(vertex.confidence, kConfidenceDecimals));
    height_m.push_back(vertex.berm_height_m ? nlohmann::ordered_json(rounded(*vertex.berm_height_m, kMetreDecimals))
                                            : nlohmann::ordered_json());
  }
  return {{"type", "Feature"},
          {"properties",
           {{"line", line.number},
            {"side", side_name(line.side)},
            {"confidence", confidence},
            {"berm_height_m", height_m}}},
          {"geometry", {{"type", "LineString"}, {"coordinates", coordinates}}}};
}

}  // namespace

std::string to_geojson(std::span<const GeoLine> lines) {
  // A feature a line, so that files can be compared.
  std::string text = R"({"type":"FeatureCollection","features":[)";
  bool first = true;
  for (const GeoLine& line : lines) {
    text += first ? "\n" : ",\n";
    first = false;
    text += feature(line).dump();
  }
  return text + "\n]}\n";
}

}  // namespace berm
