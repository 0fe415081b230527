#include "geo_lines.hpp"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/io/trajectory_file.hpp"

namespace berm {
namespace {

[[noreturn]] void refuse(std::size_t line, const std::string& problem) {
  throw Error(ErrorCode::invalid_argument, fmt::format("edges: line {} {}", line, problem));
}

/// Where the way from `a` to `b` crosses the date line, on the side of `a`.
GeoLine::Vertex crossing(const GeoLine::Vertex& a, const GeoLine::Vertex& b) {
  const double turn_deg = a.place.lon_deg > 0.0 ? 360.0 : -360.0;
  const double end_deg = 0.5 * turn_deg;
  const double span_deg = b.place.lon_deg + turn_deg - a.place.lon_deg;
  const double share = span_deg != 0.0 ? (end_deg - a.place.lon_deg) / span_deg : 0.0;
  const auto between = [share](double from, double to) { return from + share * (to - from); };
  return {{between(a.place.lat_deg, b.place.lat_deg), end_deg, between(a.place.h_m, b.place.h_m)},
          between(a.confidence, b.confidence),
          a.berm_height_m};
}

void append_cut(std::vector<GeoLine>& parts, const GeoLine::Vertex& vertex) {
  GeoLine& part = parts.back();
  constexpr double kHalfTurn_deg = 180.0;
  if (part.vertices.empty() || std::abs(vertex.place.lon_deg - part.vertices.back().place.lon_deg) <= kHalfTurn_deg) {
    part.vertices.push_back(vertex);
    return;
  }
  GeoLine::Vertex cut = crossing(part.vertices.back(), vertex);
  part.vertices.push_back(cut);
  cut.place.lon_deg = -cut.place.lon_deg;
  parts.push_back({part.number, part.side, {cut, vertex}});
}

}  // namespace

std::string_view side_name(EdgeSide side) {
  return side == EdgeSide::left ? "left" : "right";
}

void check_edge_lines(std::span<const EdgeLine> lines) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].vertices.size() < 2) {
      refuse(i, "needs at least two vertices");
    }
    for (const EdgeLine::Vertex& vertex : lines[i].vertices) {
      if (!(vertex.position_m.cwiseAbs().maxCoeff() <= kMaxCoordinate_m) || !vertex.position_m.allFinite()) {
        refuse(i, "has a coordinate that is not finite or beyond +-1e9 m");
      }
      if (!(vertex.confidence >= 0.0 && vertex.confidence <= 1.0)) {
        refuse(i, fmt::format("has the confidence {}, expected 0 to 1", vertex.confidence));
      }
      if (vertex.berm_height_m && !(std::abs(*vertex.berm_height_m) <= kMaxCoordinate_m)) {
        refuse(i, "has a berm whose height is not finite or beyond +-1e9 m");
      }
    }
  }
}

std::vector<GeoLine> to_geo_lines(std::span<const EdgeLine> lines, const LocalFrame& frame) {
  std::vector<GeoLine> parts;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    parts.push_back({i, lines[i].side, {}});
    for (const EdgeLine::Vertex& vertex : lines[i].vertices) {
      if (vertex.position_m.norm() > LocalFrame::kMaxDistance_m) {
        refuse(i, fmt::format("lies {:.0f} km from the datum, expected a local frame within {:.0f} km; are these "
                              "projected coordinates?",
                              vertex.position_m.norm() / 1000.0, LocalFrame::kMaxDistance_m / 1000.0));
      }
      append_cut(parts, {frame.to_geodetic(vertex.position_m), vertex.confidence, vertex.berm_height_m});
    }
  }
  return parts;
}

double rounded(double value, int decimals) {
  const double scale = std::pow(10.0, decimals);
  return std::round(value * scale) / scale + 0.0;
}

}  // namespace berm
