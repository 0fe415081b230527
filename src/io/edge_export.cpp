#include "berm/io/edge_export.hpp"

#include <algorithm>
#include <string>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/edge_lines_file.hpp"
#include "edge_formats.hpp"
#include "geo_lines.hpp"

namespace berm {
namespace {

#ifdef BERM_WITH_GDAL
constexpr bool kHasGdal = true;
#else
constexpr bool kHasGdal = false;
#endif

std::string_view format_name(EdgeFormat format) {
  switch (format) {
    case EdgeFormat::csv:
      return "CSV";
    case EdgeFormat::geojson:
      return "GeoJSON";
    case EdgeFormat::gpkg:
      return "GeoPackage";
    case EdgeFormat::dxf:
      return "DXF";
    case EdgeFormat::osm:
      break;
  }
  return "OSM";
}

bool is_geographic(EdgeFormat format) {
  return format == EdgeFormat::geojson || format == EdgeFormat::gpkg || format == EdgeFormat::osm;
}

std::string to_bytes(EdgeFormat format, std::span<const EdgeLine> lines, const std::optional<Geodetic>& datum) {
  if (format == EdgeFormat::dxf) {
    return to_dxf(lines);
  }
  const std::vector<GeoLine> geo_lines = to_geo_lines(lines, LocalFrame(*datum));
  switch (format) {
    case EdgeFormat::gpkg:
      return to_geopackage(geo_lines);
    case EdgeFormat::osm:
      return to_osm(geo_lines);
    default:
      return to_geojson(geo_lines);
  }
}

}  // namespace

#ifndef BERM_WITH_GDAL
// find_export_problem stands before them.
std::string to_geopackage(std::span<const GeoLine> /*lines*/) {
  return {};
}

std::string to_dxf(std::span<const EdgeLine> /*lines*/) {
  return {};
}
#endif

std::optional<EdgeFormat> edge_format_of(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (ending == ".csv") {
    return EdgeFormat::csv;
  }
  if (ending == ".geojson" || ending == ".json") {
    return EdgeFormat::geojson;
  }
  if (ending == ".gpkg") {
    return EdgeFormat::gpkg;
  }
  if (ending == ".dxf") {
    return EdgeFormat::dxf;
  }
  return ending == ".osm" ? std::optional(EdgeFormat::osm) : std::nullopt;
}

std::optional<std::string> find_export_problem(EdgeFormat format, bool has_datum) {
  const std::string name(format_name(format));
  if (is_geographic(format) && !has_datum) {
    return name +
           " holds places on the earth, and nothing says where the world frame lies: set datum.origin: given "
           "with datum.lat_deg, lon_deg and h_m, or give poses with geographic positions";
  }
  if (!kHasGdal && (format == EdgeFormat::gpkg || format == EdgeFormat::dxf)) {
    return name +
           " needs GDAL, and this program was built without it; install libgdal-dev and build again, or write "
           "GeoJSON and convert it: ogr2ogr edges." +
           (format == EdgeFormat::gpkg ? "gpkg" : "dxf") + " edges.geojson";
  }
  return std::nullopt;
}

void export_edges(const std::filesystem::path& path, EdgeFormat format, std::span<const EdgeLine> lines,
                  const std::optional<Geodetic>& datum) {
  if (const std::optional<std::string> problem = find_export_problem(format, datum.has_value())) {
    throw Error(ErrorCode::unsupported, path.string() + ": not written: " + *problem);
  }
  if (format == EdgeFormat::csv) {
    write_edge_lines(path, lines);
    return;
  }
  check_edge_lines(lines);
  write_file_atomically(path, to_bytes(format, lines, datum));
}

}  // namespace berm
