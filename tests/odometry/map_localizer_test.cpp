#include "berm/odometry/map_localizer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/core/stamp.hpp"
#include "berm/geometry/voxel_hash.hpp"
#include "map_tiles.hpp"
#include "odometry/made_drive.hpp"

namespace berm {
namespace {

using test::made_yard;
using test::straight;

constexpr double kTile_m = 20.0;
constexpr double kScan_s = 0.1;

/// A map of what scans of a drive see, one point a voxel of 0.1 m, made with their true poses.
class MadeMap final : public MapTileSource {
 public:
  MadeMap(const test::MadePlace& place, const test::MadeMotion& motion, std::size_t scans) {
    VoxelHash<std::uint32_t> met(0.1);
    for (std::size_t i = 0; i < scans; ++i) {
      const test::MadeScan scan(place, motion, kScan_s * static_cast<double>(i));
      const OdometryInput input = scan.input();
      for (std::size_t k = 0; k < input.points.size(); ++k) {
        const Eigen::Vector3d sensor_m(input.points.x[k], input.points.y[k], input.points.z[k]);
        const double time_s = kScan_s * static_cast<double>(i) + static_cast<double>(input.points.time[k]);
        const Eigen::Vector3d map_m = motion(time_s) * (input.T_base_sensor * sensor_m);
        if (input.labels[k] == Label::no_return || sensor_m.norm() > 50.0 || ++met.at_or_new(*met.key_of(map_m)) > 1) {
          continue;
        }
        const TileKey key{static_cast<std::int32_t>(std::floor(map_m.x() / kTile_m)),
                          static_cast<std::int32_t>(std::floor(map_m.y() / kTile_m))};
        SurfacePoint& point = tiles_[key].emplace_back();
        point.x_m = static_cast<float>(map_m.x());
        point.y_m = static_cast<float>(map_m.y());
        point.z_m = static_cast<float>(map_m.z());
        point.label = input.labels[k];
        point.count = 1;
      }
    }
  }

  [[nodiscard]] double tile_m() const override { return kTile_m; }
  [[nodiscard]] Eigen::Vector3d origin_m() const override { return Eigen::Vector3d::Zero(); }
  [[nodiscard]] bool has(const TileKey& key) const override { return tiles_.contains(key); }
  [[nodiscard]] std::vector<SurfacePoint> load(const TileKey& key) override { return tiles_.at(key); }

