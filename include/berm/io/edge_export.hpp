#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "berm/core/edge.hpp"
#include "berm/io/datum.hpp"

namespace berm {

/// Files of edges that other programs open.
enum class EdgeFormat : std::uint8_t {
  csv,      ///< edges.csv, see write_edge_lines
  geojson,  ///< RFC 7946
  gpkg,     ///< OGC GeoPackage, needs GDAL
  dxf,      ///< AutoCAD's drawing exchange, in metres of the world frame, needs GDAL
  osm,      ///< OpenStreetMap XML as Lanelet2 reads it
};

/// By the ending of the name: .csv, .geojson or .json, .gpkg, .dxf, .osm. None for any other.
[[nodiscard]] std::optional<EdgeFormat> edge_format_of(const std::filesystem::path& path);

/// What stands in the way of writing this format, in words for the user; none if nothing does: a geographic file needs
/// a datum, some need a program built with GDAL.
[[nodiscard]] std::optional<std::string> find_export_problem(EdgeFormat format, bool has_datum);

/// Writes `lines`, world frame in the local frame of `datum`, as one file that appears whole or not at all. Same lines,
/// same bytes (with the same version of GDAL). Every line keeps its number from 0 and its side; a line that crosses the
/// date line becomes two features of one number. Confidence per vertex is in all formats but DXF.
///
/// Throws Error(unsupported) with what `find_export_problem` says; Error(invalid_argument) as `write_edge_lines`, and
/// for a vertex of a geographic file that is farther from the datum than `LocalFrame::kMaxDistance_m`;
/// FileError(write_failed) as AtomicFile.
void export_edges(const std::filesystem::path& path, EdgeFormat format, std::span<const EdgeLine> lines,
                  const std::optional<Geodetic>& datum);

}  // namespace berm
