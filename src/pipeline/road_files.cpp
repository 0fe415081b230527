#include "road_files.hpp"

#include "berm/io/atomic_file.hpp"
#include "berm/io/edge_export.hpp"
#include "berm/io/edge_lines_file.hpp"
#include "berm/io/road_file.hpp"

namespace berm {
namespace {

struct Export {
  EdgeFormat format;
  const char* key;
  const char* file;
};

constexpr Export kExports[] = {{EdgeFormat::geojson, "edges_geojson", "edges.geojson"},
                               {EdgeFormat::gpkg, "edges_gpkg", "edges.gpkg"},
                               {EdgeFormat::dxf, "edges_dxf", "edges.dxf"}};

void write_exports(const OutputFolder& output, std::span<const EdgeLine> lines, const std::optional<Geodetic>& datum,
                   RunFiles& files, std::vector<std::string>& notes) {
  if (!datum) {
    notes.emplace_back(
        "no datum: edges.geojson and edges.gpkg were not written; say where on the earth the world begins with "
        "datum.origin=given, datum.lat_deg, datum.lon_deg and datum.h_m, or bring a pose log with such positions");
  }
  for (const Export& one : kExports) {
    const auto problem = find_export_problem(one.format, datum.has_value());
    if (!problem) {
      export_edges(output / one.file, one.format, lines, datum);
      files.emplace_back(one.key, one.file);
    } else if (!find_export_problem(EdgeFormat::geojson, datum.has_value()) || one.format == EdgeFormat::dxf) {
      notes.push_back(std::string(one.file) + " was not written: " + *problem);
    }
  }
}

}  // namespace

void write_road_files(const OutputFolder& output, const EdgeMap& map, std::span<const EdgeLine> lines,
                      std::span<const RoadStation> stations, const std::optional<Geodetic>& datum, RunFiles& files,
                      std::vector<std::string>& notes) {
  write_file_atomically(output / "edges.ot", map.to_octomap());
  files.emplace_back("edge_map", "edges.ot");
  write_edge_lines(output / "edges.csv", lines);
  files.emplace_back("edges", "edges.csv");
  write_exports(output, lines, datum, files, notes);
  if (!stations.empty()) {
    write_road(output / "road.csv", stations);
    files.emplace_back("road", "road.csv");
  }
}

}  // namespace berm
