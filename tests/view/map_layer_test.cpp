#include "map_layer.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using Json = nlohmann::json;

constexpr double kVoxel_m = 0.5;
constexpr double kTile_m = 20.0;
const Eigen::Vector3d kOrigin_m(1000.0, 2000.0, 100.0);

/// A level square of tiles from (-1, -1) to (1, 1), a point in every voxel.
void write_map(const std::filesystem::path& folder) {
  SurfaceFolder map(folder, {.voxel_m = kVoxel_m, .tile_m = kTile_m, .origin_m = kOrigin_m});
  for (std::int32_t x = -1; x <= 1; ++x) {
    for (std::int32_t y = -1; y <= 1; ++y) {
      std::vector<SurfacePoint> points;
      for (int i = 0; i < 40 * 40; ++i) {
        points.push_back({.x_m = static_cast<float>(x * kTile_m + (i % 40 + 0.5) * kVoxel_m),
                          .y_m = static_cast<float>(y * kTile_m + (i / 40 + 0.5) * kVoxel_m),
                          .z_m = 0.25F,
                          .intensity = 50.0F,
                          .label = Label::terrain,
                          .count = 1});
      }
      map.save({x, y}, points);
    }
  }
  map.commit();
}

float value_at(const std::string& payload, std::size_t array, std::size_t i) {
  std::uint32_t points = 0;
  std::memcpy(&points, payload.data() + 4, sizeof(points));
  float value = 0.0F;
  std::memcpy(&value, payload.data() + 16 + 4 * (array * points + i), sizeof(value));
  return value;
}

TEST(MapLayer, TilesTogetherHoldEveryPointOnce) {
  const test::TempFolder folder;
  write_map(folder.path());
  const MapLayer layer(folder.path(), kOrigin_m - Eigen::Vector3d(100.0, 0.0, 0.0), false);
  const Json map = Json::parse(layer.describe());
  std::set<std::tuple<float, float, float>> seen;
  std::size_t points = 0;
  std::size_t coarse = 0;
  for (const Json& tile : map["tiles"]) {
    const auto payload = layer.read(tile["id"].get<std::size_t>());
    ASSERT_TRUE(payload);
    const auto count = tile["points"].get<std::size_t>();
    ASSERT_EQ(payload->size(), 16 + 16 * count);
    points += count;
    coarse += tile["level"] == 0 ? count : 0;
    for (std::size_t i = 0; i < count; ++i) {
      const float x_m = value_at(*payload, 0, i);
      EXPECT_GE(x_m, tile["min"][0].get<float>());
      EXPECT_LE(x_m, tile["max"][0].get<float>());
      seen.emplace(x_m, value_at(*payload, 1, i), value_at(*payload, 2, i));
    }
  }
  EXPECT_EQ(points, 9U * 1600U);
  EXPECT_EQ(seen.size(), points);
  // Cells of 8 m on tiles of 20 m: 3 x 3 cells a tile, some of them cut by its end.
  EXPECT_EQ(coarse, 9U * 9U);
  EXPECT_FLOAT_EQ(map["bounds"]["min"][0].get<float>(), 100.0F - 19.75F);
  EXPECT_FLOAT_EQ(map["bounds"]["max"][1].get<float>(), 39.75F);
  EXPECT_FALSE(layer.read(1000));
}

TEST(MapLayer, ALevelIsAsThinAsItSays) {
  std::vector<SurfacePoint> points;
  for (int i = 0; i < 64 * 64; ++i) {
    points.push_back({.x_m = static_cast<float>(i % 64) + 0.5F, .y_m = static_cast<float>(i / 64) + 0.5F, .z_m = 0.5F});
  }
  std::vector<std::uint8_t> levels;
  choose_map_levels(points, 1.0, levels);
  std::size_t count[kMapLevels] = {};
  for (const std::uint8_t level : levels) {
    ++count[level];
  }
  EXPECT_EQ(count[0], 16U);
  EXPECT_EQ(count[0] + count[1], 256U);
  std::vector<std::uint8_t> again(7);
  choose_map_levels(points, 1.0, again);
  EXPECT_EQ(levels, again);
  choose_map_levels({}, 1.0, again);
  EXPECT_TRUE(again.empty());
}

TEST(MapLayer, CellsGoOnBelowZero) {
  // Cells of 4 and of 16 voxels from -16 to 16: were values rounded towards zero the cells about it would be joined.
  std::vector<SurfacePoint> points;
  for (int i = -16; i < 16; ++i) {
    points.push_back({.x_m = static_cast<float>(i) + 0.5F, .y_m = 0.5F, .z_m = 0.5F});
  }
  std::vector<std::uint8_t> levels;
  choose_map_levels(points, 1.0, levels);
  EXPECT_EQ(std::count(levels.begin(), levels.end(), 0), 2);
  EXPECT_EQ(std::count(levels.begin(), levels.end(), 1), 6);
}

TEST(MapLayer, SaysWhichTileIsBroken) {
  const test::TempFolder folder;
  write_map(folder.path());
  const SurfaceFolder map = SurfaceFolder::open(folder.path());
  test::spill(folder.path() / map.index().tiles.begin()->second.file, "no tile");
  EXPECT_THROW(MapLayer(folder.path(), kOrigin_m, false), FileError);
}

TEST(MapLayer, CanBeEndedWhileItReads) {
  const test::TempFolder folder;
  write_map(folder.path());
  EXPECT_THROW(MapLayer(folder.path(), kOrigin_m, true), Error);
}

}  // namespace
}  // namespace berm
