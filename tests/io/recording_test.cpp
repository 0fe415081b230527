#include "berm/io/recording.hpp"

#include <algorithm>
#include <cstddef>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "berm/io/kitti_bin.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/pcd.hpp"
#include "berm/io/times_file.hpp"
#include "berm/io/trajectory_file.hpp"
#include "support/child_process.hpp"
#include "support/data.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using test::expect_file_error;
using test::spill;
using ::testing::Test;

/// One point at (`x`, 2, 3).
PointCloud one_point(float x, float intensity) {
  PointChannels channels;
  channels.x = {x};
  channels.y = {2.0F};
  channels.z = {3.0F};
  channels.intensity = {intensity};
  return PointCloud(std::move(channels));
}

/// A PCD file with absolute time, one point.
std::string timed_pcd(const std::string& stamp_s) {
  return "VERSION 0.7\nFIELDS x y z timestamp\nSIZE 4 4 4 8\nTYPE F F F F\nCOUNT 1 1 1 1\nWIDTH 1\nHEIGHT 1\n"
         "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 1\nDATA ascii\n1 2 3 " +
         stamp_s + "\n";
}

class RecordingFolder : public Test {
 protected:
  [[nodiscard]] Recording open() const { return Recording::open(folder_.path()); }

  void add_pcd(const std::string& name, float x = 1.0F) const {
    fs::create_directories((folder_ / name).parent_path());
    write_pcd(folder_ / name, one_point(x, 7.0F).view());
  }
  void add_bin(const std::string& name, float intensity, IntensityScale scale, float x = 1.0F) const {
    fs::create_directories((folder_ / name).parent_path());
    write_kitti_bin(folder_ / name, one_point(x, intensity).view(), scale);
  }
  void expect_refused(ErrorCode code, const std::string& part) const {
    expect_file_error(code, part, [&] { (void)open(); });
  }
  [[nodiscard]] static std::vector<std::string> names(const Recording& recording) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < recording.size(); ++i) {
      result.push_back(recording.scan(i).name);
    }
    return result;
  }
  [[nodiscard]] static std::vector<Stamp> stamps(const Recording& recording) {
    std::vector<Stamp> result;
    for (std::size_t i = 0; i < recording.size(); ++i) {
      result.push_back(recording.scan(i).stamp_ns);
    }
    return result;
  }
  [[nodiscard]] static bool notes(const Recording& recording, const std::string& part) {
    return std::any_of(recording.notes().begin(), recording.notes().end(),
                       [&](const std::string& note) { return note.find(part) != std::string::npos; });
  }

  test::TempFolder folder_;
};

