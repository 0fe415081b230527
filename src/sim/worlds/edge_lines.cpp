#include "edge_lines.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace berm::sim {
namespace {

/// A vertex counts as on the edge of all runs together up to this distance.
constexpr double kOnEdge_m = 1e-3;
/// Shorter pieces are slivers where two edges cross.
constexpr std::size_t kFewestVertices = 3;
/// At the very end of a run the edge turns around it.
constexpr double kEnd_m = 5.0;

void close_line(std::vector<EdgeLine>& edges, EdgeLine& line, const Run& main_run) {
  if (line.vertices_m.size() >= kFewestVertices) {
    const Eigen::Vector3d& middle = line.vertices_m[line.vertices_m.size() / 2];
    line.left = main_run.route.nearest(middle.x(), middle.y()).left_m > 0.0;
    edges.push_back(std::move(line));
  }
  line = EdgeLine{};
}

}  // namespace

std::vector<EdgeLine> find_edges(const BuiltTerrain& terrain) {
  std::vector<EdgeLine> edges;
  for (const Run& run : terrain.runs()) {
    const double first = run.route.points().front().s_m;
    const double last = run.route.points().back().s_m;
    for (const double side : {1.0, -1.0}) {
      EdgeLine line;
      for (const RoutePoint& p : run.route.points()) {
        const Eigen::Vector2d place = beside(p, side > 0.0 ? p.left_m : -p.right_m);
        const GroundSample ground = terrain.at(place.x(), place.y());
        const bool at_end = p.s_m < first + kEnd_m || p.s_m > last - kEnd_m;
        if (!at_end && std::abs(ground.inside_m) < kOnEdge_m) {
          line.vertices_m.emplace_back(place.x(), place.y(), ground.height_m);
        } else {
          close_line(edges, line, terrain.runs()[0]);
        }
      }
      close_line(edges, line, terrain.runs()[0]);
    }
  }
  return edges;
}

}  // namespace berm::sim