 private:
  std::map<TileKey, std::vector<SurfacePoint>> tiles_;
};

/// As `made_yard`, with other boxes.
test::MadePlace other_yard() {
  std::mt19937 random(99);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  test::MadePlace place;
  for (double x_m = -30.0; x_m < 100.0; x_m += 3.0 + 6.0 * share(random)) {
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Vector3d half_m(0.2 + 2.0 * share(random), 0.2 + share(random), 1.0 + 2.0 * share(random));
      const Eigen::Vector3d middle_m(x_m, side * (5.0 + 9.0 * share(random)), half_m.z());
      place.boxes.push_back({middle_m - half_m, middle_m + half_m});
    }
  }
  return place;
}

/// What an odometry says that knows the motion, from its own start on.
OdometryResult known(const test::MadeMotion& motion, double begin_s, OdometryHealth health = OdometryHealth::good) {
  OdometryResult result;
  const Pose T_odom_map = motion(0.0).inverse();
  result.T_world_begin = T_odom_map * motion(begin_s);
  result.T_world_end = T_odom_map * motion(begin_s + kScan_s);
  result.duration_s = kScan_s;
  result.health = health;
  return result;
}

/// The map of the yard, made once.
MadeMap& yard_map() {
  static MadeMap map(made_yard(), straight(4.0), 80);
  return map;
}

struct Drive {
  std::vector<MapPose> poses;
  std::size_t located = 0;
  double worst_m = 0.0;  ///< of those that were located
};

Drive drive(MapLocalizer& localizer, const test::MadePlace& place, const test::MadeMotion& motion, std::size_t scans,
            OdometryHealth health = OdometryHealth::good) {
  Drive result;
  for (std::size_t i = 0; i < scans; ++i) {
    const double begin_s = kScan_s * static_cast<double>(i);
    const test::MadeScan scan(place, motion, begin_s);
    const MapPose pose = localizer.process(scan.input(), known(motion, begin_s, health));
    if (pose.health == OdometryHealth::good || pose.health == OdometryHealth::weak) {
      ++result.located;
      const double error_m = (pose.T_map_begin.translation_m() - motion(begin_s).translation_m()).norm();
      result.worst_m = std::max(result.worst_m, error_m);
    }
    result.poses.push_back(pose);
  }
  return result;
}

Pose rough(double x_m, double y_m, double yaw_deg) {
  return Pose::from_yaw_pitch_roll(yaw_deg * std::numbers::pi / 180.0, 0.0, 0.0, {x_m, y_m, 7.0});
}

TEST(MapLocalizer, FindsTheMachineAroundARoughStartAndStaysWithIt) {
  for (const Pose& start : {rough(0.0, 0.0, 0.0), rough(1.4, -1.2, 8.0), rough(-1.0, 1.6, -9.0)}) {
    MapLocalizer localizer({}, {}, yard_map());
    ASSERT_TRUE(localizer.start(start));
    const Drive result = drive(localizer, made_yard(), straight(1.5), 40);
    EXPECT_GT(result.located, 15U) << start.translation_m().transpose();
    EXPECT_LT(result.worst_m, 0.1) << start.translation_m().transpose();
    EXPECT_EQ(result.poses.back().health, OdometryHealth::good);
  }
}

TEST(MapLocalizer, NeedsNoOdometryWhileThatLooksForItsSpeed) {
  MapLocalizer localizer({}, {}, yard_map());
  ASSERT_TRUE(localizer.start(rough(0.5, 0.5, 3.0)));
  const Drive result = drive(localizer, made_yard(), straight(1.5), 40, OdometryHealth::starting);
  EXPECT_GT(result.located, 10U);
  EXPECT_LT(result.worst_m, 0.1);
}

TEST(MapLocalizer, AnotherPlaceIsNeverTakenForTheOneOfTheMap) {
  MapLocalizer localizer({}, {}, yard_map());
  ASSERT_TRUE(localizer.start(Pose()));
  const Drive result = drive(localizer, other_yard(), straight(1.5), 60);
  EXPECT_EQ(result.located, 0U);
}

TEST(MapLocalizer, SaysThatItIsLostOutsideOfTheMapAndComesBack) {
  // The map ends some 60 m ahead of x = 0; the drive goes on to x = 120, comes back to x = 5 and stands.
  MadeMap map(made_yard(), straight(4.0), 25);
  const test::MadeMotion there_and_back = [](double time_s) {
    const double x_m = time_s < 10.0 ? 12.0 * time_s : std::max(5.0, 120.0 - 12.0 * (time_s - 10.0));
    return Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {x_m, 0.0, 0.0});
  };
  MapLocalizer localizer({}, {}, map);
  ASSERT_TRUE(localizer.start(rough(0.5, 0.0, 0.0)));
  const Drive result = drive(localizer, made_yard(), there_and_back, 250);
  EXPECT_EQ(result.poses[100].health, OdometryHealth::lost) << "at x = 120";
  EXPECT_EQ(result.poses[249].health, OdometryHealth::good) << "at x = 5";
  EXPECT_LT(result.worst_m, 0.3);
}

TEST(MapLocalizer, GoesOnWithTheOdometryOverScansThatSayNothing) {
  MapLocalizer localizer({}, {}, yard_map());
  ASSERT_TRUE(localizer.start(Pose()));
  const auto motion = straight(1.5);
  const test::MadePlace nothing{.boxes = {}, .has_ground = false};
  ASSERT_EQ(drive(localizer, made_yard(), motion, 40).poses.back().health, OdometryHealth::good);
  for (std::size_t i = 40; i < 60; ++i) {
    const double begin_s = kScan_s * static_cast<double>(i);
    const bool is_blind = i >= 43 && i < 46;
    const test::MadeScan scan(is_blind ? nothing : made_yard(), motion, begin_s);
    const MapPose pose = localizer.process(scan.input(), known(motion, begin_s));
    EXPECT_EQ(pose.health, is_blind ? OdometryHealth::lost : OdometryHealth::good) << "scan " << i;
    EXPECT_LT((pose.T_map_begin.translation_m() - motion(begin_s).translation_m()).norm(), 0.1) << "scan " << i;
  }
}

