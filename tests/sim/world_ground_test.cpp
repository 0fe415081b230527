#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/sim/random.hpp"
#include "sim/world_cases.hpp"

namespace berm::sim {
namespace {

const std::vector<std::string> kKinds{"piste", "haul_road", "flat_road", "car_park"};

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

/// Unit vector outwards at vertex `i` of an edge.
Eigen::Vector2d outwards(const World& world, const EdgeLine& edge, std::size_t i) {
  const Eigen::Vector2d at = edge.vertices_m[i].head<2>();
  const Eigen::Vector2d along = (edge.vertices_m[i + 1] - edge.vertices_m[i - 1]).head<2>().normalized();
  const Eigen::Vector2d out(-along.y(), along.x());
  const Eigen::Vector2d there = at + 0.5 * out;
  return world.terrain->at(there.x(), there.y()).inside_m < 0.0 ? out : Eigen::Vector2d(-out);
}

TEST(WorldGround, EdgesLieWhereInsideIsZeroAndOnTheGround) {
  for (const std::string& kind : kKinds) {
    for (const std::uint64_t seed : {1U, 2U}) {
      const World world = world_of(kind, seed);
      ASSERT_GE(world.edges.size(), 2U);
      for (const EdgeLine& edge : world.edges) {
        for (const Eigen::Vector3d& v : edge.vertices_m) {
          const GroundSample ground = world.terrain->at(v.x(), v.y());
          ASSERT_NEAR(ground.inside_m, 0.0, 2e-3) << kind << " " << v.transpose();
          ASSERT_NEAR(ground.height_m, v.z(), 1e-6);
        }
      }
    }
  }
}

TEST(WorldGround, EdgesAreWholeWhereNothingBranchesOff) {
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    for (const std::string& kind : kKinds) {
      WorldPlan plan = plan_of(kind);
      plan.piste.forks = 0;
      plan.haul_road.junctions = 0;
      plan.things.trees_per_hectare = 0.0;
      const World world = build_world(plan, std::nullopt, seed);
      ASSERT_EQ(world.edges.size(), 2U) << kind << " " << seed;
      EXPECT_NE(world.edges[0].left, world.edges[1].left);
      // On both sides of every place of the route.
      for (const EdgeLine& edge : world.edges) {
        EXPECT_GT(edge.vertices_m.size(), 2U * 300U);
      }
    }
  }
}

TEST(WorldGround, InsideIsADistanceNearTheEdges) {
  for (const std::string& kind : kKinds) {
    const World world = world_of(kind, 1);
    std::vector<double> slopes;
    Random random(1, Purpose::terrain);
    for (const RoutePoint& p : world.route.points()) {
      const double left =
          random.chance(0.5) ? p.left_m + random.uniform(-4.0, 5.0) : -p.right_m - random.uniform(-4.0, 5.0);
      const double x = p.x_m - left * std::sin(p.heading_rad);
      const double y = p.y_m + left * std::cos(p.heading_rad);
      const double step = 0.01;
      const double dx = world.terrain->at(x + step, y).inside_m - world.terrain->at(x - step, y).inside_m;
      const double dy = world.terrain->at(x, y + step).inside_m - world.terrain->at(x, y - step).inside_m;
      slopes.push_back(std::hypot(dx, dy) / (2.0 * step));
    }
    std::sort(slopes.begin(), slopes.end());
    EXPECT_NEAR(slopes[slopes.size() / 20], 1.0, 0.08) << kind;
    EXPECT_NEAR(slopes[slopes.size() / 2], 1.0, 0.02) << kind;
    EXPECT_NEAR(slopes[slopes.size() * 19 / 20], 1.0, 0.08) << kind;
  }
}

TEST(WorldGround, HeightsAreContinuousAndFinite) {
  for (const std::string& kind : kKinds) {
    const World world = world_of(kind, 2);
    Random random(2, Purpose::terrain);
    for (int i = 0; i < 40000; ++i) {
      // Around the route, where everything happens, and everywhere.
      const RoutePoint p = world.route.at(random.uniform(0.0, 300.0));
      const bool near = i % 2 == 0;
      const double x =
          near ? p.x_m + random.uniform(-30.0, 30.0) : random.uniform(world.area.min_x_m, world.area.max_x_m);
      const double y =
          near ? p.y_m + random.uniform(-30.0, 30.0) : random.uniform(world.area.min_y_m, world.area.max_y_m);
      const double turn = random.uniform(0.0, 6.283);
      const double step = 1e-4;
      const double here = world.terrain->at(x, y).height_m;
      const double there = world.terrain->at(x + step * std::cos(turn), y + step * std::sin(turn)).height_m;
      ASSERT_TRUE(std::isfinite(here));
      // No slope beyond 85 degrees: a jump of a centimetre would show.
      ASSERT_LT(std::abs(here - there), 12.0 * step) << kind << " " << x << " " << y;
    }
  }
}

TEST(WorldGround, AnswersFarOutsideAndForNonsense) {
  const World world = world_of("haul_road", 1);
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const double x : {1e4, -1e9, 1e300, inf, -inf, nan}) {
    for (const double y : {0.0, -1e5, inf, nan}) {
      const GroundSample ground = world.terrain->at(x, y);
      EXPECT_TRUE(std::isfinite(ground.height_m) && std::isfinite(ground.inside_m) && std::isfinite(ground.across_m));
    }
  }
}

