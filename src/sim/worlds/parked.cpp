#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "mesh_builder.hpp"
#include "things.hpp"
#include "vehicle_meshes.hpp"

namespace berm::sim {
namespace {

constexpr double kRightAngle = 0.5 * std::numbers::pi;
/// Room between a machine parked on a road and who drives in its middle (half of the width of a truck, and some).
constexpr double kPassing_m = 4.2;
/// A car park: rows of bays at both sides of lanes.
constexpr double kBayWidth_m = 2.7;
constexpr double kBayLength_m = 5.2;
constexpr double kLane_m = 7.0;
constexpr int kTries = 40;

/// Frame of a machine on the ground, tilted with it.
Eigen::Isometry3d on_ground(const BuiltTerrain& terrain, const Eigen::Vector2d& place, double yaw_rad,
                            const VehicleModel& model) {
  return Eigen::Isometry3d(stand_on(terrain, place, yaw_rad, model.length_m, model.width_m).matrix());
}

/// True if the places of two machines could overlap; remembers the new one if not.
bool is_taken(std::vector<Eigen::Vector2d>& taken, const Eigen::Vector2d& place, double room_m) {
  const bool overlaps = std::any_of(taken.begin(), taken.end(),
                                    [&](const Eigen::Vector2d& other) { return (other - place).norm() < room_m; });
  if (!overlaps) {
    taken.push_back(place);
  }
  return overlaps;
}

void park_beside(const Site& site, const VehicleModel& model, bool on_road, TriangleMesh& mesh) {
  std::vector<Eigen::Vector2d> taken;
  for (int i = 0; i < site.plan.traffic.parked; ++i) {
    Random random = random_of(site, ThingRandom::parked, static_cast<std::uint64_t>(i));
    for (int attempt = 0; attempt < kTries; ++attempt) {
      const double s = random.uniform(0.0, site.plan.route.length_m);
      // The left is kept free for who comes towards.
      const bool right = random.chance(0.5) || (on_road && site.plan.traffic.oncoming > 0);
      const double side = right ? -1.0 : 1.0;
      const double wanted = on_road ? -0.5 * model.width_m - 0.8 : 0.5 * model.length_m + random.uniform(1.5, 5.0);
      const double turn = random.chance(0.5) ? 0.0 : std::numbers::pi;
      const double yaw_off = on_road ? random.uniform(-0.06, 0.06) : random.uniform(-0.6, 0.6);
      const RoadsidePlace place = roadside(site, s, side, wanted);
      const RoutePoint at = site.main_run().route.at(s);
      const double half = side > 0.0 ? at.left_m : at.right_m;
      const bool fits = on_road
                            ? half + wanted > kPassing_m + 0.5 * model.width_m && place.inside_m > 0.5 * model.width_m
                            : place.inside_m < -0.5 * model.length_m - 1.0;
      if (fits && !is_taken(taken, place.ground_m.head<2>(), model.length_m + 1.0)) {
        append_mesh(mesh, model.mesh,
                    on_ground(site.terrain, place.ground_m.head<2>(), place.heading_rad + turn + yaw_off, model));
        break;
      }
    }
  }
}

/// Bays in rows along the way; the middle stays free to drive.
void fill_car_park(const Site& site, TriangleMesh& mesh) {
  struct Bay {
    double s_m;
    double left_m;
    double facing;
  };
  std::vector<Bay> bays;
  const double half = 0.5 * site.plan.paved.park_width_m;
  for (double lane = 0.5 * kLane_m; lane + kBayLength_m < half; lane += 2.0 * kBayLength_m + kLane_m) {
    for (double s = 5.0; s < site.plan.route.length_m; s += kBayWidth_m) {
      for (const double side : {1.0, -1.0}) {
        bays.push_back({s, side * (lane + 0.5 * kBayLength_m), side});
        if (lane + 2.0 * kBayLength_m < half) {
          bays.push_back({s, side * (lane + 1.5 * kBayLength_m), -side});
        }
      }
    }
  }
  Random random = random_of(site, ThingRandom::parked);
  for (int i = 0; i < site.plan.traffic.parked && !bays.empty(); ++i) {
    const auto index = static_cast<std::size_t>(random.uniform() * static_cast<double>(bays.size()));
    const Bay bay = bays[index];
    bays[index] = bays.back();
    bays.pop_back();
    const VehicleModel car = make_car(truth::kVehicle, random.uniform(0.85, 1.15));
    const RoutePoint at = site.main_run().route.at(bay.s_m);
    const double backwards = random.chance(0.3) ? std::numbers::pi : 0.0;
    const double yaw = at.heading_rad + bay.facing * kRightAngle + backwards + random.uniform(-0.04, 0.04);
    append_mesh(mesh, car.mesh, on_ground(site.terrain, beside(at, bay.left_m), yaw, car));
  }
}

}  // namespace

void add_parked(const Site& site, TriangleMesh& mesh) {
  if (site.is("car_park")) {
    fill_car_park(site, mesh);
  } else if (site.is("haul_road")) {
    park_beside(site, make_haul_truck(truth::kVehicle), true, mesh);
  } else if (site.is("flat_road")) {
    park_beside(site, make_car(truth::kVehicle, 1.0), false, mesh);
  } else {
    park_beside(site, make_groomer(truth::kVehicle), false, mesh);
  }
}

}  // namespace berm::sim
