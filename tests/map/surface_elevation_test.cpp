#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "berm/map/elevation.hpp"

namespace berm {
namespace {

SurfacePoint ground(double x_m, double y_m, double z_m, Label label = Label::drivable) {
  return {.x_m = static_cast<float>(x_m),
          .y_m = static_cast<float>(y_m),
          .z_m = static_cast<float>(z_m),
          .label = label,
          .count = 1};
}

double plane_m(double x_m, double y_m) {
  return 3.0 + 0.5 * x_m - 0.25 * y_m;
}

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11U) * 0x1p-53;
}

/// Points on a plane of 29 deg at random places of 10 x 10 m.
std::vector<SurfacePoint> points_on_plane(std::mt19937_64& random, int count) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i < count; ++i) {
    const double x_m = 10.0 * uniform(random);
    const double y_m = 10.0 * uniform(random);
    points.push_back(ground(x_m, y_m, plane_m(x_m, y_m)));
  }
  return points;
}

double worst_m(const std::vector<ElevationCell>& cells, double cell_m) {
  double worst = 0.0;
  for (const ElevationCell& cell : cells) {
    worst = std::max(worst, std::abs(cell.height_m - plane_m((cell.column + 0.5) * cell_m, (cell.row + 0.5) * cell_m)));
  }
  return worst;
}

TEST(ElevationTest, HeightIsThatAtTheMiddleOfACellOnASlopeToo) {
  std::mt19937_64 random(1);
  ElevationBuilder builder(20.0, 0.5);
  builder.add_tile(points_on_plane(random, 20000));
  const std::vector<ElevationCell> cells = builder.finish();
  ASSERT_EQ(cells.size(), 400U);
  EXPECT_LT(worst_m(cells, 0.5), 0.002);
  for (const ElevationCell& cell : cells) {
    ASSERT_TRUE(cell.slope_rad.has_value());
    EXPECT_NEAR(*cell.slope_rad, std::atan(std::hypot(0.5, 0.25)), 0.01);
    EXPECT_LT(cell.sigma_m, 0.005);
    EXPECT_GT(cell.points, 0U);
  }
}

TEST(ElevationTest, StalksAndObstaclesDoNotLiftTheGround) {
  std::mt19937_64 random(2);
  std::vector<SurfacePoint> points = points_on_plane(random, 8000);
  for (int i = 0; i < 2000; ++i) {
    SurfacePoint point = points[static_cast<std::size_t>(i)];
    point.z_m += static_cast<float>(0.3 + uniform(random));
    point.label = i % 2 == 0 ? Label::obstacle : Label::terrain;
    points.push_back(point);
  }
  ElevationBuilder builder(20.0, 0.5);
  builder.add_tile(points);
  EXPECT_LT(worst_m(builder.finish(), 0.5), 0.05);
}

TEST(ElevationTest, ThinGroundTakesItsSlopeFromItsNeighbours) {
  std::mt19937_64 random(3);
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 20; ++i) {
    for (int k = 0; k < 20; ++k) {
      // One point in each cell, off its middle.
      const double x_m = 0.5 * (i + 0.15 + 0.3 * uniform(random));
      const double y_m = 0.5 * (k + 0.15 + 0.3 * uniform(random));
      points.push_back(ground(x_m, y_m, plane_m(x_m, y_m)));
    }
  }
  ElevationBuilder builder(20.0, 0.5);
  builder.add_tile(points);
  EXPECT_LT(worst_m(builder.finish(), 0.5), 0.01);
}

TEST(ElevationTest, OddInput) {
  ElevationBuilder builder(20.0, 0.3);
  EXPECT_NEAR(builder.cell_m(), 20.0 / 67.0, 1e-12) << "a whole number of cells a tile";
  builder.add_tile({});
  EXPECT_TRUE(builder.finish().empty());
  const std::vector<SurfacePoint> same(1000, ground(1.0, 1.0, 5.0, Label::terrain));
  builder.add_tile(same);
  const auto cells = builder.finish();
  ASSERT_EQ(cells.size(), 1U);
  EXPECT_DOUBLE_EQ(cells[0].height_m, 5.0);
  EXPECT_FALSE(cells[0].slope_rad.has_value());
}

}  // namespace
}  // namespace berm
