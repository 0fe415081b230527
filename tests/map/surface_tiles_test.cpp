#include "berm/map/surface_tiles.hpp"

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

/// Keeps tiles as they come.
class MemoryStore final : public SurfaceStore {
 public:
  std::vector<SurfacePoint> load(const TileKey& key) override {
    const auto place = tiles.find(key);
    return place == tiles.end() ? std::vector<SurfacePoint>() : place->second;
  }
  void save(const TileKey& key, std::span<const SurfacePoint> points) override {
    if (points.empty()) {
      tiles.erase(key);
    } else {
      tiles[key].assign(points.begin(), points.end());
    }
  }
  void commit() override { ++commits; }

  [[nodiscard]] std::vector<SurfacePoint> all() const {
    std::vector<SurfacePoint> points;
    for (const auto& [key, tile] : tiles) {
      points.insert(points.end(), tile.begin(), tile.end());
    }
    return points;
  }
  [[nodiscard]] std::size_t count(Label label) const {
    std::size_t found = 0;
    for (const SurfacePoint& point : all()) {
      found += point.label == label ? 1U : 0U;
    }
    return found;
  }

  std::map<TileKey, std::vector<SurfacePoint>> tiles;
  int commits = 0;
};

double uniform_share(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11U) * 0x1p-53;
}

/// What a sensor at `sensor_m` sees by beams to random places of a wall 20 m ahead, unless a thing stands at
/// `thing_m`: a ball of 0.5 m radius.
SurfaceScan scan_of_wall(const Eigen::Vector3d& sensor_m, const std::vector<Eigen::Vector3d>& things_m,
                         std::mt19937_64& random, int beams = 2000) {
  constexpr double kRadius_m = 0.5;
  SurfaceScan scan;
  scan.sensor_m = sensor_m;
  std::vector<Eigen::Vector3d> ends_m;
  for (int i = 0; i < beams; ++i) {
    Eigen::Vector3d end_m =
        sensor_m + Eigen::Vector3d(20.0, 8.0 * (uniform_share(random) - 0.5), 8.0 * (uniform_share(random) - 0.5));
    const Eigen::Vector3d direction = (end_m - sensor_m).normalized();
    for (const Eigen::Vector3d& thing_m : things_m) {
      const double along_m = (thing_m - sensor_m).dot(direction);
      const double aside_m = (thing_m - sensor_m - along_m * direction).norm();
      if (along_m > 0.0 && aside_m < kRadius_m && along_m < (end_m - sensor_m).norm()) {
        end_m = sensor_m + (along_m - std::sqrt(kRadius_m * kRadius_m - aside_m * aside_m)) * direction;
      }
    }
    ends_m.push_back(end_m);
    scan.samples.push_back({end_m, 50.0F, Label::obstacle});
  }
  scan.beams.resize(1);
  scan.beams[0].set(sensor_m, ends_m);
  return scan;
}

bool is_near(const SurfacePoint& point, const Eigen::Vector3d& place_m, double radius_m) {
  return (Eigen::Vector3d(point.x_m, point.y_m, point.z_m) - place_m).norm() < radius_m;
}

std::size_t count_near(const MemoryStore& store, const Eigen::Vector3d& place_m) {
  std::size_t found = 0;
  for (const SurfacePoint& point : store.all()) {
    found += is_near(point, place_m, 0.7) ? 1U : 0U;
  }
  return found;
}

SurfaceMapConfig config() {
  SurfaceMapConfig config;
  config.surface = true;
  return config;
}

TEST(SurfaceTilesTest, AVoxelHoldsMeanCountMajorityAndIntensity) {
  MemoryStore store;
  SurfaceTiles tiles(config(), Eigen::Vector3d::Zero(), store);
  SurfaceScan scan;
  scan.samples = {{{1.01, -2.09, 0.52}, 10.0F, Label::drivable},
                  {{1.03, -2.05, 0.54}, 20.0F, Label::drivable},
                  {{1.05, -2.01, 0.56}, 60.0F, Label::terrain},
                  {{-0.05, 0.05, 0.05}, 5.0F, Label::terrain}};
  tiles.add(scan);
  tiles.finish();
  ASSERT_EQ(store.tiles.size(), 3U - 1U);
  ASSERT_TRUE(store.tiles.contains({0, -1}));
  const SurfacePoint& point = store.tiles[{0, -1}].at(0);
  EXPECT_NEAR(point.x_m, 1.03, 1e-6);
  EXPECT_NEAR(point.y_m, -2.05, 1e-6);
  EXPECT_NEAR(point.z_m, 0.54, 1e-6);
  EXPECT_NEAR(point.intensity, 30.0, 1e-4);
  EXPECT_EQ(point.count, 3U);
  EXPECT_EQ(point.label, Label::drivable);
  EXPECT_EQ(store.commits, 1);
  EXPECT_EQ(tiles.counts().points, 4U);
}

