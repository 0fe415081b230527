#include "terrain_part.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace berm {
namespace {

const Eigen::Vector3d kTerrainOrigin_m(1000.0, 2000.0, 100.0);

template <typename Height>
HeightRaster make_raster(std::size_t columns, std::size_t rows, double cell_m, Height height) {
  HeightRaster raster{.origin_x_m = 1010.0, .origin_y_m = 2020.0, .cell_m = cell_m, .columns = columns, .rows = rows};
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      raster.heights_m.push_back(static_cast<float>(height(cell_m * double(column), cell_m * double(row))));
    }
  }
  return raster;
}

std::vector<std::uint8_t> bytes_of(const nlohmann::ordered_json& part) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  std::uint32_t held = 0;
  for (const char digit : part["shade"].get<std::string>()) {
    if (digit == '=') {
      break;
    }
    bits = bits << 6U | static_cast<std::uint32_t>(digits.find(digit));
    held += 6;
    if (held >= 8) {
      held -= 8;
      bytes.push_back(static_cast<std::uint8_t>(bits >> held & 255U));
    }
  }
  return bytes;
}

TEST(TerrainPart, LevelGroundIsGrey) {
  const auto part = terrain_part(make_raster(3, 2, 0.5, [](double, double) { return 103.5; }), kTerrainOrigin_m);
  EXPECT_EQ(part["x_m"], 10.0);
  EXPECT_EQ(part["y_m"], 20.0);
  EXPECT_EQ(part["columns"], 3);
  EXPECT_EQ(part["rows"], 2);
  EXPECT_EQ(part["low_m"], 3.5);
  EXPECT_EQ(part["high_m"], 3.5);
  EXPECT_EQ(bytes_of(part), std::vector<std::uint8_t>(6, 128));
}

/// A plane of 41 cells a side, with a small hill (slopes of 0.1) in its middle.
std::vector<std::uint8_t> shade_hill(double to_east, double to_north) {
  const auto raster = make_raster(41, 41, 1.0, [&](double x_m, double y_m) {
    const double hill_m = std::max(0.0, 1.0 - 0.1 * (std::abs(x_m - 20.0) + std::abs(y_m - 20.0)));
    return hill_m + to_east * x_m + to_north * y_m;
  });
  return bytes_of(terrain_part(raster, kTerrainOrigin_m));
}

TEST(TerrainPart, WhatLooksToTheNorthWestIsBright) {
  const auto at = [](const std::vector<std::uint8_t>& shade, int east, int north) {
    return int{shade[static_cast<std::size_t>((20 - north) * 41 + 20 + east)]};
  };
  // Level, and on slopes of 20 degrees that look to the lamp or away from it: the hill is seen on all of them.
  for (const auto& [to_east, to_north] : {std::pair(0.0, 0.0), std::pair(0.25, -0.25), std::pair(-0.25, 0.25)}) {
    const auto shade = shade_hill(to_east, to_north);
    EXPECT_GT(at(shade, -3, 3), at(shade, 15, 15) + 15);
    EXPECT_LT(at(shade, 3, -3), at(shade, 15, 15) - 15);
  }
}

TEST(TerrainPart, TheFirstRowIsTheNorthernOneAndHolesStayOpen) {
  auto raster = make_raster(2, 2, 1.0, [](double, double) { return 0.0; });
  raster.heights_m[3] = std::nanf("");  // north-east
  const auto shade = bytes_of(terrain_part(raster, kTerrainOrigin_m));
  EXPECT_EQ(shade, (std::vector<std::uint8_t>{128, 0, 128, 128}));
}

TEST(TerrainPart, LargeRastersAreJoined) {
  const auto part = terrain_part(make_raster(1001, 700, 0.5, [](double x_m, double) { return x_m; }), kTerrainOrigin_m);
  const auto columns = part["columns"].get<std::size_t>();
  const auto rows = part["rows"].get<std::size_t>();
  EXPECT_LE(columns * rows, 100'000U);
  EXPECT_GT(columns * rows, 50'000U);
  EXPECT_EQ(part["cell_m"], 1.5);
  EXPECT_EQ(columns, 334U);
  EXPECT_EQ(bytes_of(part).size(), columns * rows);
  EXPECT_NEAR(part["low_m"].get<double>(), 0.5 - 100.0, 0.01);
  EXPECT_NEAR(part["high_m"].get<double>(), 500.0 - 0.25 - 100.0, 0.3);
}

TEST(TerrainPart, WithoutAnyHeightThereIsNone) {
  EXPECT_TRUE(
      terrain_part(make_raster(3, 3, 1.0, [](double, double) { return std::nan(""); }), kTerrainOrigin_m).empty());
}

}  // namespace
}  // namespace berm
