#pragma once

#include <span>
#include <string>
#include <vector>

#include "berm/core/edge.hpp"
#include "geo_lines.hpp"

namespace berm {

/// Whole files as bytes. GeoPackage and DXF need GDAL; they throw Error(write_failed) with what GDAL says.
[[nodiscard]] std::string to_geojson(std::span<const GeoLine> lines);
[[nodiscard]] std::string to_osm(std::span<const GeoLine> lines);
[[nodiscard]] std::string to_geopackage(std::span<const GeoLine> lines);
[[nodiscard]] std::string to_dxf(std::span<const EdgeLine> lines);

/// Decimals of degrees in text: 0.01 m, what RFC 7946 thinks sensible. Of metres and confidence.
constexpr int kDegreeDecimals = 7;
constexpr int kMetreDecimals = 3;
constexpr int kConfidenceDecimals = 3;

}  // namespace berm