TEST(WorldGround, TheMiddleOfTheRouteLiesOnTheGround) {
  for (const std::string& kind : kKinds) {
    const World world = world_of(kind, 4);
    std::vector<double> differences;
    for (const RoutePoint& p : world.route.points()) {
      differences.push_back(std::abs(world.terrain->at(p.x_m, p.y_m).height_m - p.z_m));
    }
    EXPECT_LT(median(differences), 0.05) << kind;
    EXPECT_LT(*std::max_element(differences.begin(), differences.end()), 0.5) << kind;
  }
}

/// Slope and height of what rises beyond an edge.
struct Flank {
  double slope_deg;
  double height_m;
};

std::vector<Flank> flanks_of(const World& world) {
  std::vector<Flank> flanks;
  for (const EdgeLine& edge : world.edges) {
    for (std::size_t i = 1; i + 1 < edge.vertices_m.size(); ++i) {
      const Eigen::Vector2d out = outwards(world, edge, i);
      const Eigen::Vector2d toe = edge.vertices_m[i].head<2>();
      const auto height = [&](double beyond) {
        const Eigen::Vector2d p = toe + beyond * out;
        return world.terrain->at(p.x(), p.y()).height_m - edge.vertices_m[i].z();
      };
      double top = 0.0;
      for (double beyond = 0.0; beyond < 3.0; beyond += 0.05) {
        top = std::max(top, height(beyond));
      }
      flanks.push_back({std::atan2(height(0.55) - height(0.25), 0.3) * 57.29577951308232, top});
    }
  }
  return flanks;
}

TEST(WorldGround, DumpedBermsAreAsHighAndSteepAsAsked) {
  WorldPlan plan = plan_of("haul_road");
  plan.haul_road.junctions = 0;
  plan.haul_road.cross_fall_deg = 0.0;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    std::vector<double> slopes;
    std::vector<double> heights;
    for (const Flank& flank : flanks_of(build_world(plan, std::nullopt, seed))) {
      heights.push_back(flank.height_m);
      if (flank.height_m > 0.6) {
        slopes.push_back(flank.slope_deg);
      }
    }
    EXPECT_GE(median(slopes), 31.0);
    EXPECT_LE(median(slopes), 40.0);
    std::sort(heights.begin(), heights.end());
    // Gaps are lower; roughness adds a little.
    EXPECT_LE(heights.back(), plan.haul_road.max_berm_m + 0.25);
    EXPECT_GE(heights[heights.size() * 95 / 100], 1.2);
    EXPECT_GE(heights[heights.size() / 5], 0.8 * plan.haul_road.min_berm_m);
    EXPECT_LE(heights[heights.size() / 100], 0.5 * plan.haul_road.min_berm_m);
  }
}

TEST(WorldGround, SnowBermsAreWithinTheirHeights) {
  WorldPlan plan = plan_of("piste");
  plan.piste.forks = 0;
  plan.piste.cross_fall_deg = 0.0;
  plan.piste.rough_snow_m = 0.0;
  plan.things.trees_per_hectare = 0.0;
  std::vector<double> heights;
  for (const Flank& flank : flanks_of(build_world(plan, std::nullopt, 5))) {
    heights.push_back(flank.height_m);
  }
  std::sort(heights.begin(), heights.end());
  EXPECT_LE(heights.back(), plan.piste.max_bank_m + 0.1);
  EXPECT_GE(heights.back(), 0.7 * plan.piste.max_bank_m);
  // A quarter has none.
  EXPECT_LE(heights[heights.size() / 10], 0.15);
  EXPECT_GE(heights[heights.size() / 2], plan.piste.min_bank_m);
}

