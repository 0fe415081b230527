#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "berm/core/error.hpp"
#include "things.hpp"
#include "vehicle_meshes.hpp"

namespace berm::sim {
namespace {

constexpr double kStep_s = 0.1;
/// Nobody simulates longer than this with traffic that still moves.
constexpr double kLongest_s = 1200.0;
/// Room beside who drives in the middle: half of a wide machine, and some.
constexpr double kTrafficPassing_m = 3.4;
constexpr double kToEdge_m = 0.5;
/// From one moving machine to the next.
constexpr double kFollow_m = 70.0;
/// An oncoming machine looks for a stretch of this length that is wide enough.
constexpr double kRoom_m = 80.0;
/// Beyond the ends of the route they drive this far.
constexpr double kBeyond_m = 80.0;
constexpr double kSpeedChange = 0.12;

VehicleModel model_for(const Site& site) {
  if (site.is("haul_road")) {
    return make_haul_truck(truth::kMovingVehicle);
  }
  return site.is("piste") ? make_groomer(truth::kMovingVehicle) : make_car(truth::kMovingVehicle, 1.0);
}

/// How far left of the middle an oncoming machine keeps; negative where it cannot pass.
double oncoming_lane_m(const Site& site, const VehicleModel& model, double s_m) {
  const double most = site.main_run().route.at(s_m).left_m - kToEdge_m - 0.5 * model.width_m;
  const double least = (site.is("haul_road") || site.is("piste") ? kTrafficPassing_m : 1.4) + 0.5 * model.width_m;
  return most < least ? -1.0 : std::min(most, least + 1.5);
}

/// Drives from `s_m` with `direction` along the route until the way ends or gets too narrow.
Mover drive_along(const Site& site, const VehicleModel& model, double s_m, double direction, Random random) {
  Mover mover;
  mover.mesh = model.mesh;
  const double phase = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double ahead_lane = random.uniform(-0.8, -0.2);
  double s = s_m;
  double lane = direction > 0.0 ? ahead_lane : oncoming_lane_m(site, model, s);
  for (int i = 0; i * kStep_s < kLongest_s; ++i) {
    const double time_s = i * kStep_s;
    if (direction < 0.0) {
      const double wanted = oncoming_lane_m(site, model, s);
      if (wanted < 0.0) {
        break;
      }
      // Changes lanes slowly, and never off the road.
      lane = std::min(lane + std::clamp(wanted - lane, -0.02, 0.02), wanted);
    }
    const RoutePoint at = site.main_run().route.at(s);
    const double yaw = at.heading_rad + (direction > 0.0 ? 0.0 : std::numbers::pi);
    mover.T_world_object.append(from_seconds(time_s),
                                stand_on(site.terrain, beside(at, lane), yaw, model.length_m, model.width_m));
    const double speed = site.plan.traffic.speed_m_per_s * (1.0 + kSpeedChange * std::sin(phase + 0.35 * time_s));
    s += direction * speed * kStep_s;
    if (s < -kBeyond_m || s > site.plan.route.length_m + kBeyond_m) {
      break;
    }
  }
  return mover;
}

/// Where an oncoming machine begins at or after `s_m`: at the far end of the first stretch that is wide enough for
/// long enough, else of the longest.
double find_room(const Site& site, const VehicleModel& model, double s_m) {
  double longest = 0.0;
  double best = s_m;
  double from = s_m;
  for (double s = s_m; s < site.plan.route.length_m + kBeyond_m && longest < kRoom_m; s += 1.0) {
    if (oncoming_lane_m(site, model, s) < 0.0) {
      from = s + 1.0;
    } else if (s - from >= longest) {
      longest = s - from;
      best = s;
    }
  }
  if (longest <= 0.0) {
    throw ConfigError("traffic.oncoming",
                      "is " + std::to_string(site.plan.traffic.oncoming) + ", but behind " + std::to_string(s_m) +
                          " m the way is nowhere wide enough to pass: ask for fewer, or for a wider way");
  }
  return best;
}

}  // namespace

Pose stand_on(const Terrain& terrain, const Eigen::Vector2d& place, double yaw_rad, double length_m, double width_m) {
  const Eigen::Vector2d forward(std::cos(yaw_rad), std::sin(yaw_rad));
  const Eigen::Vector2d left(-forward.y(), forward.x());
  const double a = 0.3 * length_m;
  const double b = 0.35 * width_m;
  const auto height = [&](double along, double across) {
    const Eigen::Vector2d p = place + along * forward + across * left;
    return terrain.at(p.x(), p.y()).height_m;
  };
  const double front_left = height(a, b);
  const double front_right = height(a, -b);
  const double rear_left = height(-a, b);
  const double rear_right = height(-a, -b);
  const double pitch = -std::atan((front_left + front_right - rear_left - rear_right) / (4.0 * a));
  const double roll = std::atan((front_left + rear_left - front_right - rear_right) / (4.0 * b));
  const double z = 0.25 * (front_left + front_right + rear_left + rear_right);
  return Pose::from_yaw_pitch_roll(yaw_rad, pitch, roll, {place.x(), place.y(), z});
}

std::vector<Mover> make_movers(const Site& site) {
  const TrafficConfig& config = site.plan.traffic;
  const VehicleModel model = model_for(site);
  std::vector<Mover> movers;
  double s = config.first_m;
  for (int i = 0; i < config.ahead; ++i) {
    movers.push_back(drive_along(site, model, s, 1.0, Random(site.seed, Purpose::movers, movers.size())));
    s += kFollow_m;
  }
  s = config.first_m;
  for (int i = 0; i < config.oncoming; ++i) {
    s = find_room(site, model, s);
    movers.push_back(drive_along(site, model, s, -1.0, Random(site.seed, Purpose::movers, movers.size())));
    s += kFollow_m;
  }
  return movers;
}

std::vector<Plume> make_plumes(const Site& site, const std::vector<Mover>& movers) {
  const DustConfig& config = site.plan.dust;
  std::vector<Plume> plumes;
  for (int i = 0; i < config.plumes; ++i) {
    Random random(site.seed, Purpose::movers, 1000, static_cast<std::uint64_t>(i));
    const double size = config.size_m * random.uniform(0.6, 1.4);
    Eigen::Vector2d place;
    double strength = random.uniform(0.3, 1.0);
    if (!movers.empty() && i % 2 == 0) {
      // What a machine has stirred up lies along the way that it takes.
      const auto& poses = movers[static_cast<std::size_t>(i / 2) % movers.size()].T_world_object.poses();
      const auto at = static_cast<std::size_t>(random.uniform() * std::min(300.0, static_cast<double>(poses.size())));
      place = poses[at].T_world_base.translation_m().head<2>();
    } else {
      const RoutePoint at = site.main_run().route.at(random.uniform(0.0, site.plan.route.length_m));
      place = beside(at, random.uniform(-at.right_m, at.left_m));
      strength *= 0.5;
    }
    const Eigen::Vector3d sigma(size, 0.7 * size, 0.3 * size);
    const double ground = site.terrain.at(place.x(), place.y()).height_m;
    plumes.push_back({{place.x(), place.y(), ground + 0.5 * sigma.z()}, sigma, strength * config.extinction_per_m});
  }
  return plumes;
}

}  // namespace berm::sim
