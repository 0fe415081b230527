#include "berm/sim/build_world.hpp"

#include <utility>
#include <vector>

#include "build_ground.hpp"
#include "edge_lines.hpp"
#include "things.hpp"

namespace berm::sim {
namespace {

/// The part of a run that is driven.
Route driven_part(const Run& run, double length_m) {
  std::vector<RoutePoint> points;
  for (const RoutePoint& p : run.route.points()) {
    if (p.s_m >= 0.0 && p.s_m <= length_m) {
      points.push_back(p);
    }
  }
  return Route(std::move(points));
}

TriangleMesh make_things(const Site& site) {
  TriangleMesh mesh;
  add_fences(site, mesh);
  add_poles(site, mesh);
  add_billboards(site, mesh);
  add_lamps(site, mesh);
  add_lift(site, mesh);
  add_buildings(site, mesh);
  add_rocks(site, mesh);
  add_parked(site, mesh);
  // Trees stand where nothing else does.
  add_forest(site, mesh);
  return mesh;
}

}  // namespace

World build_world(const WorldPlan& plan, const std::optional<HeightRaster>& elevation, std::uint64_t seed) {
  plan.check();
  const BuiltGround ground = build_ground(plan, elevation, seed);
  World world;
  world.terrain = ground.terrain;
  world.area = ground.area;
  world.origin_m = ground.origin_m;
  world.route = driven_part(ground.terrain->runs()[0], plan.route.length_m);
  world.edges = find_edges(*ground.terrain);
  const Site site{plan, *ground.terrain, seed};
  world.things = make_things(site);
  world.movers = make_movers(site);
  world.plumes = make_plumes(site, world.movers);
  return world;
}

}  // namespace berm::sim
