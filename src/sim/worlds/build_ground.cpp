#include "build_ground.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "berm/core/angle.hpp"
#include "berm/core/error.hpp"
#include "model_ground.hpp"
#include "natural_ground.hpp"
#include "route_course.hpp"
#include "route_on_model.hpp"
#include "run_plans.hpp"

namespace berm::sim {
namespace {

/// What branches off is this much narrower.
constexpr double kForkWidthShare = 0.7;
constexpr double kForkLength_m = 170.0;
constexpr double kShortestFork_m = 60.0;
constexpr int kForkAttempts = 24;
/// Runs that do not meet stay this far from edge to middle.
constexpr double kApart_m = 22.0;
/// After a fork has left its run, its gradient turns to one of its own, this much off at most, over this distance.
constexpr double kForkGradient_deg = 8.0;
constexpr double kForkEase_m = 60.0;

Run make_run(const WorldPlan& plan, std::vector<RoutePoint> course, double share, const RunSeed& seed) {
  if (plan.world.kind == "piste") {
    return make_piste(plan.piste, std::move(course), share, seed);
  }
  if (plan.world.kind == "haul_road") {
    return make_haul_road(plan.haul_road, std::move(course), share, seed);
  }
  const bool park = plan.world.kind == "car_park";
  return make_paved(plan.paved, std::move(course), park ? plan.paved.park_width_m : plan.paved.road_width_m);
}

double along_slope(const ModelGround& model, const RoutePoint& p) {
  constexpr double kBase_m = 15.0;
  return model.slope(p.x_m, p.y_m, kBase_m).dot(Eigen::Vector2d(std::cos(p.heading_rad), std::sin(p.heading_rad)));
}

/// Heights of a fork: those of its run while it lies on it, then on with its gradient, which changes to `gradient`, or
/// on a model to its ground.
void lay_fork_heights(const Run& run, std::vector<RoutePoint>& course, double gradient,
                      const std::optional<ModelGround>& model) {
  double slope = 0.0;
  double left_at_s = -1.0;
  for (std::size_t i = 0; i < course.size(); ++i) {
    const RunPlace place = run.place(course[i].x_m, course[i].y_m);
    if (left_at_s < 0.0 && (place.inside_m > 0.0 || i < 4)) {
      course[i].z_m = run.graded_m(place);
      slope = i > 0 ? (course[i].z_m - course[i - 1].z_m) / kRouteStep_m : 0.0;
      continue;
    }
    left_at_s = left_at_s < 0.0 ? course[i].s_m : left_at_s;
    const double eased = smooth_step(0.0, kForkEase_m, course[i].s_m - left_at_s);
    if (model) {
      const double natural = model->heights().at(course[i].x_m, course[i].y_m);
      gradient = std::clamp((natural - course[i - 1].z_m) / kForkEase_m + along_slope(*model, course[i]), -1.0, 1.0);
    }
    course[i].z_m = course[i - 1].z_m + kRouteStep_m * (slope + eased * (gradient - slope));
  }
}

/// How many points of a fork can stay: none may come back to a run once it has left, nor near to another one.
std::size_t usable_points(const std::vector<Run>& runs, const std::vector<RoutePoint>& course) {
  bool has_left = false;
  double farthest = 0.0;
  for (std::size_t i = 0; i < course.size(); ++i) {
    const double inside = runs[0].place(course[i].x_m, course[i].y_m).inside_m;
    has_left = has_left || inside < -kApart_m;
    farthest = std::max(farthest, -inside);
    const bool comes_back = farthest > 1.0 && -inside < farthest - 1.0;
    bool too_near = (has_left || comes_back) && inside > -kApart_m;
    for (std::size_t other = 1; other < runs.size(); ++other) {
      too_near = too_near || runs[other].place(course[i].x_m, course[i].y_m).inside_m > -kApart_m;
    }
    if (too_near) {
      return i;
    }
  }
  return course.size();
}

/// Where a fork leaves, to which side and how sharply: tries some, takes the one that can go farthest.
std::vector<RoutePoint> find_fork(const WorldPlan& plan, const std::vector<Run>& runs, Random& random) {
  std::vector<RoutePoint> best;
  for (int attempt = 0; attempt < kForkAttempts; ++attempt) {
    const double s = plan.route.length_m * random.uniform(0.12, 0.88);
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    // Runs part at small angles, roads of a mine at larger ones.
    const bool haul_road = plan.world.kind == "haul_road";
    const double turn = (haul_road ? random.uniform(60.0, 85.0) : random.uniform(30.0, 50.0)) * kRadPerDeg;
    std::vector<RoutePoint> course =
        lay_fork(runs[0].route.at(s), side, turn, plan.route.min_radius_m * 1.05, kForkLength_m);
    course.resize(usable_points(runs, course));
    if (course.size() > best.size()) {
      best = std::move(course);
    }
    if (static_cast<double>(best.size()) > kForkLength_m / kRouteStep_m) {
      break;
    }
  }
  return best;
}

/// Adds a run that leaves the first; none where there is no room for one.
void add_fork(const WorldPlan& plan, std::vector<Run>& runs, std::uint64_t seed,
              const std::optional<ModelGround>& model) {
  Random random(seed, Purpose::route, 10, runs.size());
  std::vector<RoutePoint> course = find_fork(plan, runs, random);
  if (static_cast<double>(course.size()) * kRouteStep_m < kShortestFork_m) {
    return;
  }
  // Not much steeper than what it leaves: between the two there is to be a slope, not a cliff.
  const double left_deg =
      std::atan(runs[0].route.gradient(runs[0].place(course[0].x_m, course[0].y_m).place.s_m)) / kRadPerDeg;
  const double gradient = std::tan(std::clamp(left_deg + random.uniform(-kForkGradient_deg, kForkGradient_deg),
                                              plan.route.min_gradient_deg, plan.route.max_gradient_deg) *
                                   kRadPerDeg);
  lay_fork_heights(runs[0], course, gradient, model);
  runs.push_back(make_run(plan, std::move(course), kForkWidthShare, {seed, runs.size()}));
}

std::uint64_t forks_of(const WorldPlan& plan) {
  if (plan.world.kind == "piste") {
    return static_cast<std::uint64_t>(plan.piste.forks);
  }
  return plan.world.kind == "haul_road" ? static_cast<std::uint64_t>(plan.haul_road.junctions) : 0;
}

GroundStyle style_of(const WorldPlan& plan) {
  GroundStyle style;
  style.land_sigma_m = plan.world.roughness_m;
  if (plan.world.kind == "piste") {
    style.inside_sigma_m = plan.piste.undulation_m;
    style.outside_sigma_m = plan.piste.rough_snow_m;
    return style;
  }
  const bool haul_road = plan.world.kind == "haul_road";
  style.inside = haul_road ? Surface::gravel : Surface::asphalt;
  style.outside = Surface::gravel;
  style.inside_sigma_m = haul_road ? 0.015 : 0.004;
  style.inside_wave_m = haul_road ? 2.5 : 8.0;
  style.outside_sigma_m = haul_road ? 0.05 : plan.paved.verge_m;
  style.outside_wave_m = 1.8;
  return style;
}

PitShape make_pit(const HaulRoadConfig& config, const Run& road, const Area& area, std::uint64_t seed) {
  const double foot = road.sides[0].shoulder_m.at(0.0);
  PitShape pit;
  pit.wall_side = Random(seed, Purpose::terrain, 20).chance(0.5) ? 1.0 : -1.0;
  pit.wall_from_m = foot + 1.0;
  pit.wall_height_m = config.wall_height_m;
  pit.wall_slope = std::tan(config.wall_slope_deg * kRadPerDeg);
  pit.drop_from_m = foot + 0.5;
  pit.drop_height_m = config.drop_height_m;
  pit.drop_slope = std::tan(config.drop_slope_deg * kRadPerDeg);
  pit.left_width_m = make_width_raster(road, area, true);
  pit.right_width_m = make_width_raster(road, area, false);
  return pit;
}

/// Where the route begins, in the coordinates of the model.
Eigen::Vector3d start_on(const WorldConfig& config, const HeightRaster& model) {
  const Eigen::Vector3d start(model.origin_x_m + config.elevation_x * static_cast<double>(model.columns) * model.cell_m,
                              model.origin_y_m + config.elevation_y * static_cast<double>(model.rows) * model.cell_m,
                              0.0);
  const bool sized = model.columns > 0 && model.rows > 0 && model.heights_m.size() == model.columns * model.rows;
  if (!sized || !start.allFinite() || !(model.cell_m > 0.0)) {
    throw Error(ErrorCode::invalid_argument,
                "elevation model: expected finite coordinates and a height for each of its cells");
  }
  return start;
}

double height_at_start(const std::vector<RoutePoint>& course) {
  const auto start =
      std::lower_bound(course.begin(), course.end(), 0.0, [](const RoutePoint& p, double s_m) { return p.s_m < s_m; });
  return start->z_m;
}

std::shared_ptr<const BuiltTerrain> make_terrain(const WorldPlan& plan, std::vector<Run> runs,
                                                 const std::optional<ModelGround>& model, const Area& area,
                                                 std::uint64_t seed) {
  const bool haul_road = plan.world.kind == "haul_road";
  GroundStyle style = style_of(plan);
  if (model) {
    // The model has its own relief, and its own walls and drops.
    style.land_sigma_m = 0.0;
  }
  SmoothRaster natural = model ? model->heights() : make_natural_ground(plan.world, runs, seed);
  RoadDetails details = haul_road ? RoadDetails(plan.haul_road, runs[0], seed) : RoadDetails();
  std::optional<PitShape> pit;
  if (haul_road && !model) {
    pit = make_pit(plan.haul_road, runs[0], area, seed);
  }
  auto terrain = std::make_shared<BuiltTerrain>(std::move(runs), std::move(natural), style, seed);
  if (pit) {
    terrain->add_pit(std::move(*pit));
  }
  terrain->add_details(std::move(details));
  return terrain;
}

}  // namespace

BuiltGround build_ground(const WorldPlan& plan, const std::optional<HeightRaster>& elevation, std::uint64_t seed) {
  BuiltGround ground;
  std::optional<ModelGround> model;
  std::vector<RoutePoint> course;
  if (elevation) {
    ground.origin_m = start_on(plan.world, *elevation);
    model.emplace(*elevation, ground.origin_m.x(), ground.origin_m.y(),
                  plan.route.length_m + kLead_m + plan.world.margin_m);
    course = lay_course_on_model(plan.route, *model, greatest_reach_m(plan), seed);
    ground.origin_m.z() = height_at_start(course);
    for (RoutePoint& p : course) {
      p.z_m -= ground.origin_m.z();
    }
    model->raise(-ground.origin_m.z());
  } else {
    course = lay_course(plan.route, seed);
  }
  std::vector<Run> runs;
  runs.push_back(make_run(plan, std::move(course), 1.0, {seed, 0}));
  for (std::uint64_t i = 0; i < forks_of(plan); ++i) {
    add_fork(plan, runs, seed, model);
  }
  ground.area = area_around(runs, plan.world.margin_m);
  ground.terrain = make_terrain(plan, std::move(runs), model, ground.area, seed);
  return ground;
}

}  // namespace berm::sim
