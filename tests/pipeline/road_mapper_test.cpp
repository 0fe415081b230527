#include "road_mapper.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "scan_motion.hpp"

namespace berm {
namespace {

constexpr Stamp kSecond_ns = 1'000'000'000;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A machine that pitches, rolls and turns by up to 0.6 rad/s while it drives a bend, far from the origin.
Trajectory wild_drive(Stamp start_ns) {
  Trajectory drive;
  for (int i = 0; i <= 40; ++i) {
    const double t = 0.05 * i;
    drive.append(start_ns + i * kSecond_ns / 20,
                 Pose::from_yaw_pitch_roll(0.6 * t, 0.05 * std::sin(7.0 * t), 0.1 * std::sin(5.0 * t),
                                           {5e5 + 8.0 * t, 5e6 + 3.0 * std::sin(t), 200.0 + 0.2 * t}));
  }
  return drive;
}

const Pose kMount = Pose::from_yaw_pitch_roll(0.2, 0.3, 0.0, {1.0, 0.5, 4.0});

TEST(ScanMotion, IsThatOfTheTrajectory) {
  const Stamp start_ns = 1'700'000'000 * kSecond_ns + 123'456'789;
  const Trajectory drive = wild_drive(start_ns);
  ScanMotion motion;
  const Stamp first_ns = start_ns + 333'333'333;
  ASSERT_TRUE(motion.set(drive, kMount, first_ns, first_ns + kSecond_ns / 10));
  const Eigen::Vector3d point_m(30.0, -25.0, -3.0);
  double worst_m = 0.0;
  for (Stamp since_ns = 0; since_ns <= kSecond_ns / 10; since_ns += 170'711) {
    const Eigen::Vector3d expected_m = drive.at(first_ns + since_ns).value() * (kMount * point_m);
    worst_m = std::max(worst_m, (motion.to_world_m(point_m, to_seconds(since_ns)) - expected_m).norm());
  }
  EXPECT_LT(worst_m, 1e-3);
}

TEST(ScanMotion, HoldsOnePoseWhereThereIsNoTime) {
  const Trajectory drive = wild_drive(0);
  ScanMotion motion;
  ASSERT_TRUE(motion.set(drive, kMount, kSecond_ns, kSecond_ns));
  const Eigen::Vector3d point_m(3.0, 4.0, 5.0);
  const Eigen::Vector3d expected_m = drive.at(kSecond_ns).value() * (kMount * point_m);
  for (const double since_s : {0.0, -1.0, 1.0}) {
    EXPECT_LT((motion.to_world_m(point_m, since_s) - expected_m).norm(), 1e-8);
  }
}

TEST(ScanMotion, NeedsPosesForAllOfIt) {
  const Trajectory drive = wild_drive(0);
  ScanMotion motion;
  EXPECT_FALSE(motion.set(drive, kMount, -1, kSecond_ns));
  EXPECT_FALSE(motion.set(drive, kMount, kSecond_ns, 3 * kSecond_ns));
  EXPECT_FALSE(motion.set(drive, kMount, kSecond_ns, 20 * kSecond_ns));
  EXPECT_FALSE(motion.set(drive, kMount, kSecond_ns, 0));
  EXPECT_FALSE(motion.set(Trajectory(), kMount, 0, 0));
}

/// A scan of which every point is the same place of the world, each seen at its own time.
class RoadMapperTest : public testing::Test {
 protected:
  void SetUp() override {
    poses_.trajectory = wild_drive(0);
    PointChannels channels;
    for (std::uint32_t i = 0; i < 100; ++i) {
      const float time_s = 0.001F * static_cast<float>(i);
      const Pose T_world_sensor = poses_.trajectory.at(kSecond_ns + from_seconds(double{time_s})).value() * kMount;
      const Eigen::Vector3f seen_m = (T_world_sensor.inverse() * place_m_).cast<float>();
      channels.x.push_back(seen_m.x());
      channels.y.push_back(seen_m.y());
      channels.z.push_back(seen_m.z());
      channels.time.push_back(time_s);
      edges_.push_back({.x_m = seen_m.x(), .y_m = seen_m.y(), .z_m = seen_m.z(), .time_s = time_s, .height_m = 1.5F});
      plain_.push_back(i);
    }
    edges_[3].side = EdgeSide::right;
    scan_ = {.stamp_ns = kSecond_ns, .cloud = PointCloud(std::move(channels)), .T_base_sensor = kMount};
  }

