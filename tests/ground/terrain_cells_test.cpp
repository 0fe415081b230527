#include "terrain_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "ground/ground_cases.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

struct Located {
  std::vector<std::uint16_t> cell;
  std::vector<float> height_m;
};

Located locate(const TerrainCells& cells, const std::vector<Vector3f>& points, const Pose& T_level_sensor = Pose()) {
  Located located{std::vector<std::uint16_t>(points.size()), std::vector<float>(points.size())};
  const PointCloud cloud = test::cloud_of(points);
  locate_points(cloud.view(), LevelFrame(T_level_sensor), cells, located.cell, located.height_m);
  return located;
}

/// Grids of several shapes, the default first.
std::vector<TerrainCells> several_grids() {
  return {TerrainCells(180, 0.25, 120.0), TerrainCells(16, 2.0, 500.0), TerrainCells(360, 0.5, 80.0),
          TerrainCells(101, 0.1, 5.0), TerrainCells(90, 0.3, 33.3)};
}

std::vector<Vector3d> random_places(std::size_t count, double max_range_m) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<Vector3d> places;
  while (places.size() < count) {
    // Near places as often as far ones.
    const double range_m = max_range_m * std::pow(std::fabs(unit(random)), 2.0);
    const double azimuth_rad = std::numbers::pi * unit(random);
    places.emplace_back(range_m * std::cos(azimuth_rad), range_m * std::sin(azimuth_rad), 5.0 * unit(random));
  }
  return places;
}

TEST(TerrainCells, EdgesStartAtTheSensorGrowAndReachTheRange) {
  for (const TerrainCells& cells : several_grids()) {
    ASSERT_EQ(cells.edges_m.size(), static_cast<std::size_t>(cells.bins) + 1);
    EXPECT_EQ(cells.edges_m.front(), 0.0F);
    EXPECT_GE(cells.edges_m.back(), cells.max_range_m);
    EXPECT_LT(cells.edges_m[cells.edges_m.size() - 2], cells.max_range_m) << "no bin beyond the range";
    double last_length_m = 0.0;
    for (std::size_t b = 1; b < cells.edges_m.size(); ++b) {
      const double length_m = static_cast<double>(cells.edges_m[b] - cells.edges_m[b - 1]);
      EXPECT_GT(length_m, 0.999 * last_length_m);
      EXPECT_LT(last_length_m == 0.0 ? 0.0 : length_m / last_length_m, 2.001);
      last_length_m = length_m;
    }
  }
}

TEST(TerrainCells, AreAsLongAsAskedAndTwiceThatFromEightMetres) {
  const TerrainCells cells(180, 0.25, 120.0);
  const auto length_at = [&cells](float range_m) {
    const auto above = std::upper_bound(cells.edges_m.begin(), cells.edges_m.end(), range_m);
    return *above - *(above - 1);
  };
  EXPECT_FLOAT_EQ(length_at(0.1F), 0.25F);
  EXPECT_FLOAT_EQ(length_at(7.9F), 0.25F);
  EXPECT_FLOAT_EQ(length_at(8.1F), 0.5F);
  EXPECT_FLOAT_EQ(length_at(23.9F), 0.5F);
  EXPECT_FLOAT_EQ(length_at(24.1F), 1.0F);
  EXPECT_FLOAT_EQ(length_at(56.1F), 2.0F);
}

TEST(TerrainCells, IndexIsThatOfABruteForceSearch) {
  for (const TerrainCells& cells : several_grids()) {
    const Pose T_level_sensor = Pose::from_yaw_pitch_roll(0.0, 0.2, -0.3, {0.0, 0.0, 1.7});
    const std::vector<Vector3d> places = random_places(20000, 1.2 * static_cast<double>(cells.max_range_m));
    std::vector<Vector3f> points;
    for (const Vector3d& place : places) {
      points.push_back((T_level_sensor.inverse() * place).cast<float>());
    }
    const Located located = locate(cells, points, T_level_sensor);
    std::size_t judged = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      EXPECT_NEAR(located.height_m[i], places[i].z(), 1e-3);
      const double range_m = std::hypot(places[i].x(), places[i].y());
      const double turn = (std::atan2(places[i].y(), places[i].x()) + std::numbers::pi) / (2.0 * std::numbers::pi);
      const double sector = turn * cells.sectors;
      // The azimuth is good to 7e-4 rad, the range to float.
      const double near_sector_edge = std::fabs(sector - std::round(sector)) * 2.0 * std::numbers::pi / cells.sectors;
      const double slack_m = 1e-4 + 1e-5 * range_m;
      const auto near_edge = [&](float edge_m) { return std::fabs(static_cast<double>(edge_m) - range_m) < slack_m; };
      if (near_sector_edge < 7.5e-4 || std::any_of(cells.edges_m.begin(), cells.edges_m.end(), near_edge) ||
          near_edge(cells.max_range_m)) {
        continue;
      }
      ++judged;
      std::size_t expected = cells.size();
      for (std::size_t b = 0; b + 1 < cells.edges_m.size() && range_m < static_cast<double>(cells.max_range_m); ++b) {
        if (range_m >= static_cast<double>(cells.edges_m[b]) && range_m < static_cast<double>(cells.edges_m[b + 1])) {
          expected = b * static_cast<std::size_t>(cells.sectors) + static_cast<std::size_t>(sector);
        }
      }
      ASSERT_EQ(located.cell[i], expected) << "at " << places[i].transpose() << ", range " << range_m;
    }
    EXPECT_GT(judged, places.size() * 3 / 4) << "too many places lie on borders for this test to mean anything";
  }
}

