#include "berm/io/surface_folder.hpp"

#include <chrono>
#include <csignal>
#include <cstring>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "berm/core/error.hpp"
#include "berm/io/pcd.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

std::vector<SurfacePoint> made_points(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<SurfacePoint> points(count);
  const auto number = [&random] { return static_cast<float>(random() % 100'000U) * 1e-3F; };
  for (SurfacePoint& point : points) {
    point = {.x_m = number(),
             .y_m = -number(),
             .z_m = number(),
             .intensity = 12.5F,
             .label = random() % 2U == 0 ? Label::drivable : Label::obstacle,
             .count = static_cast<std::uint32_t>(random()),
             .drivable = static_cast<std::uint16_t>(random()),
             .terrain = 1,
             .obstacle = 2,
             .hits = 3,
             .passes = 65535};
  }
  return points;
}

SurfaceFrame frame() {
  return {0.1, 20.0, {1000.0, -2000.0, 0.0}};
}

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

class SurfaceFolderTest : public ::testing::Test {
 protected:
  test::TempFolder folder_;
};

TEST_F(SurfaceFolderTest, WhatIsSavedIsReadBack) {
  SurfaceFolder map(folder_.path(), frame());
  const auto a = made_points(5000, 1);
  const auto b = made_points(1, 2);
  map.save({0, -1}, a);
  map.save({-3, 12}, b);
  map.commit();
  EXPECT_EQ(map.points(), 5001U);
  const SurfaceFolder read = SurfaceFolder::open(folder_.path());
  EXPECT_EQ(read.index().frame.origin_m, frame().origin_m);
  EXPECT_EQ(read.index().frame.voxel_m, 0.1);
  EXPECT_EQ(read.index().tiles.size(), 2U);
  EXPECT_EQ(read.load({0, -1}), a);
  EXPECT_EQ(read.load({-3, 12}), b);
  EXPECT_TRUE(read.load({5, 5}).empty());
}

TEST_F(SurfaceFolderTest, ATileSavedAgainReplacesTheOldOneAfterTheIndex) {
  SurfaceFolder map(folder_.path(), frame());
  map.save({0, 0}, made_points(10, 1));
  map.commit();
  map.save({0, 0}, made_points(20, 2));
  EXPECT_EQ(SurfaceFolder::open(folder_.path()).load({0, 0}).size(), 10U) << "until the index names the new one";
  EXPECT_EQ(map.load({0, 0}).size(), 20U);
  map.commit();
  EXPECT_EQ(SurfaceFolder::open(folder_.path()).load({0, 0}).size(), 20U);
  EXPECT_EQ(folder_.names().size(), 2U);
  map.save({0, 0}, {});
  map.commit();
  EXPECT_TRUE(SurfaceFolder::open(folder_.path()).index().tiles.empty());
  EXPECT_EQ(folder_.names().size(), 1U);
}

TEST_F(SurfaceFolderTest, OtherProgramsReadTilesAndTheCloud) {
  SurfaceFolder map(folder_.path(), frame());
  const auto a = made_points(3000, 1);
  const auto b = made_points(4500, 2);
  map.save({0, 0}, a);
  map.save({1, 0}, b);
  map.commit();
  write_surface_cloud(folder_ / "map.pcd", map);
  const PointCloud cloud(read_pcd(folder_ / "map.pcd").channels);
  ASSERT_EQ(cloud.size(), 7500U);
  EXPECT_EQ(cloud.view().x[0], a[0].x_m);
  EXPECT_EQ(cloud.view().z[3000], b[0].z_m);
  EXPECT_EQ(cloud.view().intensity[10], 12.5F);
  EXPECT_EQ(cloud.view().label[7], a[7].label);
  EXPECT_EQ(read_pcd(folder_ / map.index().tiles.at({0, 0}).file).channels.x.size(), 3000U);
}

TEST_F(SurfaceFolderTest, BrokenTilesAreRefused) {
  SurfaceFolder map(folder_.path(), frame());
  map.save({0, 0}, made_points(3, 1));
  const std::string tile = test::slurp(folder_ / map.index().tiles.at({0, 0}).file);
  EXPECT_EQ(parse_surface_tile(bytes_of(tile), "tile").size(), 3U);
  for (std::size_t size = 0; size < tile.size(); ++size) {
    EXPECT_THROW(static_cast<void>(parse_surface_tile(bytes_of(tile.substr(0, size)), "tile")), FileError) << size;
  }
  EXPECT_THROW(static_cast<void>(parse_surface_tile(bytes_of(tile + "x"), "tile")), FileError);
  for (const auto& [what, by] : {std::pair<std::string, std::string>{"POINTS 3", "POINTS 4000000000"},
                                 {"POINTS 3", "POINTS -3"},
                                 {"WIDTH 3", "WIDTH 2"},
                                 {"FIELDS x", "FIELDS w"}}) {
    std::string broken = tile;
    broken.replace(broken.find(what), what.size(), by);
    EXPECT_THROW(static_cast<void>(parse_surface_tile(bytes_of(broken), "tile")), FileError) << by;
  }
  std::string label = tile;
  const std::uint32_t unknown = 10;
  std::memcpy(label.data() + label.find("binary\n") + 7 + 16, &unknown, 4);
  EXPECT_THROW(static_cast<void>(parse_surface_tile(bytes_of(label), "tile")), FileError);
}

TEST_F(SurfaceFolderTest, BrokenIndicesAreRefused) {
  SurfaceFolder map(folder_.path(), frame());
  map.save({0, 0}, made_points(3, 1));
  map.commit();
  const std::string text = test::slurp(folder_ / SurfaceFolder::kIndex);
  EXPECT_EQ(parse_surface_index(text, "tiles.json").tiles.size(), 1U);
  for (const auto& [what, by] : {std::pair<std::string, std::string>{"berm.surface/1", "berm.surface/9"},
                                 {"0_0.1.pcd", "../0_0.1.pcd"},
                                 {"0_0.1.pcd", ""},
                                 {"\"points\": 3", "\"points\": -3"},
                                 {"\"x\": 0", "\"x\": 1e300"},
                                 {"\"x\": 0", "\"y\": 0"},
                                 {"0.1,", "0,"},
                                 {"-2000.0", "\"-2000.0\""},
                                 {"\"tiles\"", "\"files\""}}) {
    std::string broken = text;
    ASSERT_NE(broken.find(what), std::string::npos) << what;
    broken.replace(broken.find(what), what.size(), by);
    EXPECT_THROW(static_cast<void>(parse_surface_index(broken, "tiles.json")), FileError) << what << " -> " << by;
  }
  for (std::size_t size = 0; size + 1 < text.size(); size += 3) {
    EXPECT_THROW(static_cast<void>(parse_surface_index(text.substr(0, size), "tiles.json")), FileError) << size;
  }
  fs::remove(folder_ / "0_0.1.pcd");
  EXPECT_THROW(static_cast<void>(SurfaceFolder::open(folder_.path()).load({0, 0})), FileError);
}

/// Writes tiles for ever, each state of the map with the same number of points in all of its tiles.
[[noreturn]] void write_for_ever(const fs::path& folder) {
  SurfaceFolder map(folder, frame());
  for (std::uint32_t state = 1;; ++state) {
    for (std::int32_t tile = 0; tile < 4; ++tile) {
      map.save({tile, 0}, made_points(200 + state % 50, state));
    }
    map.commit();
  }
}

TEST_F(SurfaceFolderTest, AKillAtAnyMomentLeavesAnIndexOfWholeTiles) {
  std::mt19937 random(17);
  for (int round = 0; round < 20; ++round) {
    const fs::path folder = folder_ / std::to_string(round);
    fs::create_directory(folder);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      try {
        write_for_ever(folder);
      } catch (const std::exception&) {
      }
      ::_exit(1);
    }
    for (int wait = 0; wait < 10'000 && !fs::exists(folder / SurfaceFolder::kIndex); ++wait) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    std::this_thread::sleep_for(std::chrono::microseconds(random() % 150'000U));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ::waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    const SurfaceFolder map = SurfaceFolder::open(folder);
    ASSERT_EQ(map.index().tiles.size(), 4U);
    const std::vector<SurfacePoint> first = map.load({0, 0});
    EXPECT_FALSE(first.empty());
    for (std::int32_t tile = 1; tile < 4; ++tile) {
      EXPECT_EQ(map.load({tile, 0}), first) << "of one state of the map";
    }
  }
}

}  // namespace
}  // namespace berm