TEST(SurfaceTilesTest, FlakesNoReturnsAndBadPointsAreNoSurface) {
  MemoryStore store;
  SurfaceTiles tiles(config(), Eigen::Vector3d::Zero(), store);
  const double nan = std::nan("");
  SurfaceScan scan;
  scan.samples = {{{1.0, 1.0, 1.0}, 1.0F, Label::falling_snow},
                  {{0.0, 0.0, 0.0}, 0.0F, Label::no_return},
                  {{1.0, 1.0, 1.0}, 1.0F, Label::unlabeled},
                  {{nan, 1.0, 1.0}, 1.0F, Label::obstacle},
                  {{1e300, 1.0, 1.0}, 1.0F, Label::obstacle}};
  tiles.add(scan);
  tiles.finish();
  EXPECT_TRUE(store.tiles.empty());
  EXPECT_EQ(tiles.counts().left_out, 5U);
}

TEST(SurfaceTilesTest, APlaneIsAsSharpAsItsNoiseAllows) {
  constexpr double kNoise_m = 0.02;
  MemoryStore store;
  SurfaceTiles tiles(config(), Eigen::Vector3d::Zero(), store);
  std::mt19937_64 random(3);
  std::normal_distribution<double> noise(0.0, kNoise_m);
  const Eigen::Vector3d normal = Eigen::Vector3d(0.3, -0.2, 1.0).normalized();
  for (int i = 0; i < 50; ++i) {
    SurfaceScan scan;
    for (int k = 0; k < 4000; ++k) {
      const double x_m = 10.0 * uniform_share(random);
      const double y_m = 10.0 * uniform_share(random);
      const Eigen::Vector3d on_plane_m(x_m, y_m, -(normal.x() * x_m + normal.y() * y_m) / normal.z());
      scan.samples.push_back({on_plane_m + noise(random) * normal, 100.0F, Label::drivable});
    }
    tiles.add(scan);
  }
  tiles.finish();
  double squares = 0.0;
  double weight = 0.0;
  for (const SurfacePoint& point : store.all()) {
    const double off_m = normal.dot(Eigen::Vector3d(point.x_m, point.y_m, point.z_m));
    squares += point.count * off_m * off_m;
    weight += point.count;
  }
  EXPECT_LT(std::sqrt(squares / weight), 0.7 * kNoise_m) << "what lies about the faces of voxels is cut in two";
}

TEST(SurfaceTilesTest, AThingThatWentAwayIsTakenOutAndAThingThatStaysIsNot) {
  for (const bool before : {true, false}) {
    MemoryStore store;
    SurfaceTiles tiles(config(), Eigen::Vector3d::Zero(), store);
    std::mt19937_64 random(7);
    const Eigen::Vector3d moved_m(8.0, 1.0, 0.0);
    const Eigen::Vector3d stays_m(10.0, -2.0, 0.0);
    for (int i = 0; i < 80; ++i) {
      const bool is_there = before ? i < 12 : i >= 68;
      std::vector<Eigen::Vector3d> things_m = {stays_m};
      if (is_there) {
        things_m.push_back(moved_m);
      }
      tiles.add(scan_of_wall(Eigen::Vector3d::Zero(), things_m, random));
    }
    tiles.finish();
    EXPECT_EQ(count_near(store, moved_m), 0U) << before;
    EXPECT_GT(count_near(store, stays_m), 20U) << before;
    EXPECT_GT(tiles.counts().moved, 10U) << before;
  }
}

TEST(SurfaceTilesTest, WithoutTheSwitchWhatMovedStays) {
  MemoryStore store;
  SurfaceMapConfig keeping = config();
  keeping.remove_moved = false;
  SurfaceTiles tiles(keeping, Eigen::Vector3d::Zero(), store);
  std::mt19937_64 random(7);
  const Eigen::Vector3d moved_m(8.0, 1.0, 0.0);
  for (int i = 0; i < 60; ++i) {
    std::vector<Eigen::Vector3d> things_m;
    if (i < 10) {
      things_m.push_back(moved_m);
    }
    tiles.add(scan_of_wall(Eigen::Vector3d::Zero(), things_m, random));
  }
  tiles.finish();
  EXPECT_GT(count_near(store, moved_m), 20U);
}