TEST_F(RecordingFolder, SequenceFolder) {
  add_pcd("scans/000000.pcd", 10.0F);
  add_pcd("scans/000001.pcd", 11.0F);
  spill(folder_ / "times.txt", "5.5\n5.6\n");
  spill(folder_ / "sequence.json", R"({"scan_hz": 20, "sensor_height_m": 2.3, "snowflakes": 5})");
  spill(folder_ / "gnss.tum", "5 0 0 0 0 0 0 1\n6 1 0 0 0 0 0 1\n");
  spill(folder_ / "truth.tum", "5 0 0 0 0 0 0 1\n");
  fs::create_directory(folder_ / "labels");
  write_labels(folder_ / "labels/000001.label", std::vector<std::uint32_t>{40});

  const Recording recording = open();
  EXPECT_EQ(recording.layout(), RecordingLayout::sequence);
  EXPECT_EQ(names(recording), (std::vector<std::string>{"000000", "000001"}));
  EXPECT_EQ(stamps(recording), (std::vector<Stamp>{5'500'000'000, 5'600'000'000}));
  EXPECT_EQ(recording.stamp_source(), StampSource::times_file);
  EXPECT_EQ(recording.sheet().height_m, 2.3);
  EXPECT_FALSE(recording.scan(0).truth_labels);
  EXPECT_EQ(recording.scan(1).truth_labels, folder_ / "labels/000001.label");
  EXPECT_TRUE(notes(recording, "truth labels for 1 of 2 scans"));
  EXPECT_TRUE(notes(recording, "sequence.json: not used: 'snowflakes'"));

  Scan scan;
  recording.read(1, scan);
  EXPECT_EQ(scan.stamp_ns, 5'600'000'000);
  EXPECT_EQ(scan.cloud.view().x.front(), 11.0F);
  EXPECT_EQ(scan.cloud.view().intensity.front(), 7.0F);

  const auto given = recording.read_given_poses();
  ASSERT_TRUE(given);
  EXPECT_EQ(given->of, PoseOf::base);
  EXPECT_EQ(given->trajectory.size(), 2U);
  EXPECT_EQ(recording.read_truth_poses().value().size(), 1U);
}

TEST_F(RecordingFolder, ReadingReusesTheMemoryOfTheCloudAndLeavesTheMount) {
  add_pcd("scans/0.pcd");
  const Recording recording = open();
  Scan scan;
  scan.T_base_sensor = Pose(Eigen::Quaterniond::Identity(), {0, 0, 2});
  recording.read(0, scan);
  const float* memory = scan.cloud.view().x.data();
  recording.read(0, scan);
  EXPECT_EQ(scan.cloud.view().x.data(), memory);
  EXPECT_EQ(scan.T_base_sensor.translation_m().z(), 2.0);
}

TEST_F(RecordingFolder, EmptyFolderWrongFolderNoFolder) {
  expect_refused(ErrorCode::not_found, "no scans: expected scans/*.pcd");
  fs::create_directories(folder_ / "scans");
  spill(folder_ / "map.las", "");
  expect_refused(ErrorCode::not_found, "it holds *.las");
  expect_file_error(ErrorCode::not_found, "there is no such file or folder",
                    [&] { (void)Recording::open(folder_ / "nothing"); });
  expect_file_error(ErrorCode::unsupported, "expected a .pcd or KITTI .bin file",
                    [&] { (void)Recording::open(folder_ / "map.las"); });
  expect_file_error(ErrorCode::unreadable, "neither a file nor a folder", [] { (void)Recording::open("/dev/null"); });
}

TEST_F(RecordingFolder, LinksThatLeadNowhereOrInCircles) {
  fs::create_directory_symlink(folder_.path(), folder_ / "scans");
  expect_refused(ErrorCode::not_found, "no scans");
  fs::create_symlink("loop", folder_ / "loop");
  expect_file_error(ErrorCode::unreadable, "loop: cannot be looked at",
                    [&] { (void)Recording::open(folder_ / "loop"); });
  add_pcd("1.pcd");
  fs::create_symlink("3.pcd", folder_ / "2.pcd");
  fs::create_symlink("2.pcd", folder_ / "3.pcd");
  const Recording recording = open();
  EXPECT_EQ(recording.size(), 3U);
  Scan scan;
  EXPECT_THROW(recording.read(1, scan), FileError);
}

TEST_F(RecordingFolder, PipesAndFoldersNamedLikeScansAreLeftOut) {
  add_pcd("1.pcd");
  fs::create_directory(folder_ / "2.pcd");
  ASSERT_EQ(::mkfifo((folder_ / "3.pcd").c_str(), 0600), 0);
  spill(folder_ / ".4.pcd", "");
  const Recording recording = open();
  EXPECT_EQ(recording.size(), 1U);
  EXPECT_TRUE(notes(recording, "2 entries named *.pcd are no files"));
}

TEST_F(RecordingFolder, UnreadableFolderAndFiles) {
  add_pcd("scans/1.pcd");
  add_pcd("scans/2.pcd");
  spill(folder_ / "times.txt", "1\n2\n");
  fs::permissions(folder_ / "scans/1.pcd", fs::perms::none);
  fs::permissions(folder_.path(), fs::perms::all);
  const auto code_of = [](auto&& body) {
    try {
      body();
    } catch (const FileError& error) {
      return error.code() == ErrorCode::unreadable ? 1 : 2;
    }
    return 3;
  };
  const int file = test::run_in_child([&] {
    Scan scan;
    return test::become_ordinary_user() ? code_of([&] { open().read(0, scan); }) : 4;
  });
  EXPECT_EQ(file, 1);
  fs::permissions(folder_ / "scans", fs::perms::none);
  const int folder =
      test::run_in_child([&] { return test::become_ordinary_user() ? code_of([&] { (void)open(); }) : 4; });
  EXPECT_EQ(folder, 1);
  fs::permissions(folder_ / "scans", fs::perms::all);
}

TEST_F(RecordingFolder, OrdersByNumberNotByText) {
  for (const char* name : {"scan10.pcd", "scan9.pcd", "scan0100.pcd", "scan1.pcd"}) {
    add_pcd(name);
  }
  EXPECT_EQ(names(open()), (std::vector<std::string>{"scan1", "scan9", "scan10", "scan0100"}));
}

TEST_F(RecordingFolder, GapsAreNotedNotRefused) {
  for (const char* name : {"000003.pcd", "000004.pcd", "000007.pcd", "000009.pcd"}) {
    add_pcd(name);
  }
  const Recording recording = open();
  EXPECT_TRUE(notes(recording, "3 numbers are missing from the names of the scans: 000005..000006, 000008"));
  EXPECT_TRUE(notes(recording, "no times.txt: 10 Hz assumed"));
  EXPECT_EQ(stamps(recording), (std::vector<Stamp>{0, 100'000'000, 200'000'000, 300'000'000}));
}

TEST_F(RecordingFolder, NumbersThatAreTimesHaveNoGaps) {
  for (const char* name : {"20240509061326.pcd", "20240509061327.pcd", "20240509071327.pcd"}) {
    add_pcd(name);
  }
  EXPECT_FALSE(notes(open(), "missing"));
}

TEST_F(RecordingFolder, TimesByPositionByNumberOrNotAtAll) {
  for (const char* name : {"scans/1.pcd", "scans/2.pcd", "scans/5.pcd"}) {
    add_pcd(name);
  }
  spill(folder_ / "times.txt", "10\n20\n30\n");
  EXPECT_EQ(stamps(open()), (std::vector<Stamp>{10'000'000'000, 20'000'000'000, 30'000'000'000}));
  spill(folder_ / "times.txt", "0\n1\n2\n3\n4\n5\n");
  EXPECT_EQ(stamps(open()), (std::vector<Stamp>{1'000'000'000, 2'000'000'000, 5'000'000'000}));
  EXPECT_TRUE(notes(open(), "stamps taken by number"));
  spill(folder_ / "times.txt", "0\n1\n2\n3\n");
  expect_refused(ErrorCode::malformed, "times.txt: 4 stamps for 3 scans (1 to 5); expected one line per scan, or 6");
  spill(folder_ / "times.txt", "");
  expect_refused(ErrorCode::malformed, "0 stamps for 3 scans");
  spill(folder_ / "times.txt", "0\n2\n1\n");
  expect_refused(ErrorCode::malformed, "times.txt: line 3: the stamp '1' is not later");
}

TEST_F(RecordingFolder, RateOfTheSheet) {
  add_pcd("scans/0.pcd");
  add_pcd("scans/1.pcd");
  spill(folder_ / "sequence.json", R"({"scan_hz": 20})");
  EXPECT_EQ(stamps(open()), (std::vector<Stamp>{0, 50'000'000}));
  EXPECT_TRUE(notes(open(), "scan_hz of sequence.json"));
}

TEST_F(RecordingFolder, StampsOfTheScanFiles) {
  spill(folder_ / "0.pcd", timed_pcd("1000.25"));
  spill(folder_ / "1.pcd", timed_pcd("1000.33"));
  spill(folder_ / "2.pcd", timed_pcd("1000.45"));
  const Recording recording = open();
  EXPECT_EQ(recording.stamp_source(), StampSource::scan_files);
  EXPECT_EQ(stamps(recording), (std::vector<Stamp>{1'000'250'000'000, 1'000'350'000'000, 1'000'450'000'000}));
  Scan scan;
  recording.read(1, scan);
  EXPECT_EQ(scan.stamp_ns, 1'000'330'000'000);
  // times.txt goes first.
  spill(folder_ / "times.txt", "1\n2\n3\n");
  open().read(1, scan);
  EXPECT_EQ(scan.stamp_ns, 2'000'000'000);
}

TEST_F(RecordingFolder, StampsOfScanFilesThatRunBackwardsAreNotUsed) {
  spill(folder_ / "0.pcd", timed_pcd("1000.25"));
  spill(folder_ / "1.pcd", timed_pcd("999"));
  const Recording recording = open();
  EXPECT_EQ(recording.stamp_source(), StampSource::assumed_rate);
  EXPECT_TRUE(notes(recording, "do not rise from the first to the last"));
  Scan scan;
  recording.read(1, scan);
  EXPECT_EQ(scan.stamp_ns, 100'000'000);
}

TEST_F(RecordingFolder, IntensityIsRecognisedOnceForAllScans) {
  add_bin("velodyne/0.bin", 51.0F, IntensityScale::unit);
  add_bin("velodyne/1.bin", 0.0F, IntensityScale::unit);
  const Recording unit = open();
  EXPECT_EQ(unit.layout(), RecordingLayout::kitti);
  EXPECT_TRUE(notes(unit, "multiplied by 255"));
  Scan scan;
  unit.read(0, scan);
  EXPECT_NEAR(scan.cloud.view().intensity.front(), 51.0F, 1e-3F);

  add_bin("velodyne/0.bin", 0.0F, IntensityScale::byte);
  add_bin("velodyne/1.bin", 200.0F, IntensityScale::byte);
  const Recording byte = open();
  byte.read(1, scan);
  EXPECT_EQ(scan.cloud.view().intensity.front(), 200.0F);

  add_bin("velodyne/1.bin", 1.0F, IntensityScale::byte);
  EXPECT_TRUE(notes(open(), "say nothing about their unit"));
}

TEST_F(RecordingFolder, BrokenScansFailWhenReadNotWhenOpened) {
  for (const char* name : {"velodyne/0.bin", "velodyne/1.bin", "velodyne/2.bin"}) {
    add_bin(name, 51.0F, IntensityScale::unit);
  }
  spill(folder_ / "velodyne/0.bin", "short");
  fs::remove(folder_ / "velodyne/2.bin");
  fs::create_symlink("gone", folder_ / "velodyne/2.bin");
  const Recording recording = open();
  Scan scan;
  recording.read(1, scan);
  EXPECT_NEAR(scan.cloud.view().intensity.front(), 51.0F, 1e-3F);
  expect_file_error(ErrorCode::truncated, "0.bin", [&] { recording.read(0, scan); });
  EXPECT_TRUE(scan.cloud.empty());
  expect_file_error(ErrorCode::not_found, "2.bin", [&] { recording.read(2, scan); });
  EXPECT_THROW(recording.read(3, scan), Error);
  EXPECT_THROW((void)recording.scan(3), Error);
}

TEST_F(RecordingFolder, NoReadableScanIsAnErrorAtOnce) {
  spill(folder_ / "0.bin", "short");
  spill(folder_ / "1.bin", "short");
  expect_refused(ErrorCode::truncated, "0.bin");
}

TEST_F(RecordingFolder, KittiPosesMoveFromTheCameraToTheLidar) {
  for (const char* name : {"velodyne/0.bin", "velodyne/1.bin"}) {
    add_bin(name, 51.0F, IntensityScale::unit);
  }
  spill(folder_ / "poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 1 5\n");
  EXPECT_TRUE(notes(open(), "poses.txt is not used"));
  EXPECT_FALSE(open().read_given_poses());
  // Camera: z forward, x right, y down; 0.3 m in front of the LiDAR.
  spill(folder_ / "calib.txt", "Tr: 0 -1 0 0 0 0 -1 0 1 0 0 -0.3\n");
  const auto given = open().read_given_poses();
  ASSERT_TRUE(given);
  EXPECT_EQ(given->of, PoseOf::sensor);
  EXPECT_EQ(given->trajectory.poses()[1].stamp_ns, 100'000'000);
  // 5 m forward for the camera are 5 m along x for the LiDAR.
  EXPECT_TRUE(given->trajectory.poses()[1].T_world_base.translation_m().isApprox(Eigen::Vector3d(5, 0, 0)));
  EXPECT_TRUE(given->trajectory.poses()[0].T_world_base.log().isZero(1e-12));

  spill(folder_ / "poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  const Recording recording = open();
  expect_file_error(ErrorCode::malformed, "poses.txt: 1 poses for 2 scans",
                    [&] { (void)recording.read_given_poses(); });
}

TEST_F(RecordingFolder, OneFileOfPosesIsUsed) {
  add_pcd("scans/0.pcd");
  spill(folder_ / "poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  spill(folder_ / "calib.txt", "Tr: 0 -1 0 0 0 0 -1 0 1 0 0 -0.3\n");
  EXPECT_FALSE(open().pose_log());
  EXPECT_TRUE(open().read_given_poses());
  spill(folder_ / "gnss.nmea", "");
  EXPECT_EQ(open().pose_log(), folder_ / "gnss.nmea");
  EXPECT_FALSE(open().read_given_poses());
  EXPECT_TRUE(notes(open(), "gnss.nmea and poses.txt are both there: gnss.nmea is used"));
  spill(folder_ / "gnss.csv", "");
  EXPECT_EQ(open().pose_log(), folder_ / "gnss.csv");
  spill(folder_ / "gnss.tum", "0 1 2 3 0 0 0 1\n");
  EXPECT_FALSE(open().pose_log());
  EXPECT_EQ(open().read_given_poses()->file, folder_ / "gnss.tum");
}

TEST_F(RecordingFolder, PosesFromElsewhereAreReadOnDemand) {
  add_pcd("scans/0.pcd");
  const fs::path file = folder_ / "elsewhere.txt";
  spill(file, "1 0 0 0 0 1 0 0 0 0 1 0\n");
  const Recording without = open();
  expect_file_error(ErrorCode::not_found, "calib.txt", [&] { (void)without.read_camera_poses(file); });
  spill(folder_ / "calib.txt", "Tr: 0 -1 0 0 0 0 -1 0 1 0 0 -0.3\n");
  EXPECT_EQ(open().read_camera_poses(file).of, PoseOf::sensor);
  spill(file, "0 1 2 3 0 0 0 1\n");
  EXPECT_EQ(Recording::read_tum_poses(file).trajectory.size(), 1U);
}

TEST_F(RecordingFolder, BrokenPosesFailWhenAskedFor) {
  add_pcd("scans/0.pcd");
  spill(folder_ / "gnss.tum", "0 0 0\n");
  spill(folder_ / "truth.tum", "");
  const Recording recording = open();
  expect_file_error(ErrorCode::malformed, "gnss.tum: line 1", [&] { (void)recording.read_given_poses(); });
  EXPECT_TRUE(recording.read_truth_poses().value().empty());
}

TEST_F(RecordingFolder, LabelsBelongToScansByName) {
  for (const char* name : {"8.pcd", "9.pcd", "10.pcd", "11.pcd"}) {
    add_pcd(name);
  }
  fs::create_directory(folder_ / "labels");
  for (const char* name : {"labels/9.label", "labels/10.label", "labels/010.label", "labels/7.label"}) {
    spill(folder_ / name, "");
  }
  const Recording recording = open();
  std::vector<bool> labelled;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    labelled.push_back(recording.scan(i).truth_labels.has_value());
  }
  EXPECT_EQ(labelled, (std::vector<bool>{false, true, true, false}));
  EXPECT_TRUE(notes(recording, "2 of 4 files in labels/ have the name of no scan"));
}

TEST_F(RecordingFolder, TwoKindsOfScansInOneFolder) {
  add_pcd("1.pcd");
  add_bin("1.bin", 3.0F, IntensityScale::byte);
  EXPECT_EQ(open().layout(), RecordingLayout::pcd_folder);
  EXPECT_TRUE(notes(open(), "only the latter are read"));
}

TEST_F(RecordingFolder, SeveralSeriesInOneFolderAreNoted) {
  for (const char* name : {"raw_0.pcd", "raw_1.pcd", "clean_0.pcd"}) {
    add_pcd(name);
  }
  EXPECT_TRUE(notes(open(), "names start differently ('clean_', 'raw_')"));
}

TEST_F(RecordingFolder, SingleFiles) {
  add_pcd("a.pcd", 4.0F);
  const Recording recording = Recording::open(folder_ / "a.pcd");
  EXPECT_EQ(recording.layout(), RecordingLayout::single_file);
  EXPECT_EQ(names(recording), std::vector<std::string>{"a"});
  EXPECT_TRUE(recording.notes().empty());
  Scan scan;
  recording.read(0, scan);
  EXPECT_EQ(scan.cloud.view().x.front(), 4.0F);
  // A name without a folder.
  const int result = test::run_in_child([&] {
    fs::current_path(folder_.path());
    Recording::open("a.pcd").read(0, scan);
    return 0;
  });
  EXPECT_EQ(result, 0);
}

TEST_F(RecordingFolder, ManyScansOpenWithoutBeingRead) {
  fs::create_directories(folder_ / "scans");
  constexpr std::size_t kCount = 20'000;
  std::vector<Stamp> times;
  for (std::size_t i = 0; i < kCount; ++i) {
    spill(folder_ / ("scans/" + std::to_string(i) + ".pcd"), "");
    times.push_back(static_cast<Stamp>(i));
  }
  write_times(folder_ / "times.txt", times);
  const Recording recording = open();
  EXPECT_EQ(recording.size(), kCount);
  EXPECT_EQ(recording.scan(kCount - 1).name, "19999");
  EXPECT_EQ(recording.scan(kCount - 1).stamp_ns, static_cast<Stamp>(kCount - 1));
}

TEST_F(RecordingFolder, ThreadsReadAtOnce) {
  constexpr std::size_t kScans = 16;
  for (std::size_t i = 0; i < kScans; ++i) {
    add_pcd("scans/" + std::to_string(i) + ".pcd", static_cast<float>(i));
  }
  const Recording recording = open();
  std::vector<std::size_t> wrong(4, 0);
  std::vector<std::thread> threads;
  for (std::size_t& count : wrong) {
    threads.emplace_back([&recording, &count] {
      Scan scan;
      for (std::size_t i = 0; i < 10 * kScans; ++i) {
        recording.read(i % kScans, scan);
        count += scan.cloud.view().x.front() == static_cast<float>(i % kScans) ? 0U : 1U;
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  EXPECT_EQ(wrong, std::vector<std::size_t>(4, 0));
}

TEST(RealRecordings, AllOpenAndRead) {
  BERM_NEED_DATA(data, ".");
  for (const char* name : {"kitti00", "wads36", "livox_horizon", "livox_vehicle", "livox_mid40", "livox_mid360",
                           "hdl32_rings", "per_point_time"}) {
    SCOPED_TRACE(name);
    const Recording recording = Recording::open(data / name);
    Scan scan;
    Stamp last = -1;
    for (std::size_t i = 0; i < recording.size(); ++i) {
      recording.read(i, scan);
      EXPECT_GT(scan.cloud.size(), 10'000U);
      EXPECT_GT(scan.stamp_ns, last);
      last = scan.stamp_ns;
    }
  }
}

TEST(RealRecordings, Kitti00) {
  BERM_NEED_DATA(path, "kitti00");
  const Recording recording = Recording::open(path);
  EXPECT_EQ(recording.layout(), RecordingLayout::kitti);
  EXPECT_EQ(recording.size(), 16U);
  EXPECT_EQ(recording.stamp_source(), StampSource::times_file);
  EXPECT_EQ(recording.scan(1).stamp_ns, 103'700'000);
  EXPECT_TRUE(recording.scan(0).truth_labels);
  EXPECT_FALSE(recording.scan(1).truth_labels);
  // poses_consensus.tum is no file that a machine brings along.
  EXPECT_FALSE(recording.read_given_poses());
  EXPECT_FALSE(recording.read_truth_poses());
}

}  // namespace
}  // namespace berm
