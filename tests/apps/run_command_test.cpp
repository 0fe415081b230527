#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "support/data.hpp"
#include "support/made_recording.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using test::ProgramResult;
using test::run_berm;
using testing::HasSubstr;
using testing::Not;

class RunCommandTest : public testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> arguments(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all = {"run", recording_.string(), "--machine", "car", "-o", out_.string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  [[nodiscard]] nlohmann::json report() const { return nlohmann::json::parse(test::slurp(out_ / "run.json")); }

  test::TempFolder folder_;
  fs::path recording_ = folder_ / "recording";
  fs::path out_ = folder_ / "out";
};

TEST_F(RunCommandTest, AWholeRunEndsWithZeroAndSaysSo) {
  test::make_recording(recording_, 4);
  const ProgramResult result = run_berm(arguments());
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("4 scans"));
  EXPECT_THAT(result.err, Not(HasSubstr("\r")));  // no progress bar without a terminal
  EXPECT_EQ(report()["machine"]["machine"]["name"], "car");
}

TEST_F(RunCommandTest, QuietSaysNothing) {
  test::make_recording(recording_, 2);
  const ProgramResult result = run_berm(arguments({"--quiet"}));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out + result.err, "");
}

TEST_F(RunCommandTest, LossesEndWithThree) {
  test::make_recording(recording_, 4);
  test::spill(recording_ / "scans/000002.pcd", "broken");
  const ProgramResult result = run_berm(arguments());
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("1 of 4 scans were skipped"));
  EXPECT_EQ(report()["skipped"][0]["scan"], "000002");
}

TEST_F(RunCommandTest, NothingUsableEndsWithOne) {
  test::make_recording(recording_, 1);
  test::spill(recording_ / "scans/000000.pcd", "broken");
  const ProgramResult result = run_berm(arguments());
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("berm: error: "));
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(RunCommandTest, RecordingsThatAreNoneEndWithOne) {
  EXPECT_EQ(run_berm(arguments()).exit_code, 1);
  fs::create_directories(recording_ / "scans");
  const ProgramResult empty = run_berm(arguments());
  EXPECT_EQ(empty.exit_code, 1);
  EXPECT_THAT(empty.err, HasSubstr("recording"));
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(RunCommandTest, ABrokenMachineFileEndsWithOneAndNamesTheLine) {
  test::make_recording(recording_, 1);
  test::spill(folder_ / "mine.yaml", "mount:\n  hight_m: 2\n");
  const ProgramResult result =
      run_berm({"run", recording_.string(), "-m", (folder_ / "mine.yaml").string(), "-o", out_.string()});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("mine.yaml: line 2: mount.hight_m: unknown key, did you mean 'height_m'?"));
}

TEST_F(RunCommandTest, SettingsAndMethodReachTheRunFile) {
  test::make_recording(recording_, 3);
  const ProgramResult result = run_berm(arguments({"--set", "mount.height_m=1.9", "--set", "mount.x_m=0.5", "--method",
                                                   "ground=reference", "--first", "1", "--count", "1"}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(report()["machine"]["mount"]["height_m"], 1.9);
  EXPECT_EQ(report()["machine"]["mount"]["x_m"], 0.5);
  EXPECT_EQ(report()["machine"]["methods"]["ground"], "reference");
  EXPECT_TRUE(fs::exists(out_ / "labels/000001.label"));
  EXPECT_FALSE(fs::exists(out_ / "labels/000002.label"));
}

TEST_F(RunCommandTest, SelectingNothingIsWrongUsage) {
  test::make_recording(recording_, 3);
  const ProgramResult result = run_berm(arguments({"--first", "3"}));
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("the recording has 3"));
}

TEST_F(RunCommandTest, TheSheetOfTheRecordingWinsUnlessSet) {
  test::make_recording(recording_, 1);
  test::spill(recording_ / "sequence.json", R"({"sensor_height_m": 2.2, "sensor_pitch_deg": 5.0})");
  const ProgramResult result = run_berm(arguments({"--set", "mount.pitch_deg=7"}));
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("mount.height_m = 2.2 from sequence.json instead of the machine's 1.73"));
  EXPECT_EQ(report()["machine"]["mount"]["height_m"], 2.2);
  EXPECT_EQ(report()["machine"]["mount"]["pitch_deg"], 7.0);
}

TEST_F(RunCommandTest, AnExistingOutputNeedsForce) {
  test::make_recording(recording_, 2);
  EXPECT_EQ(run_berm(arguments()).exit_code, 0);
  const std::string before = test::slurp(out_ / "run.json");
  const ProgramResult refused = run_berm(arguments());
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.err, HasSubstr("--force"));
  EXPECT_EQ(test::slurp(out_ / "run.json"), before);
  EXPECT_EQ(run_berm(arguments({"--force"})).exit_code, 0);
}

TEST_F(RunCommandTest, ASingleFileIsARecordingToo) {
  test::make_recording(recording_, 1);
  recording_ = recording_ / "scans/000000.pcd";
  EXPECT_EQ(run_berm(arguments()).exit_code, 0);
  EXPECT_TRUE(fs::exists(out_ / "labels/000000.label"));
}

TEST_F(RunCommandTest, RealScansGiveTheSameBytesOnTwoThreads) {
  BERM_NEED_DATA(kitti, "kitti00");
  recording_ = kitti;
  EXPECT_EQ(run_berm(arguments({"--threads", "1", "--count", "4"})).exit_code, 0);
  const fs::path alone = out_;
  out_ = folder_ / "out2";
  EXPECT_EQ(run_berm(arguments({"--threads", "2", "--count", "4"})).exit_code, 0);
  for (std::size_t i = 0; i < 4; ++i) {
    const fs::path name = fs::path("labels") / (test::scan_name(i) + ".label");
    const std::string labels = test::slurp(alone / name);
    EXPECT_GT(labels.size(), 400'000U);
    EXPECT_TRUE(labels == test::slurp(out_ / name)) << name;
  }
}

TEST_F(RunCommandTest, EveryMethodOfSnowAndPisteCanBeNamed) {
  test::make_recording(recording_, 2);
  for (const char* snow : {"none", "default", "reference"}) {
    for (const char* piste : {"none", "default", "reference"}) {
      const ProgramResult result = run_berm(
          arguments({"--force", "--method", std::string("snow=") + snow, "--method", std::string("piste=") + piste}));
      EXPECT_EQ(result.exit_code, 0) << result.err;
      EXPECT_EQ(report()["machine"]["methods"]["snow"], snow);
      EXPECT_EQ(report()["machine"]["methods"]["piste"], piste);
      EXPECT_EQ(fs::exists(out_ / "boundary.csv"), std::string(piste) != "none") << "an earlier one is removed";
      EXPECT_TRUE(fs::exists(out_ / "scans.csv"));
    }
  }
  const ProgramResult wrong = run_berm(arguments({"--force", "--method", "piste=best"}));
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("none, default or reference"));
}

}  // namespace
}  // namespace berm