/// A drive of 400 m and back, over ground that is seen 30 m ahead.
void drive(SurfaceTiles& tiles, std::size_t& most_voxels) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 400; ++i) {
    const double x_m = i < 200 ? 2.0 * i : 2.0 * (400 - i);
    SurfaceScan scan;
    scan.sensor_m = {x_m, 0.0, 2.0};
    for (int k = 0; k < 500; ++k) {
      scan.samples.push_back(
          {{x_m + 30.0 * uniform_share(random), 20.0 * (uniform_share(random) - 0.5), 0.0}, 1.0F, Label::drivable});
    }
    tiles.add(scan);
    most_voxels = std::max(most_voxels, tiles.voxels_in_memory());
  }
  tiles.finish();
}

TEST(SurfaceTilesTest, TilesAreGivenAwayAndMergedWhenTheMachineComesBack) {
  MemoryStore streamed;
  SurfaceTiles tiles(config(), Eigen::Vector3d::Zero(), streamed);
  std::size_t most = 0;
  drive(tiles, most);
  EXPECT_GT(tiles.counts().loaded, 10U);
  EXPECT_EQ(tiles.tiles_in_memory(), 0U);

  MemoryStore kept;
  SurfaceMapConfig all = config();
  all.keep_m = 2000.0;
  SurfaceTiles whole(all, Eigen::Vector3d::Zero(), kept);
  std::size_t most_kept = 0;
  drive(whole, most_kept);
  EXPECT_LT(most, most_kept / 2);

  ASSERT_EQ(streamed.tiles.size(), kept.tiles.size());
  for (const auto& [key, points] : kept.tiles) {
    const std::vector<SurfacePoint>& others = streamed.tiles.at(key);
    ASSERT_EQ(points.size(), others.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(points[i].count, others[i].count);
      ASSERT_EQ(points[i].label, others[i].label);
      ASSERT_NEAR(points[i].x_m, others[i].x_m, 2e-4);
      ASSERT_NEAR(points[i].z_m, others[i].z_m, 2e-4);
    }
  }
}

TEST(SurfaceTilesTest, AMapOfTheSamePlaceDoesNotGrow) {
  MemoryStore store;
  SurfaceTiles tiles(config(), Eigen::Vector3d::Zero(), store);
  std::mt19937_64 random(5);
  std::size_t after_some = 0;
  for (int i = 0; i < 600; ++i) {
    tiles.add(scan_of_wall(Eigen::Vector3d::Zero(), {}, random, 500));
    after_some = i == 299 ? tiles.voxels_in_memory() : after_some;
  }
  EXPECT_LE(tiles.voxels_in_memory(), after_some + 5);
  tiles.finish();
  EXPECT_EQ(tiles.counts().moved, 0U);
}

TEST(SurfaceTilesTest, PointsStayInTheirVoxelsWhateverTheyAre) {
  rc::check("what is saved is loaded into the same voxels", [](int where, int seed) {
    MemoryStore store;
    const Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    SurfaceScan scan;
    scan.sensor_m = Eigen::Vector3d::Constant(where % 7000);
    for (int i = 0; i < 50; ++i) {
      const Eigen::Vector3d by_m(uniform_share(random), uniform_share(random), uniform_share(random));
      // Near the faces of voxels, where rounding decides.
      const Eigen::Vector3d snapped_m = (by_m * 10.0).array().round() / 10.0;
      scan.samples.push_back({scan.sensor_m + (i % 2 == 0 ? by_m : snapped_m), 1.0F, Label::terrain});
    }
    SurfaceTiles first(config(), origin_m, store);
    first.add(scan);
    first.finish();
    const std::vector<SurfacePoint> before = store.all();
    SurfaceTiles second(config(), origin_m, store);
    second.add(scan);
    second.finish();
    const std::vector<SurfacePoint> after = store.all();
    RC_ASSERT(before.size() == after.size());
    for (std::size_t i = 0; i < before.size(); ++i) {
      RC_ASSERT(after[i].count == 2 * before[i].count);
    }
  });
}

TEST(SurfaceTilesTest, SettingsThatContradictEachOtherAreRefused) {
  MemoryStore store;
  SurfaceMapConfig near = config();
  near.keep_m = near.max_range_m;
  EXPECT_THROW(SurfaceTiles(near, Eigen::Vector3d::Zero(), store), ConfigError);
  SurfaceMapConfig fine = config();
  fine.cell_m = 0.5 * fine.voxel_m;
  EXPECT_THROW(fine.check(), ConfigError);
  EXPECT_NO_THROW(config().check());
}

}  // namespace
}  // namespace berm
