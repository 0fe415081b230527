#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "berm/sim/world.hpp"
#include "berm/sim/world_config.hpp"
#include "built_terrain.hpp"

namespace berm::sim {

/// What the placing of things looks at.
struct Site {
  const WorldPlan& plan;
  const BuiltTerrain& terrain;
  std::uint64_t seed = 0;

  [[nodiscard]] const Run& main_run() const { return terrain.runs()[0]; }
  [[nodiscard]] bool is(std::string_view kind) const { return plan.world.kind == kind; }
};

/// Index of the random numbers of each kind of thing.
enum class ThingRandom : std::uint64_t { forest, fences, poles, billboards, lift, buildings, rocks, parked, lamps };
[[nodiscard]] Random random_of(const Site& site, ThingRandom what, std::uint64_t index = 0);

/// A place beside the main run: `beyond_m` outside of its left (+1) or right (-1) edge at `s_m`.
struct RoadsidePlace {
  Eigen::Vector3d ground_m;
  double heading_rad = 0.0;
  double inside_m = 0.0;  ///< of all runs together
};
[[nodiscard]] RoadsidePlace roadside(const Site& site, double s_m, double side, double beyond_m);

/// Pose of a machine that stands on the ground with its wheels or tracks.
[[nodiscard]] Pose stand_on(const Terrain& terrain, const Eigen::Vector2d& place, double yaw_rad, double length_m,
                            double width_m);

/// Each adds what the plan asks for, never onto what is drivable (but for parked machines and rocks).
void add_forest(const Site& site, TriangleMesh& mesh);
void add_fences(const Site& site, TriangleMesh& mesh);
void add_poles(const Site& site, TriangleMesh& mesh);
void add_billboards(const Site& site, TriangleMesh& mesh);
void add_lamps(const Site& site, TriangleMesh& mesh);
void add_lift(const Site& site, TriangleMesh& mesh);
void add_buildings(const Site& site, TriangleMesh& mesh);
void add_rocks(const Site& site, TriangleMesh& mesh);
void add_parked(const Site& site, TriangleMesh& mesh);

/// Throws ConfigError where the way is too narrow for oncoming machines.
[[nodiscard]] std::vector<Mover> make_movers(const Site& site);
[[nodiscard]] std::vector<Plume> make_plumes(const Site& site, const std::vector<Mover>& movers);

}  // namespace berm::sim
