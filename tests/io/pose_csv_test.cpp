#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/io/pose_log.hpp"
#include "support/file_error.hpp"

namespace berm {
namespace {

PoseLog parse_poses(const std::string& text, const PoseLogConfig& config = {}, const DatumConfig& datum = {}) {
  std::istringstream input(text);
  return read_pose_csv(input, "poses.csv", config, {}, datum);
}

void expect_no_poses(const std::string& text, const std::string& part) {
  SCOPED_TRACE(text);
  test::expect_file_error(ErrorCode::malformed, part, [&] { (void)parse_poses(text); });
}

TEST(PoseCsv, UtmCoordinatesAndNanosecondsKeepEveryDigit) {
  const PoseLog log = parse_poses(
      "t_ns,x,y,z,qx,qy,qz,qw\n"
      "1700000000123456789,691607.8125001,5334760.4375002,520.25,0,0,0,1\n"
      "1700000000123456790,691607.8125011,5334760.4375012,520.25,0,0,0.7071067811865476,0.7071067811865476\n");
  ASSERT_EQ(log.trajectory.size(), 2U);
  const StampedPose& pose = log.trajectory.poses()[0];
  EXPECT_EQ(pose.stamp_ns, 1'700'000'000'123'456'789);
  EXPECT_EQ(pose.T_world_base.translation_m(), Eigen::Vector3d(691607.8125001, 5334760.4375002, 520.25));
  const Eigen::Vector3d step_m =
      log.trajectory.poses()[1].T_world_base.translation_m() - pose.T_world_base.translation_m();
  EXPECT_NEAR(step_m.x(), 1e-6, 2e-9);
  EXPECT_FALSE(log.datum);
}

TEST(PoseCsv, AnglesInDegreesRadiansAndFromNorth) {
  for (const char* text : {"t,x,y,z,roll_deg,pitch_deg,yaw_deg\n0.5,1,2,3,0,10,30\n",
                           "roll_rad,pitch_rad,yaw_rad,t,x,y,z\n0,0.17453292519943295,0.5235987755982988,0.5,1,2,3\n",
                           "\xEF\xBB\xBFt, x ,y,z,heading_deg,pitch_deg,roll_deg\r\n0.5, 1 ,2,3,60,10,0\r\n"}) {
    SCOPED_TRACE(text);
    const PoseLog log = parse_poses(text);
    ASSERT_EQ(log.trajectory.size(), 1U);
    const Pose& pose = log.trajectory.poses()[0].T_world_base;
    EXPECT_EQ(pose.translation_m(), Eigen::Vector3d(1, 2, 3));
    const Eigen::Vector3d forward = pose.rotation() * Eigen::Vector3d::UnitX();
    const double ten = 10.0 * std::numbers::pi / 180.0;
    EXPECT_NEAR(forward.z(), -std::sin(ten), 1e-12) << "nose down";
    EXPECT_NEAR(forward.y(), 0.5 * std::cos(ten), 1e-12);
    EXPECT_TRUE(log.notes.empty());
  }
}

TEST(PoseCsv, GeographicPositionsMakeALocalWorld) {
  const PoseLog log = parse_poses(
      "t,lat_deg,lon_deg,h_m,yaw_deg,satellites\n0,48,11.5,592,0,12\n1,48.001,11.5,593,0,12\n2,48,11.6,592,0,12\n");
  ASSERT_TRUE(log.datum);
  EXPECT_EQ(log.datum->h_m, 592.0);
  const auto& poses = log.trajectory.poses();
  // The meridian's radius at 48 deg and 592.5 m is 6,371,300 m: 111.2 m per 0.001 deg.
  EXPECT_NEAR(poses[1].T_world_base.translation_m().y(), 111.2, 0.05);
  EXPECT_NEAR(poses[1].T_world_base.translation_m().z(), 1.0, 0.01);
  // East at 0.1 deg to the east points 0.1 deg sin(48 deg) to the north of east at the datum, by convergence.
  const Eigen::Vector3d forward = poses[2].T_world_base.rotation() * Eigen::Vector3d::UnitX();
  EXPECT_NEAR(forward.y(), 0.1 * std::numbers::pi / 180.0 * std::sin(48.0 * std::numbers::pi / 180.0), 1e-5);
  ASSERT_EQ(log.notes.size(), 2U);
  EXPECT_NE(log.notes[0].find("'satellites'"), std::string::npos);
  EXPECT_NE(log.notes[1].find("level"), std::string::npos);
}

TEST(PoseCsv, RowsWithoutAFixAreCounted) {
  const PoseLog log = parse_poses(
      "t,x,y,z,qx,qy,qz,qw,quality\n1,0,0,0,0,0,0,1,4\n2,nan,0,0,0,0,0,1,4\n3,0,0,0,NaN,0,0,1,4\n4,,,,,,,,\n"
      "5,0,0,0,0,0,0,1,0\n6,0,0,0,0,0,0,1,1\n7,0,0,0,0,0,-Inf,1,4\n8,0,0,0,0,0,0,1,5\n");
  EXPECT_EQ(log.counts.records, 8U);
  EXPECT_EQ(log.counts.no_fix, 5U);
  EXPECT_EQ(log.counts.poor_fix, 1U);
  EXPECT_EQ(log.trajectory.size(), 2U);
  ASSERT_EQ(log.poor_fix_stamps.size(), 1U);
  EXPECT_EQ(log.poor_fix_stamps[0], from_seconds(6.0));
}

TEST(PoseCsv, RefusesWhatItWouldHaveToGuess) {
  expect_no_poses("", "the file is empty");
  expect_no_poses("x,y,z,yaw_deg\n", "line 1: expected one column of time");
  expect_no_poses("t,t_ns,x,y,z,yaw_deg\n", "one column of time");
  expect_no_poses("t,x,y,yaw_deg\n", "all of x, y, z");
  expect_no_poses("t,yaw_deg\n", "expected the position either");
  expect_no_poses("t,x,y,z,lat_deg,lon_deg,h_m,yaw_deg\n", "expected the position either");
  expect_no_poses("t,x,y,z\n", "attitude in one way");
  expect_no_poses("t,x,y,z,yaw_deg,heading_deg\n", "attitude in one way");
  expect_no_poses("t,x,y,z,yaw_deg,yaw_rad\n", "'yaw_rad' is said twice");
  expect_no_poses("t,x,y,z,qx,qy,qz\n", "all of qx, qy, qz, qw");
  const std::string header = "t,x,y,z,qx,qy,qz,qw\n";
  expect_no_poses(header + "1,2,3\n", "line 2: expected 8 columns");
  expect_no_poses(header + "1,0,0,0,0,0,0,1,\n", "line 2: expected 8 columns");
  expect_no_poses(header + "1,0,0,zero,0,0,0,1\n", "'zero' is no number for column z");
  expect_no_poses(header + "1,0,0,1e10,0,0,0,1\n", "column z is beyond");
  expect_no_poses(header + "1,0,0,0,0,0,0,1\n1,0,0,0,0,0,0,1\n", "line 3: the time is not later");
  expect_no_poses(header + "1,0,0,0,0,0,0,2\n", "line 2: the quaternion has norm 2.0");
  expect_no_poses(header + "1,0,0,0,0,0,0,0\n", "the quaternion has norm 0.0");
  expect_no_poses("t,lat_deg,lon_deg,h_m,yaw_deg\n1,91,0,0,0\n", "column lat_deg is beyond");
  expect_no_poses("t_ns,x,y,z,yaw_deg\n1.5,0,0,0,0\n", "'1.5' is no number for column t_ns");
  expect_no_poses(header, "holds no pose: 0 records");
}

TEST(PoseCsv, ANormThatIsRoundedIsNormalised) {
  const PoseLog log = parse_poses("t,x,y,z,qx,qy,qz,qw\n1,0,0,0,0,0,0,0.995\n");
  EXPECT_DOUBLE_EQ(log.trajectory.poses()[0].T_world_base.rotation().norm(), 1.0);
}

}  // namespace
}  // namespace berm
