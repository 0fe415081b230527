#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "berm/core/error.hpp"
#include "berm/io/datum.hpp"
#include "berm/io/edge_export.hpp"
#include "berm/io/edge_lines_file.hpp"
#include "command_map.hpp"
#include "exit_code.hpp"

namespace berm::app {
namespace {

constexpr const char* kMapLinesExamples = R"(Examples:
  berm map lines edges.ot -o edges.csv
  berm map lines edges.ot -o edges.csv --set lines.spacing_m=1 --set lines.max_gap_m=10 --force)";

constexpr const char* kMapExportExamples = R"(Examples:
  berm map export edges.ot -o edges.gpkg
  berm map export edges.ot -o edges.osm --datum=-23.5,148.25,310
  berm map export edges.csv -o edges.dxf
  berm map export edges.csv -o edges.geojson --datum=48.1,11.5,520

The ending says the format: .geojson (RFC 7946), .gpkg (OGC GeoPackage), .dxf (metres of the world frame), .osm (Lanelet2),
.csv. Geographic files need to know where the origin of the world lies on the earth: a map knows it if the run that made
it did, edges.csv does not.)";

struct MapLinesCommand {
  std::string map;
  OutputOption output;
  LinesOption lines;
};

int execute(const MapLinesCommand& command) {
  const EdgeLinesConfig config = command.lines.choose();
  const std::string& target = command.output.target();
  write_edge_lines(target, extract_lines(read_map(command.map), config));
  return kWhole;
}

struct MapExportCommand {
  std::string input;
  OutputOption output;
  LinesOption lines;
  std::vector<double> datum;
};

struct PlacedLines {
  std::vector<EdgeLine> lines;
  std::optional<Geodetic> datum;
};

PlacedLines read_lines(const MapExportCommand& command) {
  PlacedLines placed;
  if (edge_format_of(command.input) == EdgeFormat::csv) {
    placed.lines = read_edge_lines(command.input);
  } else {
    const EdgeMap map = read_map(command.input);
    placed.datum = datum_of(map.world());
    placed.lines = extract_lines(map, command.lines.choose());
  }
  if (!command.datum.empty()) {
    placed.datum = Geodetic{command.datum[0], command.datum[1], command.datum[2]};
    static_cast<void>(LocalFrame(*placed.datum));  // a place on the earth, whatever the format
  }
  return placed;
}

int execute(const MapExportCommand& command) {
  const std::optional<EdgeFormat> format = edge_format_of(command.output.name());
  if (!format) {
    throw UsageError(command.output.name() + ": its ending is none of .geojson, .gpkg, .dxf, .osm and .csv");
  }
  static_cast<void>(command.lines.choose());
  const std::string& target = command.output.target();
  const PlacedLines placed = read_lines(command);
  if (!placed.datum && find_export_problem(*format, true) != find_export_problem(*format, false)) {
    throw FileError(
        ErrorCode::unsupported, command.input, std::nullopt,
        "does not say where on the earth it lies: add --datum=LAT,LON,H of the origin of its world, or write "
        ".dxf or .csv, which need none");
  }
  export_edges(target, *format, placed.lines, placed.datum);
  return kWhole;
}

}  // namespace

void add_map_lines(CLI::App& app, int& exit_code) {
  auto command = std::make_shared<MapLinesCommand>();
  CLI::App* sub = app.add_subcommand("lines", "Turn a map into lines, edges.csv");
  sub->footer(kMapLinesExamples);
  sub->add_option("MAP", command->map, "Map of road edges (.ot)")->required()->type_name("FILE");
  command->output.add_options(*sub, "The lines (.csv)");
  command->lines.add_options(*sub);
  sub->callback([command, &exit_code] { exit_code = execute(*command); });
}

void add_map_export(CLI::App& app, int& exit_code) {
  constexpr int kNumbers = 3;
  auto command = std::make_shared<MapExportCommand>();
  CLI::App* sub = app.add_subcommand("export", "Write the edges as GeoJSON, GeoPackage, DXF, Lanelet2 or CSV");
  sub->footer(kMapExportExamples);
  sub->add_option("EDGES", command->input, "Map of road edges (.ot), or its lines (.csv)")
      ->required()
      ->type_name("FILE");
  command->output.add_options(*sub, "The file; its ending says the format");
  sub->add_option("--datum", command->datum,
                  "Where the origin of the world lies: latitude, longitude (degrees, WGS 84), height above the "
                  "ellipsoid (m); instead of what the map says")
      ->delimiter(',')
      ->expected(kNumbers)
      ->type_name("LAT,LON,H");
  command->lines.add_options(*sub);
  sub->callback([command, &exit_code] { exit_code = execute(*command); });
}

}  // namespace berm::app