TEST(MapLocalizer, ThereIsNoStartWhereTheMapHasNoGround) {
  MapLocalizer localizer({}, {}, yard_map());
  EXPECT_FALSE(localizer.start(rough(5000.0, 0.0, 0.0)));
  EXPECT_FALSE(localizer.start(rough(1e12, -1e12, 0.0)));
  EXPECT_TRUE(localizer.start(rough(5.0, 0.0, 0.0)));
}

TEST(MapLocalizer, SameScansSamePoses) {
  MapLocalizer one({}, {}, yard_map());
  MapLocalizer other({}, {}, yard_map());
  ASSERT_TRUE(one.start(rough(1.0, 0.0, 5.0)) && other.start(rough(1.0, 0.0, 5.0)));
  const Drive a = drive(one, made_yard(), straight(1.5), 25);
  const Drive b = drive(other, made_yard(), straight(1.5), 25);
  for (std::size_t i = 0; i < a.poses.size(); ++i) {
    EXPECT_EQ(a.poses[i].T_map_end.matrix(), b.poses[i].T_map_end.matrix()) << "scan " << i;
    EXPECT_EQ(a.poses[i].ground_fit, b.poses[i].ground_fit) << "scan " << i;
  }
}

TEST(MapLocalizer, RefusesLabelsOfAnotherScan) {
  MapLocalizer localizer({}, {}, yard_map());
  const test::MadeScan scan(made_yard(), straight(1.0), 0.0);
  OdometryInput input = scan.input();
  input.labels = input.labels.first(3);
  EXPECT_THROW(static_cast<void>(localizer.process(input, {})), Error);
  EXPECT_THROW(MapLocalizer({.least_ground_fit = 2.0}, {}, yard_map()), Error);
}

TEST(MapTiles, HoldsWhatIsNearAndNoMore) {
  MapTiles tiles({}, 30.0, yard_map());
  std::size_t most = 0;
  for (double x_m = 0.0; x_m < 60.0; x_m += 1.0) {
    tiles.follow({x_m, 0.0, 0.0});
    most = std::max(most, tiles.size());
    EXPECT_TRUE(tiles.ground_at({x_m, 0.0}).has_value()) << x_m;
  }
  EXPECT_LE(most, 30U);  // tiles of 20 m within 45 m
  tiles.follow({4000.0, 0.0, 0.0});
  EXPECT_EQ(tiles.size(), 0U);
}

TEST(MapTiles, AnswersAsBeforeWhenTheMachineComesBack) {
  MapTiles tiles({}, 30.0, yard_map());
  const auto look = [&tiles] {
    std::vector<double> heights_m;
    for (double x_m = 0.0; x_m < 12.0; x_m += 0.5) {
      const SurfaceHit hit = tiles.find({x_m, 2.0, 0.0}, true);
      heights_m.push_back(hit.cell == nullptr ? -9.0 : hit.mean_m.z());
    }
    return heights_m;
  };
  tiles.follow({5.0, 0.0, 0.0});
  const auto before = look();
  EXPECT_GT(*std::max_element(before.begin(), before.end()), -1.0);
  tiles.follow({4000.0, 0.0, 0.0});
  EXPECT_EQ(look(), std::vector<double>(before.size(), -9.0));
  tiles.follow({5.0, 0.0, 0.0});
  EXPECT_EQ(look(), before);
}

TEST(MapTiles, TellsHeightAndSlopeOfTheGround) {
  MapTiles tiles({}, 60.0, yard_map());
  tiles.follow({5.0, 0.0, 0.0});
  const auto ground = tiles.ground_at({5.0, 0.0});
  ASSERT_TRUE(ground.has_value());
  EXPECT_NEAR(ground->height_m, 0.0, 0.03);
  EXPECT_GT(ground->normal.z(), 0.999);
}

}  // namespace
}  // namespace berm
