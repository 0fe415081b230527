#include "terrain_part.hpp"

#include <cmath>
#include <cstdint>
#include <string>
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

TEST(TerrainPart, LevelGroundIsAsBrightAsTheHeightOfTheLamp) {
  const auto part = terrain_part(make_raster(3, 2, 0.5, [](double, double) { return 103.5; }), kTerrainOrigin_m);
  EXPECT_EQ(part["x_m"], 10.0);
  EXPECT_EQ(part["y_m"], 20.0);
  EXPECT_EQ(part["columns"], 3);
  EXPECT_EQ(part["rows"], 2);
  EXPECT_EQ(part["low_m"], 3.5);
  EXPECT_EQ(part["high_m"], 3.5);
  EXPECT_EQ(bytes_of(part), std::vector<std::uint8_t>(6, 181));  // 1 + 254 sin 45
}

TEST(TerrainPart, WhatLooksToTheNorthWestIsBright) {
  const auto shade_of = [](double to_east, double to_north) {
    const auto raster = make_raster(5, 5, 1.0, [&](double x_m, double y_m) { return to_east * x_m + to_north * y_m; });
    return bytes_of(terrain_part(raster, kTerrainOrigin_m)).at(12);
  };
  const std::uint8_t level = shade_of(0.0, 0.0);
  // A slope that falls to the west looks there; twice as steep as it is, 26.6 degrees are 45.
  EXPECT_GT(shade_of(0.1, 0.0), level);
  EXPECT_GT(shade_of(0.0, -0.1), level);
  EXPECT_LT(shade_of(-0.1, 0.0), level);
  EXPECT_LT(shade_of(0.0, 0.1), level);
  EXPECT_EQ(shade_of(0.5 * std::sqrt(0.5), -0.5 * std::sqrt(0.5)), 255);
  EXPECT_EQ(shade_of(-5.0, 5.0), 1);
}

TEST(TerrainPart, TheFirstRowIsTheNorthernOneAndHolesStayOpen) {
  auto raster = make_raster(2, 2, 1.0, [](double, double) { return 0.0; });
  raster.heights_m[3] = std::nanf("");  // north-east
  const auto shade = bytes_of(terrain_part(raster, kTerrainOrigin_m));
  EXPECT_EQ(shade, (std::vector<std::uint8_t>{181, 0, 181, 181}));
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
