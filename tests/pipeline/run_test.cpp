#include "berm/pipeline/run.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/trajectory_file.hpp"
#include "groomer_scan.hpp"
#include "support/data.hpp"
#include "support/made_recording.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

Machine made_machine() {
  Machine machine;
  machine.machine.name = "made";
  machine.sensor.model = "made";
  machine.mount.height_m = 1.7;
  return machine;
}

/// Every file below `folder` but those that hold times, by its path in it.
std::map<std::string, std::string> files_below(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const fs::path name = entry.path().filename();
    if (entry.is_regular_file() && name != "run.json" && name != "times.csv") {
      files[entry.path().lexically_relative(folder).string()] = test::slurp(entry.path());
    }
  }
  return files;
}

json report_of(const fs::path& folder) {
  return json::parse(test::slurp(folder / "run.json"));
}

/// run.json without what may differ from run to run.
json timeless(json report) {
  for (const char* key : {"stages", "wall_s", "peak_memory_mib", "threads"}) {
    report.erase(key);
  }
  return report;
}

class RunTest : public testing::Test {
 protected:
  RunSummary run_it(const RunOptions& options) const {
    return run(Recording::open(recording_), made_machine(), options);
  }

  test::TempFolder folder_;
  fs::path recording_ = folder_ / "recording";
  fs::path out_ = folder_ / "out";
};

TEST_F(RunTest, WritesOneLabelFileAScanAndTheReportLast) {
  test::make_recording(recording_, 5, 700);
  std::vector<std::size_t> progress;
  const RunSummary summary = run_it({.output = out_, .on_progress = [&](std::size_t done, std::size_t total) {
                                       EXPECT_EQ(total, 5U);
                                       EXPECT_FALSE(fs::exists(out_ / "run.json"));
                                       progress.push_back(done);
                                     }});
  EXPECT_EQ(progress, (std::vector<std::size_t>{1, 2, 3, 4, 5}));
  EXPECT_EQ(summary.counts.labelled, 5U);
  EXPECT_FALSE(summary.interrupted);

  const auto files = files_below(out_);
  EXPECT_EQ(files.size(), 6U) << "labels and scans.csv";
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(files.at("labels/" + test::scan_name(i) + ".label").size(), 4U * 700U);
  }
  const json report = report_of(out_);
  EXPECT_EQ(report["schema_version"], 2);
  EXPECT_EQ(report["state"], "whole");
  EXPECT_EQ(report["machine"]["mount"]["height_m"], 1.7);
  EXPECT_EQ(report["counts"]["points"]["total"], 3500);
  for (const char* stage : {"read", "snow", "ground", "check", "write"}) {
    for (const char* figure : {"cpu_mean_ms", "mean_ms", "p50_ms", "p95_ms", "p99_ms", "max_ms"}) {
      EXPECT_TRUE(report["stages"][stage][figure].is_number()) << stage << " " << figure;
    }
  }
  EXPECT_GT(report["peak_memory_mib"], 0.0);
}

