#include <filesystem>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "berm/io/label_file.hpp"
#include "program.hpp"
#include "support/made_recording.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::run_berm;
using testing::HasSubstr;

class ReportCommandTest : public testing::Test {
 protected:
  void make_run() {
    test::make_recording(recording_, 3, 100);
    const auto result = run_berm({"run", recording_.string(), "-m", "car", "-o", out_.string()});
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  void add_truth() const {
    fs::create_directories(recording_ / "labels");
    for (std::size_t i = 0; i < 3; ++i) {
      write_labels(recording_ / "labels" / (test::scan_name(i) + ".label"), std::vector<std::uint32_t>(100, 72));
    }
  }
  /// What stands in the page for its script.
  [[nodiscard]] json data() const {
    const std::string page = test::slurp(out_ / "report.html");
    const std::string mark = "<script type=\"application/json\" id=\"run\">";
    const std::size_t begin = page.find(mark) + mark.size();
    return json::parse(page.substr(begin, page.find("</script>", begin) - begin));
  }

  test::TempFolder folder_;
  fs::path recording_ = folder_ / "recording <b>&";
  fs::path out_ = folder_ / "out";
};

TEST_F(ReportCommandTest, ARunLeavesItsPage) {
  make_run();
  const json shown = data();
  EXPECT_EQ(shown["run"]["recording"]["path"], recording_.string());
  EXPECT_EQ(shown["scans"]["rows"], 3);
  EXPECT_EQ(shown["times"]["rows"], 3);
  EXPECT_FALSE(shown.contains("evaluation"));
  EXPECT_EQ(test::slurp(out_ / "report.html").find("recording <b>"), std::string::npos);
}

TEST_F(ReportCommandTest, TruthThatCameLaterIsMeasured) {
  make_run();
  add_truth();
  EXPECT_EQ(run_berm({"report", out_.string()}).exit_code, 0);
  EXPECT_TRUE(data()["evaluation"].contains("ground"));
}

TEST_F(ReportCommandTest, ARecordingThatMovedIsNoted) {
  make_run();
  add_truth();
  fs::rename(recording_, folder_ / "moved");
  const auto without = run_berm({"report", out_.string()});
  EXPECT_EQ(without.exit_code, 0);
  EXPECT_THAT(without.err, HasSubstr("--recording"));
  EXPECT_FALSE(data().contains("evaluation"));
  EXPECT_EQ(run_berm({"report", out_.string(), "--recording", (folder_ / "moved").string()}).exit_code, 0);
  EXPECT_TRUE(data().contains("evaluation"));
}

TEST_F(ReportCommandTest, AnotherRunReplacesThePage) {
  make_run();
  test::spill(out_ / "report.html", "old");
  const auto result = run_berm({"run", recording_.string(), "-m", "car", "-o", out_.string(), "--force"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(data()["scans"]["rows"], 3);
}

TEST_F(ReportCommandTest, WhatIsNoRunHasNoReport) {
  fs::create_directories(out_);
  const auto result = run_berm({"report", out_.string()});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("run.json"));
  EXPECT_FALSE(fs::exists(out_ / "report.html"));
}

}  // namespace
}  // namespace berm
