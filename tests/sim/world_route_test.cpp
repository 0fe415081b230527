#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/sim/random.hpp"
#include "berm/sim/route.hpp"
#include "sim/world_cases.hpp"

namespace berm::sim {
namespace {

/// A quarter of a circle to the left, rising by `gradient`.
std::vector<RoutePoint> quarter_circle(double radius_m, double gradient) {
  std::vector<RoutePoint> points;
  const int steps = static_cast<int>(radius_m * 3.0);
  for (int i = 0; i <= steps; ++i) {
    const double angle = 1.5707963267948966 * i / steps;
    points.push_back({.s_m = radius_m * angle,
                      .x_m = radius_m * std::sin(angle),
                      .y_m = radius_m * (1.0 - std::cos(angle)),
                      .z_m = gradient * radius_m * angle,
                      .heading_rad = angle,
                      .left_m = 4.0,
                      .right_m = 5.0});
  }
  return points;
}

/// The nearest of many places along the route.
RoutePlace search(const Route& route, double x_m, double y_m) {
  RoutePlace best;
  double least = std::numeric_limits<double>::infinity();
  const double first = route.points().front().s_m;
  for (double s = first; s <= first + route.length_m(); s += 0.02) {
    const RoutePoint p = route.at(s);
    const double distance = std::hypot(x_m - p.x_m, y_m - p.y_m);
    if (distance < least) {
      least = distance;
      const double side = std::cos(p.heading_rad) * (y_m - p.y_m) - std::sin(p.heading_rad) * (x_m - p.x_m);
      best = {s, std::copysign(distance, side), 0.0};
    }
  }
  return best;
}

TEST(Route, RefusesFewerThanTwoPointsAndDisorder) {
  EXPECT_THROW(Route(std::vector<RoutePoint>{}), Error);
  EXPECT_THROW(Route(std::vector<RoutePoint>(1)), Error);
  EXPECT_THROW(Route(std::vector<RoutePoint>(2)), Error);
}

TEST(Route, IsACircleWhereItsPointsLieOnOne) {
  const Route route(quarter_circle(30.0, 0.1));
  for (double s = 0.0; s < route.length_m(); s += 0.137) {
    const RoutePoint p = route.at(s);
    EXPECT_NEAR(std::hypot(p.x_m, p.y_m - 30.0), 30.0, 1e-5);
    EXPECT_NEAR(p.z_m, 0.1 * s, 1e-9);
    EXPECT_NEAR(route.gradient(s), 0.1, 1e-9);
  }
}

TEST(Route, FindsTheFootOfThePerpendicularToACircle) {
  const Route route(quarter_circle(30.0, 0.0));
  Random random(5, Purpose::route);
  for (int i = 0; i < 2000; ++i) {
    const double angle = random.uniform(0.02, 1.55);
    const double left = random.uniform(-60.0, 27.0);
    const RoutePlace place = route.nearest((30.0 - left) * std::sin(angle), 30.0 - (30.0 - left) * std::cos(angle));
    ASSERT_NEAR(place.s_m, 30.0 * angle, 1e-3) << left;
    ASSERT_NEAR(place.left_m, left, 1e-4);
    ASSERT_EQ(place.beyond_m, 0.0);
  }
}

TEST(Route, SaysHowFarBeyondItsEndsAPlaceLies) {
  const Route route(quarter_circle(30.0, 0.0));
  const RoutePlace before = route.nearest(-7.0, 3.0);
  EXPECT_EQ(before.s_m, 0.0);
  EXPECT_NEAR(before.beyond_m, 7.0, 1e-9);
  EXPECT_NEAR(before.left_m, 3.0, 1e-9);
  const RoutePlace behind = route.nearest(28.0, 39.0);
  EXPECT_NEAR(behind.s_m, route.length_m(), 1e-9);
  EXPECT_NEAR(behind.beyond_m, 9.0, 1e-6);
  EXPECT_NEAR(behind.left_m, 2.0, 1e-6);
}

TEST(Route, NearestIsWhatASearchFinds) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const World world = world_of("piste", seed);
    Random random(seed, Purpose::things);
    for (int i = 0; i < 150; ++i) {
      // Everywhere, also far outside of the grid.
      const double reach = i % 10 == 0 ? 900.0 : 0.0;
      const double x = random.uniform(world.area.min_x_m - reach, world.area.max_x_m + reach);
      const double y = random.uniform(world.area.min_y_m - reach, world.area.max_y_m + reach);
      const RoutePlace place = world.route.nearest(x, y);
      const RoutePlace expected = search(world.route, x, y);
      const double distance = std::hypot(place.left_m, place.beyond_m);
      ASSERT_NEAR(distance, std::abs(expected.left_m), 0.02) << x << " " << y;
      if (place.beyond_m == 0.0 && distance < 25.0) {
        ASSERT_NEAR(place.s_m, expected.s_m, 0.2) << x << " " << y;
        ASSERT_NEAR(place.left_m, expected.left_m, 0.02);
      }
    }
  }
}