  [[nodiscard]] RoadMapper mapper() const { return {machine_, poses_, EdgeMap(machine_.map), 0, 2 * kSecond_ns}; }

  Eigen::Vector3d place_m_{5e5 + 30.0, 5e6 + 12.0, 198.0};
  Machine machine_;
  RunPoses poses_;
  std::vector<EdgePoint> edges_;
  std::vector<std::uint32_t> plain_;
  std::vector<Label> labels_ = std::vector<Label>(100, Label::obstacle);
  Scan scan_;
  PlacedScan placed_;
};

TEST_F(RoadMapperTest, EveryPointGoesToTheWorldWithThePoseAtItsTime) {
  mapper().place(scan_, labels_, {edges_, plain_}, placed_);
  ASSERT_EQ(placed_.trust, PoseTrust::trusted);
  ASSERT_EQ(placed_.edges.size(), edges_.size());
  ASSERT_EQ(placed_.plain_m.size(), plain_.size());
  for (std::size_t i = 0; i < edges_.size(); ++i) {
    EXPECT_LT((placed_.edges[i].position_m - place_m_).norm(), 1e-3);
    EXPECT_LT((placed_.surveyed[i].position_m - place_m_).norm(), 1e-3);
    EXPECT_LT((placed_.plain_m[i] - place_m_).norm(), 1e-3);
    EXPECT_EQ(placed_.surveyed[i].height_m, 1.5F);
    EXPECT_EQ(placed_.edges[i].side, i == 3 ? EdgeSide::right : EdgeSide::left);
  }
}

TEST_F(RoadMapperTest, WhatIsSolidAndNoPlainRoadIsForTheBerms) {
  plain_.resize(40);
  labels_[50] = Label::falling_snow;
  labels_[51] = Label::no_return;
  labels_[52] = Label::unlabeled;
  mapper().place(scan_, labels_, {edges_, plain_}, placed_);
  ASSERT_EQ(placed_.plain_m.size(), 40U);
  ASSERT_EQ(placed_.raised_m.size(), 57U);
  for (const Eigen::Vector3d& raised_m : placed_.raised_m) {
    EXPECT_LT((raised_m - place_m_).norm(), 1e-3);
  }
}

TEST_F(RoadMapperTest, WhatHasNoTimeIsLeftOut) {
  PointChannels channels = std::move(scan_.cloud).release();
  channels.time[7] = kNaN;
  channels.time[8] = std::numeric_limits<float>::infinity();
  scan_.cloud = PointCloud(std::move(channels));
  edges_[2].time_s = kNaN;
  RoadMapper mapper = this->mapper();
  mapper.place(scan_, labels_, {edges_, plain_}, placed_);
  EXPECT_EQ(placed_.left_out, 3U);
  EXPECT_EQ(placed_.plain_m.size(), 98U);
  mapper.add(placed_);
  EXPECT_EQ(mapper.counts().left_out, 3U);
  EXPECT_EQ(mapper.counts().mapped, 1U);
  EXPECT_GT(mapper.map().size(), 0U);
}

TEST_F(RoadMapperTest, AScanIsTrustedFromItsFirstPointToItsLast) {
  RoadMapper mapper = this->mapper();
  const auto trust_at = [&](Stamp stamp_ns) {
    scan_.stamp_ns = stamp_ns;
    mapper.place(scan_, labels_, {edges_, plain_}, placed_);
    mapper.add(placed_);
    return placed_.trust;
  };
  EXPECT_EQ(trust_at(2 * kSecond_ns - 100'000'000), PoseTrust::trusted);
  EXPECT_EQ(trust_at(2 * kSecond_ns - 98'000'000), PoseTrust::no_pose);
  EXPECT_TRUE(placed_.edges.empty());
  EXPECT_EQ(trust_at(-1), PoseTrust::no_pose);
  EXPECT_EQ(trust_at(std::numeric_limits<Stamp>::max()), PoseTrust::no_pose);
  EXPECT_EQ(mapper.counts().not_mapped[static_cast<std::size_t>(PoseTrust::no_pose)], 3U);
  EXPECT_EQ(mapper.counts().mapped, 1U);
}

}  // namespace
}  // namespace berm