TEST(TerrainCells, LookUpInTheGridAgrees) {
  for (const TerrainCells& cells : several_grids()) {
    const PolarGrid grid = cells.grid();
    ASSERT_EQ(grid.size(), cells.size());
    std::vector<Vector3f> points;
    for (const Vector3d& place : random_places(20000, 0.999 * static_cast<double>(cells.max_range_m))) {
      points.push_back(place.cast<float>());
    }
    const Located located = locate(cells, points);
    std::size_t different = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto cell = grid.cell_of(static_cast<double>(points[i].x()), static_cast<double>(points[i].y()));
      ASSERT_TRUE(cell.has_value());
      const auto at = static_cast<std::size_t>(cell->bin * cells.sectors + cell->sector);
      different += located.cell[i] != at ? 1U : 0U;
    }
    // Only where the azimuth is wrong by up to 7e-4 rad at both borders of a sector.
    EXPECT_LT(static_cast<double>(different), 0.5 * 2.0 * 7e-4 * cells.sectors / (2.0 * std::numbers::pi) * 20000 + 5);
  }
}

TEST(TerrainCells, AxesAndDiagonalsLieInTheirSectors) {
  const TerrainCells cells(8, 0.25, 120.0);
  const auto sector = [&cells](float x, float y) { return locate(cells, {{x, y, 0.0F}}).cell[0] % 8; };
  EXPECT_EQ(sector(10.0F, 1.0F), 4);
  EXPECT_EQ(sector(1.0F, 10.0F), 5);
  EXPECT_EQ(sector(-1.0F, 10.0F), 6);
  EXPECT_EQ(sector(-10.0F, 1.0F), 7);
  EXPECT_EQ(sector(-10.0F, -1.0F), 0);
  EXPECT_EQ(sector(-1.0F, -10.0F), 1);
  EXPECT_EQ(sector(1.0F, -10.0F), 2);
  EXPECT_EQ(sector(10.0F, -1.0F), 3);
}

TEST(TerrainCells, WhatIsNoPlaceLandsNowhere) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kMax = std::numeric_limits<float>::max();
  const std::vector<Vector3f> points = {{kNan, 1.0F, 1.0F},   {1.0F, kNan, 1.0F},  {kNan, kNan, kNan},
                                        {1.0F, 1.0F, kNan},   {1.0F, 1.0F, kInf},  {kInf, 0.0F, 0.0F},
                                        {-kInf, kInf, -kInf}, {kMax, 0.0F, 0.0F},  {-kMax, -kMax, -kMax},
                                        {0.0F, 0.0F, 0.0F},   {-0.0F, 0.0F, -0.0F}};
  for (const Pose& T_level_sensor : {Pose(), Pose::from_yaw_pitch_roll(0.0, 0.2, 0.1, {0.0, 0.0, 2.0})}) {
    const TerrainCells cells(180, 0.25, 120.0);
    const Located located = locate(cells, points, T_level_sensor);
    for (std::size_t i = 0; i < points.size(); ++i) {
      EXPECT_EQ(located.cell[i], cells.size()) << points[i].transpose();
    }
  }
}

TEST(TerrainCells, NearAndFarEndsOfTheRangeStayInside) {
  for (const TerrainCells& cells : several_grids()) {
    const float below_m = std::nextafter(cells.max_range_m, 0.0F);
    const Located located = locate(cells, {{1e-40F, 0.0F, 0.0F},
                                           {std::numeric_limits<float>::denorm_min(), 0.0F, 1.0F},
                                           {0.0F, 0.0F, -2.0F},
                                           {below_m, 0.0F, 0.0F},
                                           {-below_m, -0.0F, 0.0F},
                                           {-below_m, 0.0F, 0.0F},
                                           {cells.max_range_m, 0.0F, 0.0F}});
    const auto bin = [&](std::size_t i) { return static_cast<int>(located.cell[i]) / cells.sectors; };
    EXPECT_EQ(bin(0), 0);
    EXPECT_EQ(bin(1), 0);
    EXPECT_EQ(bin(2), 0) << "straight below the sensor";
    EXPECT_EQ(bin(3), cells.bins - 1);
    EXPECT_EQ(bin(4), cells.bins - 1);
    EXPECT_EQ(bin(5), cells.bins - 1);
    for (const std::size_t straight_behind : {4U, 5U}) {
      const int sector = located.cell[straight_behind] % cells.sectors;
      EXPECT_TRUE(sector == 0 || sector == cells.sectors - 1) << sector;
    }
    EXPECT_EQ(located.cell[6], cells.size()) << "the range itself is outside";
  }
}

TEST(TerrainGroundConfig, RefusesWhatIsOutOfRangeAndTooManyCells) {
  EXPECT_NO_THROW(TerrainGroundConfig{}.check());
  const auto key_refused = [](auto&& spoil) -> std::string {
    TerrainGroundConfig config;
    spoil(config);
    try {
      const TerrainGround ground(config);
    } catch (const ConfigError& error) {
      return error.key();
    }
    return "none";
  };
  using C = TerrainGroundConfig;
  EXPECT_EQ(key_refused([](C& c) { c.sectors = 3; }), "ground.sectors");
  EXPECT_EQ(key_refused([](C& c) { c.cell_m = 0.0; }), "ground.cell_m");
  EXPECT_EQ(key_refused([](C& c) { c.max_tilt_deg = 90.0; }), "ground.max_tilt_deg");
  EXPECT_EQ(key_refused([](C& c) { c.step_down_m = std::nan(""); }), "ground.step_down_m");
  EXPECT_EQ(key_refused([](C& c) { c.sectors = 1024, c.cell_m = 0.1, c.max_range_m = 500.0; }), "ground.cell_m");
  EXPECT_EQ(key_refused([](C& c) { c.sectors = 1024, c.cell_m = 0.5, c.max_range_m = 60.0; }), "none");
}

}  // namespace
}  // namespace berm