TEST(Route, StaysWithinItsGradientsAndReachesTheGreatest) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    WorldPlan plan = plan_of("piste");
    plan.route.max_gradient_deg = 34.0;
    plan.route.min_gradient_deg = -8.0;
    plan.things.trees_per_hectare = 0.0;
    const World world = build_world(plan, std::nullopt, seed);
    double least = 90.0;
    double greatest = -90.0;
    for (double s = 0.5; s < world.route.length_m() - 0.5; s += 0.5) {
      const double rise = world.route.at(s + 0.25).z_m - world.route.at(s - 0.25).z_m;
      const double gradient_deg = std::atan2(rise, 0.5) * 57.29577951308232;
      least = std::min(least, gradient_deg);
      greatest = std::max(greatest, gradient_deg);
    }
    EXPECT_GE(least, -8.01);
    EXPECT_LE(least, -7.0);
    EXPECT_LE(greatest, 34.01);
    EXPECT_GE(greatest, 33.5);
  }
}

TEST(Route, BendsAsSharplyAsAskedAndNoMore) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
    WorldPlan plan = plan_of("piste");
    plan.things.trees_per_hectare = 0.0;
    const World world = build_world(plan, std::nullopt, seed);
    double sharpest = 0.0;
    const auto& points = world.route.points();
    for (std::size_t i = 1; i < points.size(); ++i) {
      sharpest = std::max(
          sharpest, std::abs(points[i].heading_rad - points[i - 1].heading_rad) / (points[i].s_m - points[i - 1].s_m));
    }
    EXPECT_LE(sharpest, 1.001 / plan.route.min_radius_m);
    EXPECT_GE(sharpest, 0.3 / plan.route.min_radius_m);
  }
}

TEST(Route, WidthsGoFromTheLeastToTheGreatest) {
  for (const std::string kind : {"piste", "haul_road"}) {
    const WorldPlan plan = plan_of(kind);
    const double low = kind == "piste" ? plan.piste.min_width_m : plan.haul_road.min_width_m;
    const double high = kind == "piste" ? plan.piste.max_width_m : plan.haul_road.max_width_m;
    const World world = world_of(kind, 7);
    double least = 1e9;
    double greatest = 0.0;
    for (const RoutePoint& p : world.route.points()) {
      least = std::min(least, p.left_m + p.right_m);
      greatest = std::max(greatest, p.left_m + p.right_m);
    }
    EXPECT_GE(least, low - 1e-6);
    EXPECT_LE(least, low + 0.7);
    EXPECT_LE(greatest, high + 1e-6);
    EXPECT_GE(greatest, high - 0.7);
  }
}

TEST(Route, BeginsAtTheOriginAndIsAsLongAsAsked) {
  for (const std::string kind : {"piste", "haul_road", "flat_road", "car_park"}) {
    const World world = world_of(kind, 3);
    const RoutePoint start = world.route.points().front();
    EXPECT_NEAR(std::hypot(start.x_m, start.y_m, start.z_m), 0.0, 1e-9);
    EXPECT_NEAR(world.route.length_m(), 300.0, 1e-9);
  }
}

}  // namespace
}  // namespace berm::sim