TEST_F(RunTest, ListsTheTimesOfEveryLabelledScan) {
  test::make_recording(recording_, 4, 700);
  test::spill(recording_ / "scans/000002.pcd", "broken");
  static_cast<void>(run_it({.output = out_}));
  std::istringstream table(test::slurp(out_ / "times.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_EQ(line,
            "scan,stamp,read_ms,snow_ms,ground_ms,repair_ms,piste_ms,edge_ms,check_ms,odometry_ms,map_ms,write_ms");
  for (const char* name : {"000000", "000001", "000003"}) {
    ASSERT_TRUE(std::getline(table, line));
    EXPECT_THAT(line,
                testing::MatchesRegex(std::string(name) + ",[0-9.]+,[0-9.]+,[0-9.]+,[0-9.]+,,,,[0-9.]+,,,[0-9.]+"));
  }
  EXPECT_FALSE(std::getline(table, line));
}

TEST_F(RunTest, LabelsAreTheIdsOnDiskAndAddUp) {
  test::make_recording(recording_, 2, 700);
  const RunSummary summary = run_it({.output = out_});
  RunCounts seen;
  for (std::size_t i = 0; i < 2; ++i) {
    const auto labels = read_labels(out_ / "labels" / (test::scan_name(i) + ".label"), 700);
    for (std::size_t point = 0; point < labels.size(); ++point) {
      seen.drivable += labels[point] == 40 ? 1U : 0U;
      seen.obstacle += labels[point] == 99 ? 1U : 0U;
      EXPECT_EQ(labels[point] == 0, point % 7 == 6) << point;
    }
  }
  EXPECT_EQ(seen.drivable, summary.counts.drivable);
  EXPECT_EQ(seen.obstacle, summary.counts.obstacle);
  EXPECT_EQ(summary.counts.no_return, 200U);
  EXPECT_EQ(summary.counts.points, summary.counts.drivable + summary.counts.obstacle + summary.counts.falling_snow +
                                       summary.counts.no_return + summary.counts.invalid);
}

TEST_F(RunTest, AnyNumberOfThreadsWritesTheSameBytes) {
  test::make_recording(recording_, 17, 900);
  test::spill(recording_ / "scans/000008.pcd", "broken");
  static_cast<void>(run_it({.output = out_}));
  const auto expected = files_below(out_);
  EXPECT_EQ(expected.size(), 17U);
  for (const std::size_t threads : {1U, 2U, 4U, 9U}) {
    const fs::path out = folder_ / ("out" + std::to_string(threads));
    static_cast<void>(run_it({.output = out, .threads = threads}));
    EXPECT_EQ(files_below(out), expected) << threads;
    EXPECT_EQ(timeless(report_of(out)), timeless(report_of(out_))) << threads;
  }
}

TEST_F(RunTest, BrokenScansAreSkippedCountedAndExplained) {
  test::make_recording(recording_, 6);
  test::spill(recording_ / "scans/000003.pcd", "VERSION nonsense");
  test::spill(recording_ / "scans/000004.pcd", "");
  const RunSummary summary = run_it({.output = out_, .threads = 3});
  EXPECT_EQ(summary.counts.labelled, 4U);
  EXPECT_EQ(summary.counts.skipped, 2U);
  EXPECT_FALSE(fs::exists(out_ / "labels/000003.label"));
  EXPECT_TRUE(fs::exists(out_ / "labels/000005.label"));
  const json report = report_of(out_);
  EXPECT_EQ(report["state"], "lossy");
  EXPECT_EQ(report["counts"]["scans"]["skipped"], 2);
  EXPECT_EQ(report["skipped"][0]["scan"], "000003");
  EXPECT_THAT(report["skipped"][0]["reason"].get<std::string>(), HasSubstr("000003.pcd"));
}

TEST_F(RunTest, WithoutAnyUsableScanThereIsNoRun) {
  test::make_recording(recording_, 3);
  const Recording recording = Recording::open(recording_);
  for (std::size_t i = 0; i < 3; ++i) {
    test::spill(recording_ / "scans" / (test::scan_name(i) + ".pcd"), "broken");
  }
  EXPECT_THROW(static_cast<void>(run(recording, made_machine(), {.output = out_})), Error);
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(RunTest, FirstAndCountSelectScans) {
  test::make_recording(recording_, 6);
  EXPECT_EQ(run_it({.output = out_, .first = 2, .count = 3}).counts.selected, 3U);
  const auto files = files_below(out_);
  EXPECT_EQ(files.size(), 4U);
  EXPECT_TRUE(files.contains("labels/000002.label"));
  EXPECT_TRUE(files.contains("labels/000004.label"));
  EXPECT_EQ(run_it({.output = folder_ / "rest", .first = 4, .count = 100}).counts.selected, 2U);
  EXPECT_THROW(static_cast<void>(run_it({.output = folder_ / "none", .first = 6})), Error);
  EXPECT_FALSE(fs::exists(folder_ / "none"));
}

TEST_F(RunTest, GapsInTheNumbersKeepTheNames) {
  test::make_recording(recording_, 5);
  fs::remove(recording_ / "scans/000001.pcd");
  fs::remove(recording_ / "scans/000002.pcd");
  EXPECT_EQ(run_it({.output = out_}).counts.labelled, 3U);
  EXPECT_TRUE(fs::exists(out_ / "labels/000004.label"));
  EXPECT_FALSE(fs::exists(out_ / "labels/000001.label"));
}

TEST_F(RunTest, ScansOfOneAndNoPointAreFine) {
  test::make_recording(recording_, 1, 1);
  write_pcd(recording_ / "scans/000001.pcd", test::made_cloud(1, 0).view());
  EXPECT_EQ(run_it({.output = out_}).counts.labelled, 2U);
  EXPECT_EQ(fs::file_size(out_ / "labels/000000.label"), 4U);
  EXPECT_EQ(fs::file_size(out_ / "labels/000001.label"), 0U);
}

TEST_F(RunTest, AStopIsNoWholeRun) {
  test::make_recording(recording_, 20);
  std::size_t asked = 0;
  const RunSummary summary = run_it({.output = out_, .threads = 2, .should_stop = [&asked] { return ++asked == 5; }});
  EXPECT_TRUE(summary.interrupted);
  EXPECT_EQ(summary.counts.labelled, 5U);
  EXPECT_FALSE(fs::exists(out_ / "run.json"));
  EXPECT_TRUE(fs::exists(out_ / "labels/000004.label"));
  EXPECT_FALSE(fs::exists(out_ / "labels/000005.label"));
  EXPECT_THROW(static_cast<void>(run_it({.output = out_})), FileError);
  EXPECT_EQ(run_it({.output = out_, .force = true}).counts.labelled, 20U);
}

TEST_F(RunTest, AStopAfterTheLastScanIsAWholeRun) {
  test::make_recording(recording_, 1);
  EXPECT_FALSE(run_it({.output = out_, .should_stop = [] { return true; }}).interrupted);
  EXPECT_TRUE(fs::exists(out_ / "run.json"));
}

TEST_F(RunTest, ForceLeavesNoScanOfTheEarlierRun) {
  test::make_recording(recording_, 5);
  static_cast<void>(run_it({.output = out_}));
  static_cast<void>(run_it({.output = out_, .force = true, .first = 3}));
  EXPECT_EQ(files_below(out_ / "labels").size(), 2U);
}

TEST_F(RunTest, PosesOfTheBaseAreInterpolatedAtTheStamps) {
  test::make_recording(recording_, 4);
  test::spill(recording_ / "times.txt", "10.0\n10.1\n10.2\n10.3\n");
  test::spill(recording_ / "gnss.tum", "10.05 1 0 0 0 0 0 1\n10.25 3 0 0 0 0 0 1\n");
  const RunSummary summary = run_it({.output = out_});
  const Trajectory trajectory = read_tum(out_ / "trajectory.tum");
  ASSERT_EQ(trajectory.size(), 2U);
  EXPECT_EQ(trajectory.poses()[0].stamp_ns, 10'100'000'000);
  EXPECT_NEAR(trajectory.poses()[0].T_world_base.translation_m().x(), 1.5, 1e-6);
  EXPECT_EQ(summary.counts.without_pose, 2U);
  const json report = report_of(out_);
  EXPECT_EQ(report["counts"]["scans"]["without_pose"], 2);
  EXPECT_EQ(report["files"]["trajectory"], "trajectory.tum");
  EXPECT_THAT(report["notes"].dump(), HasSubstr("gnss.tum"));
}

TEST_F(RunTest, WithoutPosesThereIsNoTrajectory) {
  test::make_recording(recording_, 2);
  static_cast<void>(run_it({.output = out_}));
  EXPECT_FALSE(fs::exists(out_ / "trajectory.tum"));
  EXPECT_FALSE(report_of(out_)["files"].contains("trajectory"));
}

TEST_F(RunTest, AnotherRateThanTheMachinesIsNoted) {
  test::make_recording(recording_, 3);
  test::spill(recording_ / "times.txt", "0\n0.05\n0.1\n");
  static_cast<void>(run_it({.output = out_}));
  EXPECT_THAT(report_of(out_)["notes"].dump(), HasSubstr("20.00 scans a second"));
}

TEST_F(RunTest, EveryLabelledScanHasALineInTheTable) {
  test::make_recording(recording_, 4, 700);
  test::spill(recording_ / "scans/000002.pcd", "broken");
  test::spill(recording_ / "times.txt", "10.0\n10.1\n10.2\n10.3\n");
  static_cast<void>(run_it({.output = out_, .threads = 2}));
  const std::string table = test::slurp(out_ / "scans.csv");
  EXPECT_THAT(table, testing::StartsWith("scan,stamp,points,returns,"));
  EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 4);
  EXPECT_THAT(table, HasSubstr("\n000001,10.100000000,700,600,100,0,"));
  EXPECT_THAT(table, HasSubstr("no_time"));
  EXPECT_FALSE(fs::exists(out_ / "boundary.csv"));
  const json report = report_of(out_);
  EXPECT_EQ(report["files"]["scans"], "scans.csv");
  EXPECT_FALSE(report["files"].contains("boundary"));
  EXPECT_EQ(report["counts"]["degraded"]["no_time"], 3);
  EXPECT_FALSE(report["counts"]["degraded"].contains("no_points"));
}

/// A recording of what a groomer sees.
class GroomerRun : public RunTest {
 protected:
  void SetUp() override {
    fs::create_directories(recording_ / "scans");
    for (std::uint32_t i = 0; i < 3; ++i) {
      write_pcd(recording_ / "scans" / (test::scan_name(i) + ".pcd"), test::groomer_scan(i + 1).cloud.view());
    }
  }
};

TEST_F(GroomerRun, APisteMethodAddsItsStagesAndTheBoundary) {
  for (const char* method : {"default", "reference"}) {
    const RunOptions options{.output = out_ / method};
    static_cast<void>(run(Recording::open(recording_), test::groomer(method, "default", method), options));
    const json report = report_of(options.output);
    for (const char* stage : {"read", "snow", "ground", "repair", "piste", "check", "write"}) {
      EXPECT_TRUE(report["stages"].contains(stage)) << stage;
    }
    EXPECT_EQ(report["files"]["boundary"], "boundary.csv");
    EXPECT_THAT(test::slurp(options.output / "boundary.csv"), testing::StartsWith("scan,side,x,y,z,confidence\n"));
    EXPECT_EQ(report["counts"]["degraded"], json::object());
  }
}

TEST_F(GroomerRun, StagesThatAreLeftOutAreNotInTheReport) {
  static_cast<void>(
      run(Recording::open(recording_), test::groomer("none", "default", "none"), RunOptions{.output = out_}));
  const json stages = report_of(out_)["stages"];
  for (const char* stage : {"snow", "repair", "piste"}) {
    EXPECT_FALSE(stages.contains(stage)) << stage;
  }
}

TEST_F(GroomerRun, AMountThatIsRightIsPlausible) {
  static_cast<void>(run(Recording::open(recording_), test::groomer(), RunOptions{.output = out_}));
  const json report = report_of(out_);
  EXPECT_EQ(report["mount"]["verdict"], "plausible");
  EXPECT_EQ(report["mount"]["scans_that_tell"], 3);
  EXPECT_NEAR(report["mount"]["height_m"].get<double>(), 2.3, 0.3);
  EXPECT_THAT(report["notes"].dump(), testing::Not(HasSubstr("the mount looks wrong")));
}

TEST_F(GroomerRun, AMountThatIsWrongIsSaidAloud) {
  Machine machine = test::groomer();
  machine.mount.pitch_deg -= 30.0;
  static_cast<void>(run(Recording::open(recording_), machine, RunOptions{.output = out_ / "pitch"}));
  const json pitch = report_of(out_ / "pitch");
  EXPECT_EQ(pitch["mount"]["verdict"], "implausible");
  EXPECT_NEAR(pitch["mount"]["pitch_off_deg"].get<double>(), 30.0, 4.0);
  EXPECT_EQ(pitch["counts"]["degraded"]["mount_implausible"], 3);
  EXPECT_THAT(pitch["notes"].dump(), HasSubstr("the mount looks wrong"));
  machine = test::groomer();
  machine.mount.roll_deg = 180.0;
  static_cast<void>(run(Recording::open(recording_), machine, RunOptions{.output = out_ / "roll"}));
  EXPECT_EQ(report_of(out_ / "roll")["mount"]["verdict"], "implausible");
}

TEST_F(GroomerRun, WithoutGroundTheMountCannotBeJudged) {
  Scan empty = test::groomer_scan();
  test::change_channels(empty, [](PointChannels& channels) {
    for (std::vector<float>* values : {&channels.x, &channels.y, &channels.z}) {
      std::fill(values->begin(), values->end(), 0.0F);
    }
  });
  for (std::uint32_t i = 0; i < 3; ++i) {
    write_pcd(recording_ / "scans" / (test::scan_name(i) + ".pcd"), empty.cloud.view());
  }
  static_cast<void>(run(Recording::open(recording_), test::groomer(), RunOptions{.output = out_}));
  const json report = report_of(out_);
  EXPECT_EQ(report["mount"], (json{{"verdict", "unknown"}, {"scans_that_tell", 0}}));
  EXPECT_EQ(report["counts"]["degraded"]["few_returns"], 3);
}

TEST_F(RunTest, AFullDiskLeavesNothingHalfWritten) {
  test::make_recording(recording_, 3);
  // The label of the second scan cannot get its name: a folder has it.
  const RunOptions options{.output = out_, .on_progress = [this](std::size_t done, std::size_t) {
                             if (done == 1) {
                               fs::create_directory(out_ / "labels/000001.label");
                             }
                           }};
  EXPECT_THROW(static_cast<void>(run_it(options)), FileError);
  EXPECT_FALSE(fs::exists(out_ / "run.json"));
  EXPECT_EQ(files_below(out_ / "labels").size(), 1U);
}

TEST_F(RunTest, RealScansWithOnePercentNan) {
  BERM_NEED_DATA(kitti, "kitti00");
  fs::create_directories(recording_ / "velodyne");
  std::string bytes = test::slurp(kitti / "velodyne/000000.bin");
  const std::string nan("\x00\x00\xc0\x7f", 4);
  for (std::size_t at = 0; at + 16 <= bytes.size(); at += 1600) {
    bytes.replace(at + 4 * (at / 1600 % 3), 4, nan);
  }
  test::spill(recording_ / "velodyne/000000.bin", bytes);
  const RunSummary summary = run_it({.output = out_});
  EXPECT_EQ(summary.counts.points, bytes.size() / 16);
  EXPECT_EQ(summary.counts.invalid, (bytes.size() + 1599) / 1600);
  EXPECT_EQ(summary.counts.skipped, 0U);
}

}  // namespace
}  // namespace berm
