#include <algorithm>
#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>

#include "program.hpp"
#include "support/made_recording.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using test::Program;
using test::ProgramResult;
using test::run_berm;
using testing::HasSubstr;

constexpr std::size_t kScans = 150;
constexpr std::size_t kPoints = 4000;

/// A file system of its own, as small or as read-only as a test needs; unmounted at the end.
class Mount {
 public:
  Mount(fs::path folder, unsigned long flags, const std::string& options) : folder_(std::move(folder)) {
    fs::create_directories(folder_);
    mounted_ = ::mount("tmpfs", folder_.c_str(), "tmpfs", flags, options.c_str()) == 0;
  }
  ~Mount() {
    if (mounted_) {
      ::umount2(folder_.c_str(), MNT_DETACH);
    }
  }
  Mount(const Mount&) = delete;
  Mount& operator=(const Mount&) = delete;
  [[nodiscard]] bool is_there() const { return mounted_; }

 private:
  fs::path folder_;
  bool mounted_ = false;
};

class RunFaultsTest : public testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> arguments(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all = {"run", recording_.string(), "--machine", "car", "-o", out_.string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  [[nodiscard]] std::size_t label_files() const {
    std::size_t count = 0;
    std::error_code code;
    for (fs::directory_iterator entry(out_ / "labels", code), end; !code && entry != end; entry.increment(code)) {
      count += entry->path().extension() == ".label" ? 1U : 0U;
    }
    return count;
  }

  /// Until some scans are labelled, or the time is up.
  void wait_for_labels(std::size_t count) const {
    for (int tries = 0; tries < 2000 && label_files() < count; ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    ASSERT_GE(label_files(), count);
  }

  void expect_whole_label_files() const {
    for (const auto& entry : fs::directory_iterator(out_ / "labels")) {
      if (entry.path().extension() == ".label") {
        EXPECT_EQ(entry.file_size(), 4 * kPoints) << entry.path();
      }
    }
  }

  test::TempFolder folder_;
  fs::path recording_ = folder_ / "recording";
  fs::path out_ = folder_ / "out";
};

TEST_F(RunFaultsTest, KilledInTheMiddleItLeavesNoHalfFiles) {
  test::make_recording(recording_, kScans, kPoints);
  {
    Program program(arguments());
    wait_for_labels(3);
    program.send(SIGKILL);
    const int exit_code = program.wait().exit_code;
    ASSERT_EQ(exit_code, 128 + SIGKILL) << "the run ended before it could be killed";
  }
  EXPECT_FALSE(fs::exists(out_ / "run.json"));
  EXPECT_LT(label_files(), kScans);
  expect_whole_label_files();
  EXPECT_EQ(run_berm(arguments()).exit_code, 1);
  EXPECT_EQ(run_berm(arguments({"--force"})).exit_code, 0);
  EXPECT_EQ(label_files(), kScans);
  const auto is_temporary = [](const auto& entry) { return entry.path().extension() == ".berm-tmp"; };
  EXPECT_EQ(std::count_if(fs::directory_iterator(out_ / "labels"), fs::directory_iterator(), is_temporary), 0);
}

TEST_F(RunFaultsTest, AnInterruptEndsItCleanly) {
  test::make_recording(recording_, kScans, kPoints);
  for (const int signal : {SIGINT, SIGTERM}) {
    fs::remove_all(out_);
    Program program(arguments());
    wait_for_labels(3);
    program.send(signal);
    const ProgramResult result = program.wait();
    EXPECT_EQ(result.exit_code, 128 + signal) << result.err;
    EXPECT_THAT(result.err, HasSubstr("stopped by a signal after"));
    EXPECT_FALSE(fs::exists(out_ / "run.json"));
    expect_whole_label_files();
  }
}

TEST_F(RunFaultsTest, OfTwoRunsIntoOneFolderOneIsRefused) {
  test::make_recording(recording_, kScans, kPoints);
  Program first(arguments());
  wait_for_labels(1);
  const ProgramResult second = run_berm(arguments({"--force"}));
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_THAT(second.err, HasSubstr("another run is writing"));
  EXPECT_EQ(first.wait().exit_code, 0);
  EXPECT_EQ(label_files(), kScans);
}

TEST_F(RunFaultsTest, OfTwoRunsStartedTogetherOneIsWhole) {
  test::make_recording(recording_, 20, kPoints);
  Program first(arguments());
  Program second(arguments());
  const int sum = first.wait().exit_code + second.wait().exit_code;
  EXPECT_EQ(sum, 1);
  EXPECT_TRUE(fs::exists(out_ / "run.json"));
  EXPECT_EQ(label_files(), 20U);
}

TEST_F(RunFaultsTest, AFullDiskEndsWithOneAndNoHalfFiles) {
  test::make_recording(recording_, kScans, kPoints);
  const Mount mount(folder_ / "small", 0, "size=200k");
  if (!mount.is_there()) {
    GTEST_SKIP() << "this user may not mount a small file system";
  }
  out_ = folder_ / "small/out";
  const ProgramResult result = run_berm(arguments());
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("No space left on device"));
  EXPECT_FALSE(fs::exists(out_ / "run.json"));
  EXPECT_GT(label_files(), 3U);
  expect_whole_label_files();
}

TEST_F(RunFaultsTest, AFullDiskKeepsTheMapThatIsContinued) {
  ASSERT_EQ(run_berm({"sim", "haul_road", "-o", recording_.string(), "--seconds", "1"}).exit_code, 0);
  const auto run_truck = [this](const std::vector<std::string>& more) {
    std::vector<std::string> all = {"run", recording_.string(), "-m", "haul_truck", "-o", out_.string()};
    all.insert(all.end(), more.begin(), more.end());
    return run_berm(all);
  };
  ASSERT_EQ(run_truck({}).exit_code, 0);
  std::uintmax_t labels = 0;
  for (const auto& entry : fs::directory_iterator(out_ / "labels")) {
    labels += (entry.file_size() / 4096 + 1) * 4096;
  }
  const std::string map = test::slurp(out_ / "edges.ot");
  // Room for the old map, the labels and half of the new map.
  const Mount mount(folder_ / "small", 0, "size=" + std::to_string(labels + map.size() * 3 / 2));
  if (!mount.is_there()) {
    GTEST_SKIP() << "this user may not mount a small file system";
  }
  const fs::path old = folder_ / "small/old.ot";
  test::spill(old, map);
  out_ = folder_ / "small/out";
  const ProgramResult result = run_truck({"--map", old.string()});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("edges.ot: "));
  EXPECT_THAT(result.err, HasSubstr("No space left on device"));
  EXPECT_TRUE(test::slurp(old) == map);
  EXPECT_FALSE(fs::exists(out_ / "edges.ot"));
  EXPECT_FALSE(fs::exists(out_ / "run.json"));
}

TEST_F(RunFaultsTest, AReadOnlyDiskEndsWithOneAndSaysWhy) {
  test::make_recording(recording_, 1);
  const Mount mount(folder_ / "fixed", MS_RDONLY, "size=200k");
  if (!mount.is_there()) {
    GTEST_SKIP() << "this user may not mount a read-only file system";
  }
  for (const char* name : {"fixed", "fixed/out"}) {
    out_ = folder_ / name;
    const ProgramResult result = run_berm(arguments());
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_THAT(result.err, HasSubstr("Read-only file system"));
  }
}

TEST_F(RunFaultsTest, AResultThatCannotBePrintedEndsWithOne) {
  test::make_recording(recording_, 1);
  EXPECT_EQ(run_berm(arguments()).exit_code, 0);
  const ProgramResult result = run_berm({"eval", out_.string(), recording_.string()}, "/dev/full");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("stdout: No space left on device"));
}

}  // namespace
}  // namespace berm