TEST(WorldGround, NoEdgeLiesInsideOfAnotherRun) {
  for (const std::string kind : {"piste", "haul_road"}) {
    WorldPlan plan = plan_of(kind);
    plan.piste.forks = 2;
    plan.haul_road.junctions = 2;
    const World world = build_world(plan, std::nullopt, 1);
    // A fork opens an edge: more lines than the two of a single run, and a way out that is drivable.
    EXPECT_GE(world.edges.size(), 5U) << kind;
    int both_inside = 0;
    for (const EdgeLine& edge : world.edges) {
      for (std::size_t i = 1; i + 1 < edge.vertices_m.size(); ++i) {
        // Drivable on one side at least; where two runs part, the tip between them is narrow.
        const Eigen::Vector2d aside = 0.1 * outwards(world, edge, i);
        const Eigen::Vector2d at = edge.vertices_m[i].head<2>();
        const double one = world.terrain->at(at.x() - aside.x(), at.y() - aside.y()).inside_m;
        const double other = world.terrain->at(at.x() + aside.x(), at.y() + aside.y()).inside_m;
        ASSERT_GT(std::max(one, other), 0.05);
        both_inside += std::min(one, other) > 0.0 ? 1 : 0;
      }
    }
    EXPECT_LE(both_inside, 8) << kind;
  }
}

TEST(WorldGround, WaterIsLevel) {
  WorldPlan plan = plan_of("haul_road");
  plan.haul_road.puddles_per_km = 200;
  const World world = build_world(plan, std::nullopt, 1);
  int wet = 0;
  for (const RoutePoint& p : world.route.points()) {
    for (double left = -p.right_m; left < p.left_m; left += 0.25) {
      const double x = p.x_m - left * std::sin(p.heading_rad);
      const double y = p.y_m + left * std::cos(p.heading_rad);
      const GroundSample ground = world.terrain->at(x, y);
      const GroundSample beside = world.terrain->at(x + 0.1, y);
      if (ground.surface == Surface::water && beside.surface == Surface::water) {
        ++wet;
        ASSERT_GT(ground.inside_m, 0.0);
        ASSERT_NEAR(ground.height_m, beside.height_m, 1e-3);
      }
    }
  }
  EXPECT_GT(wet, 100);
}

TEST(WorldGround, ThePitHasAWallAndADrop) {
  const World world = world_of("haul_road", 1);
  std::vector<double> left;
  std::vector<double> right;
  for (double s = 60.0; s < 100.0; s += 1.0) {
    const RoutePoint p = world.route.at(s);
    const auto height = [&](double to_left) {
      return world.terrain->at(p.x_m - to_left * std::sin(p.heading_rad), p.y_m + to_left * std::cos(p.heading_rad))
                 .height_m -
             p.z_m;
    };
    left.push_back(height(p.left_m + 28.0));
    right.push_back(height(-p.right_m - 28.0));
  }
  EXPECT_GT(std::max(median(left), median(right)), 8.0);
  EXPECT_LT(std::min(median(left), median(right)), -8.0);
}

TEST(WorldGround, TheSameSeedGivesTheSameGroundAndAnotherOneAnother) {
  for (const std::string& kind : kKinds) {
    const World a = world_of(kind, 1);
    const World b = world_of(kind, 1);
    const World c = world_of(kind, 2);
    int same_as_other = 0;
    for (int i = 0; i < 500; ++i) {
      const double x = -100.0 + i;
      const double y = 0.37 * i - 50.0;
      ASSERT_EQ(a.terrain->at(x, y).height_m, b.terrain->at(x, y).height_m);
      same_as_other += a.terrain->at(x, y).height_m == c.terrain->at(x, y).height_m ? 1 : 0;
    }
    EXPECT_EQ(same_as_other, 0) << kind;
    ASSERT_EQ(a.edges.size(), b.edges.size());
    EXPECT_EQ(a.edges[0].vertices_m, b.edges[0].vertices_m);
    EXPECT_NE(a.edges[0].vertices_m, c.edges[0].vertices_m);
    EXPECT_NE(a.route.points()[400].x_m, c.route.points()[400].x_m);
  }
}

TEST(WorldPlan, RefusesWhatContradictsItself) {
  const auto refused_key = [](const WorldPlan& plan) -> std::string {
    try {
      plan.check();
    } catch (const ConfigError& error) {
      return error.key();
    }
    return "";
  };
  EXPECT_EQ(refused_key(WorldPlan{}), "");
  WorldPlan plan;
  plan.route.min_gradient_deg = 30.0;
  EXPECT_EQ(refused_key(plan), "route.min_gradient_deg");
  plan = {};
  plan.piste.min_width_m = 40.0;
  EXPECT_EQ(refused_key(plan), "piste.min_width_m");
  plan = {};
  plan.route.min_radius_m = 12.0;
  EXPECT_EQ(refused_key(plan), "route.min_radius_m");
  plan = {};
  plan.world.kind = "sea";
  EXPECT_EQ(refused_key(plan), "world.kind");
  plan = {};
  plan.route.length_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused_key(plan), "route.length_m");
}

}  // namespace
}  // namespace berm::sim
