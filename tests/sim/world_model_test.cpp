#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "sim/world_cases.hpp"
#include "support/data.hpp"

namespace berm::sim {
namespace {

HeightRaster make_model(std::size_t side, double cell_m, const std::function<double(double, double)>& height) {
  HeightRaster model;
  model.origin_x_m = 5000.0;
  model.origin_y_m = -3000.0;
  model.cell_m = cell_m;
  model.columns = side;
  model.rows = side;
  for (std::size_t row = 0; row < side; ++row) {
    for (std::size_t column = 0; column < side; ++column) {
      model.heights_m.push_back(static_cast<float>(
          height((static_cast<double>(column) + 0.5) * cell_m, (static_cast<double>(row) + 0.5) * cell_m)));
    }
  }
  return model;
}

/// A hillside that rises to the north by 0.3, with hills.
double hillside(double x, double y) {
  return 800.0 + 0.3 * y + 6.0 * std::sin(x / 60.0) * std::cos(y / 75.0);
}

WorldPlan small_plan() {
  WorldPlan plan = plan_of("piste");
  plan.route.length_m = 200.0;
  plan.route.min_gradient_deg = -20.0;
  plan.route.max_gradient_deg = 20.0;
  plan.things.trees_per_hectare = 0.0;
  plan.piste.forks = 0;
  return plan;
}

std::string message_of(const WorldPlan& plan, const HeightRaster& model) {
  try {
    static_cast<void>(build_world(plan, model, 1));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(WorldOnModel, LiesOnTheModel) {
  const HeightRaster model = make_model(400, 2.5, hillside);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const World world = build_world(small_plan(), model, seed);
    EXPECT_NEAR(world.origin_m.x(), 5500.0, 1e-9);
    EXPECT_NEAR(world.origin_m.y(), -2500.0, 1e-9);
    const auto natural = [&](double x, double y) { return hillside(500.0 + x, 500.0 + y) - world.origin_m.z(); };
    for (const RoutePoint& p : world.route.points()) {
      // Cut and fill are limited.
      ASSERT_NEAR(p.z_m, natural(p.x_m, p.y_m), 4.1);
      // Far beside, the ground is the model's but for the roughness of the snow.
      const double x = p.x_m - 60.0 * std::sin(p.heading_rad);
      const double y = p.y_m + 60.0 * std::cos(p.heading_rad);
      if (world.terrain->at(x, y).inside_m < -40.0) {
        ASSERT_NEAR(world.terrain->at(x, y).height_m, natural(x, y), 0.6);
      }
    }
    EXPECT_NEAR(world.route.points().front().z_m, 0.0, 1e-9);
  }
}

TEST(WorldOnModel, KeepsToTheGradients) {
  const HeightRaster model = make_model(400, 2.5, hillside);
  WorldPlan plan = small_plan();
  plan.route.min_gradient_deg = 2.0;
  plan.route.max_gradient_deg = 9.0;
  const World world = build_world(plan, model, 4);
  for (double s = 1.0; s < world.route.length_m() - 1.0; s += 1.0) {
    const double gradient_deg = std::atan(world.route.gradient(s)) * 57.29577951308232;
    ASSERT_GE(gradient_deg, 1.95);
    ASSERT_LE(gradient_deg, 9.05);
  }
}

TEST(WorldOnModel, KeepsToKnownGround) {
  // Known only in a band 160 m wide that runs to the north-east.
  const HeightRaster model = make_model(400, 2.5, [](double x, double y) {
    return std::abs(x - y) < 160.0 ? 100.0 + 0.1 * x : std::numeric_limits<double>::quiet_NaN();
  });
  const World world = build_world(small_plan(), model, 1);
  for (const EdgeLine& edge : world.edges) {
    for (const Eigen::Vector3d& v : edge.vertices_m) {
      ASSERT_LT(std::abs(v.x() - v.y()), 160.0);
    }
  }
  // What is not known is filled: finite and near to what is.
  for (double x = world.area.min_x_m; x < world.area.max_x_m; x += 7.0) {
    const GroundSample ground = world.terrain->at(x, -x);
    ASSERT_TRUE(std::isfinite(ground.height_m));
    ASSERT_LT(std::abs(ground.height_m), 60.0);
  }
}

TEST(WorldOnModel, SaysWhereHeightsAreMissing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of(small_plan(), make_model(100, 10.0, [&](double, double) { return nan; })).find("known"),
            std::string::npos);
  // A hole at the start.
  const std::string hole = message_of(small_plan(), make_model(400, 2.5, [&](double x, double y) {
                                        return std::hypot(x - 500.0, y - 500.0) < 40.0 ? nan : 0.0;
                                      }));
  EXPECT_NE(hole.find("world.elevation_x"), std::string::npos) << hole;
  // Too small for the route.
  const std::string small = message_of(small_plan(), make_model(100, 2.0, hillside));
  EXPECT_NE(small.find("route.length_m"), std::string::npos) << small;
}

TEST(WorldOnModel, SaysWhatIsTooSteep) {
  WorldPlan plan = small_plan();
  plan.route.min_gradient_deg = 12.0;
  plan.route.max_gradient_deg = 20.0;
  const std::string flat = message_of(plan, make_model(400, 2.5, [](double, double) { return 100.0; }));
  EXPECT_NE(flat.find("route.min_gradient_deg"), std::string::npos) << flat;
}

TEST(WorldOnModel, RefusesModelsThatContradictThemselves) {
  HeightRaster model = make_model(10, 5.0, hillside);
  model.columns = 11;
  EXPECT_NE(message_of(small_plan(), model), "");
  EXPECT_NE(message_of(small_plan(), HeightRaster{}), "");
  model = make_model(10, 5.0, hillside);
  model.cell_m = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message_of(small_plan(), model), "");
  model = make_model(10, 5.0, hillside);
  model.origin_x_m = std::numeric_limits<double>::infinity();
  EXPECT_NE(message_of(small_plan(), model), "");
}

TEST(WorldOnModel, LiesOnRealMountains) {
  BERM_NEED_DATA(folder, "alpine_dem");
  WorldPlan plan = small_plan();
  plan.route.length_m = 400.0;
  plan.route.min_gradient_deg = -5.0;
  plan.route.max_gradient_deg = 25.0;
  const World world = build_world(plan, read_height_raster(folder / "avaWog.asc"), 3);
  EXPECT_EQ(world.edges.size(), 2U);
  EXPECT_NEAR(world.route.length_m(), 400.0, 1e-9);
}

}  // namespace
}  // namespace berm::sim
