#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "berm/core/error.hpp"
#include "support/file_error.hpp"
#include "truck_run.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::TruckDrive;
using testing::HasSubstr;

constexpr Geodetic kMineDatum{-23.4, 119.8, 700.0};

class RunPosesTest : public test::TruckRunTest {};

TEST_F(RunPosesTest, ScansWithoutTrustedPosesAreNotInTheMap) {
  put_poses(poses_where([](Stamp ns) { return ns >= 300'000'000 && ns <= 800'000'000; }));
  static_cast<void>(run_it());
  const json report = this->report();
  EXPECT_EQ(report["edges"]["scans_mapped"], 5);  // 3 to 7: the eighth would end after the last pose
  EXPECT_EQ(report["edges"]["scans_not_mapped"], (json{{"no_pose", 15}}));
  EXPECT_THAT(report["notes"].dump(), HasSubstr("15 scans are not in the map"));
  put_poses(drive_.poses());
  static_cast<void>(run_it({.output = folder_ / "five", .first = 3, .count = 5}));
  EXPECT_TRUE(test::slurp(out_ / "edges.ot") == test::slurp(folder_ / "five/edges.ot"));
}

TEST_F(RunPosesTest, GapsAreNotMapped) {
  put_poses(poses_where([](Stamp ns) { return ns <= 300'000'000 || ns >= 1'500'000'000; }));
  static_cast<void>(run_it());
  EXPECT_EQ(report()["edges"]["scans_not_mapped"], (json{{"gap", 12}}));
  EXPECT_NEAR(report()["poses"]["distrusted_s"]["gap"].get<double>(), 1.2, 0.01);
}

TEST_F(RunPosesTest, AJumpOf50MetresIsNotInTheMap) {
  put_poses(poses_moved([](Stamp ns) {
    const bool off = ns >= 900'000'000 && ns <= 1'200'000'000;
    return std::optional<Eigen::Vector3d>({0.0, off ? 50.0 : 0.0, 0.0});
  }));
  static_cast<void>(run_it());
  const json report = this->report();
  EXPECT_GE(report["poses"]["jumps"], 2);
  EXPECT_GE(report["edges"]["scans_not_mapped"]["jump"], 4);
  EXPECT_LE(report["edges"]["scans_not_mapped"]["jump"], 6);
  EXPECT_LT(farthest_off_m(), 15.0);
  expect_on_berms(lines());
}

TEST_F(RunPosesTest, WithoutOneTrustedScanThereIsNoMap) {
  Trajectory poses;
  poses.append(0, drive_.T_world_base(0));
  poses.append(2'000'000'000, drive_.T_world_base(2'000'000'000));
  put_poses(poses);
  static_cast<void>(run_it());
  EXPECT_FALSE(fs::exists(out_ / "edges.ot"));
  EXPECT_THAT(report()["notes"].dump(), HasSubstr("the poses of no scan are trusted"));
  EXPECT_EQ(report()["edges"]["scans_mapped"], 0);
}

TEST_F(RunPosesTest, PosesOfAnotherTimeAreNotedOrRefused) {
  TruckDrive later = drive_;
  later.start_ns = 1'700'000'000'000'000'000;
  put_poses(later.poses());
  EXPECT_EQ(run_it().counts.labelled, kScans);
  EXPECT_THAT(report()["notes"].dump(), HasSubstr("gnss.tum is not used: poses and scans share no time"));
  EXPECT_FALSE(fs::exists(out_ / "edges.ot"));
  EXPECT_FALSE(fs::exists(out_ / "trajectory.tum"));
  test::expect_file_error(ErrorCode::malformed, "poses and scans share no time", [&] {
    static_cast<void>(run_it({.output = folder_ / "other", .poses = recording_ / "gnss.tum"}));
  });
}

TEST_F(RunPosesTest, PosesByOptionBeatThoseOfTheRecording) {
  TruckDrive wrong = drive_;
  wrong.origin_m = {1000.0, 0.0, 0.0};
  put_poses(wrong.poses());
  for (const char* name : {"mine.tum", "mine.txt", "mine.csv"}) {
    const fs::path file = folder_ / name;
    const bool csv = file.extension() == ".csv";
    test::spill(file, csv ? test::as_csv(drive_.poses()) : test::as_tum(drive_.poses()));
    static_cast<void>(run_it({.force = true, .poses = file}));
    expect_on_berms(lines());
    EXPECT_EQ(report()["poses"]["file"], file.string());
  }
}

TEST_F(RunPosesTest, PosesOfKittiNeedTheCalibrationOfTheRecording) {
  std::string poses;
  for (std::size_t i = 0; i < kScans; ++i) {
    const Stamp stamp_ns = static_cast<Stamp>(i) * 100'000'000;
    const Pose T_world_camera = drive_.T_world_base(stamp_ns) * machine_.mount.T_base_sensor();
    const Eigen::Matrix<double, 3, 4> m = T_world_camera.matrix().topRows<3>();
    for (Eigen::Index k = 0; k < 12; ++k) {
      poses += (k > 0 ? " " : "") + std::to_string(m(k / 4, k % 4));
    }
    poses += "\n";
  }
  const fs::path file = folder_ / "poses.txt";
  test::spill(file, poses);
  test::expect_file_error(ErrorCode::not_found, "calib.txt",
                          [&] { static_cast<void>(run_it({.output = folder_ / "none", .poses = file})); });
  test::spill(recording_ / "calib.txt", "Tr: 1 0 0 0 0 1 0 0 0 0 1 0\n");
  static_cast<void>(run_it({.poses = file}));
  expect_on_berms(lines());
}

TEST_F(RunPosesTest, QuaternionsThatAreNoneAreRefusedOrCounted) {
  const Trajectory drive = drive_.poses();
  const std::string good = test::as_tum(drive);
  const fs::path file = folder_ / "mine.tum";
  const auto last = drive.poses().back().stamp_ns + 1'000'000'000;
  const std::string at = std::to_string(to_seconds(last));
  for (const char* quaternion : {"nan nan nan nan", "0 0 0 0", "0 0 0 1.5"}) {
    test::spill(file, good + at + " 0 0 0 " + quaternion + "\n");
    test::expect_file_error(ErrorCode::malformed, "mine.tum: line 43",
                            [&] { static_cast<void>(run_it({.output = folder_ / "none", .poses = file})); });
  }
  // Within 1 % they are normalised, and in a CSV an empty or NaN value is a row without a position.
  test::spill(folder_ / "mine.csv", test::as_csv(drive_.poses()) + std::to_string(last) + ",0,0,0,nan,nan,nan,nan\n");
  static_cast<void>(run_it({.poses = folder_ / "mine.csv"}));
  EXPECT_EQ(report()["poses"]["log"]["no_fix"], 1);
  EXPECT_THAT(report()["notes"].dump(), HasSubstr("1 without a position"));
  EXPECT_EQ(report()["edges"]["scans_mapped"], kScans);
}

TEST_F(RunPosesTest, AnNmeaLogBesideTheScansPutsTheMapOnTheEarth) {
  start_at(43'200'000'000'000);
  std::string log = test::as_nmea(drive_.poses(), kMineDatum);
  // Two sentences whose checksum is spoilt, and a cut one.
  for (const std::size_t n : {5U, 11U}) {
    std::size_t star = 0;
    for (std::size_t i = 0; i < n; ++i) {
      star = log.find('*', star + 1);
    }
    log[star - 1] = log[star - 1] == '1' ? '2' : '1';
  }
  test::spill(recording_ / "gnss.nmea", log + "$GNGGA,1200");
  static_cast<void>(run_it());
  const json report = this->report();
  EXPECT_EQ(report["poses"]["log"]["bad_checksum"], 3) << "one of them cut";
  EXPECT_THAT(report["notes"].dump(), HasSubstr("3 with a bad checksum"));
  EXPECT_NEAR(report["poses"]["datum"]["lat_deg"].get<double>(), kMineDatum.lat_deg, 1e-6);
  EXPECT_TRUE(fs::exists(out_ / "edges.geojson"));
  EXPECT_EQ(report["edges"]["scans_mapped"], kScans);
  expect_on_berms(lines());

  // A second drive begins elsewhere: with the map of the first, its world begins where that of the first does.
  TruckDrive second = drive_;
  second.origin_m = {3.0, -1.0, 0.0};
  test::spill(recording_ / "gnss.nmea", test::as_nmea(second.poses(), kMineDatum));
  static_cast<void>(run_it({.output = folder_ / "second", .map = out_ / "edges.ot"}));
  EXPECT_EQ(map_in(folder_ / "second").world(), map().world());
  EXPECT_GT(map_in(folder_ / "second").size(), map().size());
  static_cast<void>(run_it({.output = folder_ / "alone"}));
  EXPECT_NE(map_in(folder_ / "alone").world(), map().world());
}

TEST_F(RunPosesTest, TwoDaysWithoutADatumAreTwoWorlds) {
  machine_.datum.origin = "none";
  start_at(43'200'000'000'000);
  test::spill(recording_ / "gnss.nmea", test::as_nmea(drive_.poses(), kMineDatum));
  static_cast<void>(run_it());
  EXPECT_FALSE(fs::exists(out_ / "edges.geojson"));
  EXPECT_FALSE(datum_of(map().world()));
  static_cast<void>(run_it({.output = folder_ / "again", .map = out_ / "edges.ot"}));
  // The second day begins elsewhere, and its metres are counted from there.
  TruckDrive second = drive_;
  second.origin_m = {3.0, -1.0, 0.0};
  test::spill(recording_ / "gnss.nmea", test::as_nmea(second.poses(), kMineDatum));
  test::expect_file_error(ErrorCode::unsupported, "cannot be put together",
                          [&] { static_cast<void>(run_it({.output = folder_ / "second", .map = out_ / "edges.ot"})); });
  static_cast<void>(run_it({.output = folder_ / "alone"}));
  EdgeMap merged = map();
  EXPECT_THROW(merged.merge(map_in(folder_ / "alone")), Error);
}

TEST_F(RunPosesTest, CoordinatesOfUtmGiveTheSameLinesShifted) {
  put_poses(drive_.poses());
  static_cast<void>(run_it());
  const std::vector<EdgeLine> near = lines();
  drive_.origin_m = {500'000.0, 5'000'000.0, 200.0};
  put_poses(drive_.poses());
  static_cast<void>(run_it({.force = true}));
  const std::vector<EdgeLine> far = lines();
  ASSERT_EQ(far.size(), near.size());
  for (std::size_t i = 0; i < far.size(); ++i) {
    ASSERT_EQ(far[i].vertices.size(), near[i].vertices.size());
    for (std::size_t k = 0; k < far[i].vertices.size(); ++k) {
      const Eigen::Vector3d shifted_m = near[i].vertices[k].position_m + drive_.origin_m;
      EXPECT_LT((far[i].vertices[k].position_m - shifted_m).norm(), 0.002);
    }
  }
  // They are no metres around a datum.
  machine_.datum.origin = "given";
  EXPECT_THROW(static_cast<void>(run_it({.output = folder_ / "none"})), FileError);
  EXPECT_FALSE(fs::exists(folder_ / "none"));
}

}  // namespace
}  // namespace berm
