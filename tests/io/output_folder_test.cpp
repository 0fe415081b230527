#include "berm/io/output_folder.hpp"

#include <optional>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "support/child_process.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using test::expect_file_error;
using test::spill;

constexpr const char* kRunFile = "{\n  \"schema\": \"berm.run/1\"\n}\n";

OutputResults run_results() {
  return {"run", "run.json", "\"schema\": \"berm.run", {"trajectory.tum"}, {{"labels", ".label"}}};
}

class OutputFolderTest : public testing::Test {
 protected:
  void expect_refused(bool force, const std::string& says) {
    expect_file_error(ErrorCode::exists, says, [&] { OutputFolder(out_, force, run_results(), recording_); });
  }
  void make_old_run() const {
    fs::create_directories(out_ / "labels");
    spill(out_ / "run.json", kRunFile);
    spill(out_ / "trajectory.tum", "");
    spill(out_ / "labels/000007.label", "");
  }

  test::TempFolder folder_;
  fs::path out_ = folder_ / "out";
  fs::path recording_ = folder_ / "recording";
};

TEST_F(OutputFolderTest, IsCreatedWithItsParents) {
  OutputFolder output(folder_ / "a/b/c", false, run_results(), recording_);
  EXPECT_TRUE(fs::is_directory(folder_ / "a/b/c/labels"));
}

TEST_F(OutputFolderTest, AnEmptyFolderIsFine) {
  fs::create_directory(out_);
  OutputFolder(out_, false, run_results(), recording_);
  EXPECT_TRUE(fs::is_directory(out_));
}

TEST_F(OutputFolderTest, WithoutAnyResultNothingIsLeft) {
  { OutputFolder output(out_, false, run_results(), recording_); }
  EXPECT_FALSE(fs::exists(out_));
}

TEST_F(OutputFolderTest, AnUnfinishedRunKeepsItsMarkerAFinishedOneDoesNot) {
  {
    OutputFolder output(out_, false, run_results(), recording_);
    spill(output / "labels" / "000000.label", "");
  }
  EXPECT_TRUE(fs::exists(out_ / OutputFolder::kMarker));
  expect_refused(false, "did not finish");
  {
    OutputFolder output(out_, true, run_results(), recording_);
    spill(output / "labels" / "000000.label", "");
    output.finish();
  }
  EXPECT_FALSE(fs::exists(out_ / OutputFolder::kMarker));
}

TEST_F(OutputFolderTest, AFullFolderNeedsForce) {
  make_old_run();
  expect_refused(false, "--force");
  EXPECT_TRUE(fs::exists(out_ / "run.json"));
}

TEST_F(OutputFolderTest, ForceRemovesTheResultsOfARunAndNothingElse) {
  make_old_run();
  spill(out_ / "notes.txt", "mine");
  spill(out_ / "labels/readme.md", "mine");
  spill(out_ / "run.json.1-2.berm-tmp", "");
  const OutputFolder output(out_, true, run_results(), recording_);
  EXPECT_FALSE(fs::exists(out_ / "run.json"));
  EXPECT_FALSE(fs::exists(out_ / "trajectory.tum"));
  EXPECT_FALSE(fs::exists(out_ / "labels/000007.label"));
  EXPECT_FALSE(fs::exists(out_ / "run.json.1-2.berm-tmp"));
  EXPECT_EQ(test::slurp(out_ / "notes.txt"), "mine");
  EXPECT_EQ(test::slurp(out_ / "labels/readme.md"), "mine");
}

TEST_F(OutputFolderTest, ForceDoesNotTouchWhatNoRunWrote) {
  fs::create_directories(out_ / "labels");
  spill(out_ / "labels/000000.label", "truth");
  expect_refused(true, "not written by a run");
  EXPECT_EQ(test::slurp(out_ / "labels/000000.label"), "truth");
  EXPECT_FALSE(fs::exists(out_ / OutputFolder::kMarker));

  spill(out_ / "run.json", "{\"schema\": \"other.run/1\"}");
  expect_refused(true, "not written by a run");
}

TEST_F(OutputFolderTest, ForceDoesNotFollowALinkOutOfTheFolder) {
  make_old_run();
  fs::remove_all(out_ / "labels");
  fs::create_directories(folder_ / "elsewhere");
  spill(folder_ / "elsewhere/000000.label", "truth");
  fs::create_directory_symlink(folder_ / "elsewhere", out_ / "labels");
  expect_refused(true, "labels");
  EXPECT_EQ(test::slurp(folder_ / "elsewhere/000000.label"), "truth");
}

TEST_F(OutputFolderTest, TheRecordingIsNeverTheOutput) {
  fs::create_directories(recording_ / "scans");
  expect_file_error(ErrorCode::exists, "recording itself",
                    [&] { OutputFolder(recording_, true, run_results(), recording_); });
  expect_file_error(ErrorCode::exists, "recording itself",
                    [&] { OutputFolder(recording_ / "scans/..", true, run_results(), recording_); });
}

TEST_F(OutputFolderTest, AFileIsNoFolder) {
  spill(out_, "");
  expect_refused(true, "is a file");
}

TEST_F(OutputFolderTest, TwoRunsCannotWriteAtTheSameTime) {
  const OutputFolder first(out_, false, run_results(), recording_);
  expect_refused(false, "did not finish");
  // A lock is held per open file: the second writer is another process or this one, all the same.
  expect_refused(true, "another run is writing");
  EXPECT_TRUE(fs::exists(out_ / OutputFolder::kMarker));
}

TEST_F(OutputFolderTest, AFolderThatCannotBeWrittenSaysWhy) {
  fs::create_directory(out_);
  fs::permissions(out_,
                  fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read | fs::perms::others_exec);
  fs::permissions(folder_.path(), fs::perms::others_read | fs::perms::others_exec, fs::perm_options::add);
  const int result = test::run_in_child([this] {
    if (!test::become_ordinary_user()) {
      return 0;
    }
    try {
      OutputFolder output(out_, false, run_results(), recording_);
    } catch (const FileError& error) {
      const bool says_why = std::string(error.what()).find("ermission denied") != std::string::npos;
      return error.code() == ErrorCode::write_failed && says_why ? 0 : 2;
    }
    return 1;
  });
  EXPECT_EQ(result, 0);
}

}  // namespace
}  // namespace berm
