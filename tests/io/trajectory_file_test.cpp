#include "berm/io/trajectory_file.hpp"

#include <cmath>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/data.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::expect_file_error;

Trajectory parse_tum(const std::string& text) {
  std::istringstream input(text);
  return read_tum(input, "path.tum");
}

void expect_no_tum(const std::string& text, const std::string& part) {
  SCOPED_TRACE(text);
  expect_file_error(ErrorCode::malformed, part, [&] { (void)parse_tum(text); });
}

double uniform(double low, double high) {
  const int steps = *rc::gen::inRange(0, 1'000'001);
  return low + (high - low) * steps / 1e6;
}

Trajectory any_trajectory() {
  Trajectory trajectory;
  Stamp stamp_ns = *rc::gen::inRange<Stamp>(-1'000'000'000, 2'000'000'000'000'000'000);
  const int count = *rc::gen::inRange(0, 8);
  for (int i = 0; i < count; ++i) {
    const Pose pose = Pose::from_yaw_pitch_roll(uniform(-3.2, 3.2), uniform(-1.6, 1.6), uniform(-3.2, 3.2),
                                                {uniform(-1e6, 1e6), uniform(-1, 1), uniform(-1e-6, 1e-6)});
    trajectory.append(stamp_ns, pose);
    stamp_ns += *rc::gen::inRange<Stamp>(1, 1'000'000'000);
  }
  return trajectory;
}

TEST(TumFile, SurvivesARoundTrip) {
  const test::TempFolder folder;
  EXPECT_TRUE(rc::check("stamps exactly, poses to the printed digits", [&] {
    const Trajectory written = any_trajectory();
    write_tum(folder / "path.tum", written);
    const Trajectory read = read_tum(folder / "path.tum");
    RC_ASSERT(read.size() == written.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      RC_ASSERT(read.poses()[i].stamp_ns == written.poses()[i].stamp_ns);
      const Pose error = read.poses()[i].T_world_base.inverse() * written.poses()[i].T_world_base;
      RC_ASSERT(error.translation_m().norm() < 1e-6);
      RC_ASSERT(error.log().tail<3>().norm() < 1e-8);
    }
  }));
}

TEST(TumFile, WritesTheSameBytesForTheSameRotation) {
  const test::TempFolder folder;
  for (const double sign : {1.0, -1.0}) {
    Trajectory trajectory;
    trajectory.append(1'635'236'489'369'081'856,
                      Pose(Eigen::Quaterniond(sign * 0.6, 0.0, sign * -0.8, 0.0), {-1e-9, 2.5, -3}));
    write_tum(folder / "path.tum", trajectory);
    EXPECT_EQ(test::slurp(folder / "path.tum"),
              "1635236489.369081856 0.000000 2.500000 -3.000000 0.000000000 -0.800000000 0.000000000 0.600000000\n");
  }
}

TEST(TumFile, WritesAnEmptyFileForNoPoses) {
  const test::TempFolder folder;
  write_tum(folder / "path.tum", {});
  EXPECT_EQ(test::slurp(folder / "path.tum"), "");
  EXPECT_TRUE(read_tum(folder / "path.tum").empty());
}

TEST(TumFile, SkipsCommentsAndAcceptsCrlfAndTabs) {
  const Trajectory trajectory = parse_tum("# t x y z qx qy qz qw\r\n1 1 2 3 0 0 0 1\r\n\r\n2\t4 5  6 0 0 0 1");
  ASSERT_EQ(trajectory.size(), 2U);
  EXPECT_EQ(trajectory.poses()[1].T_world_base.translation_m(), Eigen::Vector3d(4, 5, 6));
}

TEST(TumFile, NormalisesAQuaternionThatIsNearlyOne) {
  const Trajectory trajectory = parse_tum("1 0 0 0 0 0 0.6 0.805\n");
  EXPECT_NEAR(trajectory.poses()[0].T_world_base.rotation().norm(), 1.0, 1e-15);
}

TEST(TumFile, RefusesBrokenLinesByNumber) {
  const std::string good = "1 0 0 0 0 0 0 1\n";
  expect_no_tum(good + "2 0 0 0 0 0 1\n", "path.tum: line 2: only 6 numbers, expected 7");
  expect_no_tum(good + "2 0 0 0 0 0 0 1 9\n", "line 2: '9' follows the last number");
  expect_no_tum(good + "2 0 0 x 0 0 0 1\n", "line 2: 'x' in column 3 is no finite number");
  expect_no_tum(good + "2 0 0 nan 0 0 0 1\n", "no finite number");
  expect_no_tum(good + "2 0 0 1e999 0 0 0 1\n", "no finite number");
  expect_no_tum(good + "2 0 0 2e9 0 0 0 1\n", "beyond +-1e9 m");
  expect_no_tum(good + "2 0 0 0 0 0 0 0\n", "norm 0.000000, expected 1");
  expect_no_tum(good + "2 0 0 0 0 0 0 1.02\n", "norm 1.02");
  expect_no_tum(good + "2 0 0 0 1e300 0 0 1\n", "norm inf");
  expect_no_tum(good + "1 0 0 0 0 0 0 1\n", "line 2: the stamp is not later");
  expect_no_tum("one 0 0 0 0 0 0 1\n", "line 1: expected a stamp in seconds, found 'one'");
}

TEST(TumFile, ReadsARealTrajectory) {
  BERM_NEED_DATA(path, "kitti00/poses_consensus.tum");
  const Trajectory trajectory = read_tum(path);
  ASSERT_EQ(trajectory.size(), 16U);
  EXPECT_EQ(trajectory.poses()[1].stamp_ns, 103'700'000);
  EXPECT_NEAR(trajectory.poses()[1].T_world_base.translation_m().x(), 0.689711, 1e-9);
}

TEST(KittiPoses, SurviveARoundTrip) {
  const test::TempFolder folder;
  EXPECT_TRUE(rc::check("poses to the printed digits", [&] {
    const Trajectory trajectory = any_trajectory();
    std::vector<Pose> written;
    for (const StampedPose& pose : trajectory.poses()) {
      written.push_back(pose.T_world_base);
    }
    write_kitti_poses(folder / "poses.txt", written);
    const std::vector<Pose> read = read_kitti_poses(folder / "poses.txt");
    RC_ASSERT(read.size() == written.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      const Pose error = read[i].inverse() * written[i];
      RC_ASSERT(error.translation_m().norm() < 1e-6);
      RC_ASSERT(error.log().tail<3>().norm() < 1e-9);
    }
  }));
}

TEST(KittiPoses, HaveTwelveNumbersALine) {
  const test::TempFolder folder;
  write_kitti_poses(folder / "poses.txt", std::vector<Pose>{Pose(Eigen::Quaterniond::Identity(), {0.5, 0, -2})});
  EXPECT_EQ(test::slurp(folder / "poses.txt"),
            "1.000000000000e+00 0.000000000000e+00 0.000000000000e+00 5.000000000000e-01 "
            "0.000000000000e+00 1.000000000000e+00 0.000000000000e+00 0.000000000000e+00 "
            "0.000000000000e+00 0.000000000000e+00 1.000000000000e+00 -2.000000000000e+00\n");
}

TEST(KittiPoses, RefuseWhatIsNoRigidMotion) {
  const auto expect_refused_pose = [](const std::string& line, const std::string& part) {
    SCOPED_TRACE(line);
    std::istringstream input("1 0 0 0 0 1 0 0 0 0 1 0\n" + line);
    expect_file_error(ErrorCode::malformed, part, [&] { (void)read_kitti_poses(input, "poses.txt"); });
  };
  expect_refused_pose("1 0 0 0 0 1 0 0 0 0 1\n", "poses.txt: line 2: only 11 numbers");
  expect_refused_pose("2 0 0 0 0 1 0 0 0 0 1 0\n", "line 2: the left 3x3 block is no rotation");
  expect_refused_pose("1 0 0 0 0 1 0 0 0 0 -1 0\n", "no rotation");
  expect_refused_pose("0 0 0 0 0 0 0 0 0 0 0 0\n", "no rotation");
  expect_refused_pose("1e200 0 0 0 0 1e200 0 0 0 0 1e200 0\n", "no rotation");
  expect_refused_pose("1 0 0 1e10 0 1 0 0 0 0 1 0\n", "beyond");
}

TEST(KittiCalibration, IsFoundAmongOtherLines) {
  std::istringstream odometry("P0: 7 0 6 0 0 7 1 0 0 0 1 0\nTr: 0 -1 0 0.1 0 0 -1 0.2 1 0 0 0.3\n");
  const Pose T_camera_lidar = read_kitti_calibration(odometry, "calib.txt");
  EXPECT_TRUE((T_camera_lidar * Eigen::Vector3d(1, 2, 3)).isApprox(Eigen::Vector3d(-1.9, -2.8, 1.3)));
  std::istringstream object("R0_rect: 1 0 0 0 1 0 0 0 1\nTr_velo_to_cam: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_NO_THROW((void)read_kitti_calibration(object, "calib.txt"));
}

TEST(KittiCalibration, RefusesNoneAndTwo) {
  std::istringstream none("P0: 7 0 6 0 0 7 1 0 0 0 1 0\n");
  expect_file_error(ErrorCode::malformed, "no line 'Tr:'", [&] { (void)read_kitti_calibration(none, "calib.txt"); });
  std::istringstream two("Tr: 1 0 0 0 0 1 0 0 0 0 1 0\nTr: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  expect_file_error(ErrorCode::malformed, "line 2: a second line",
                    [&] { (void)read_kitti_calibration(two, "calib.txt"); });
}

}  // namespace
}  // namespace berm
