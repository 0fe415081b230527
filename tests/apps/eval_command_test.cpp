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
using test::ProgramResult;
using test::run_berm;
using testing::HasSubstr;

class EvalCommandTest : public testing::Test {
 protected:
  void SetUp() override {
    test::make_recording(recording_, 3, 100);
    fs::create_directories(recording_ / "labels");
    for (std::size_t i = 0; i < 2; ++i) {
      write_labels(recording_ / "labels" / (test::scan_name(i) + ".label"), std::vector<std::uint32_t>(100, 72));
    }
    ASSERT_EQ(run_berm({"run", recording_.string(), "-m", "car", "-o", out_.string()}).exit_code, 0);
  }
  [[nodiscard]] ProgramResult eval(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> all = {"eval", out_.string(), recording_.string()};
    all.insert(all.end(), more.begin(), more.end());
    return run_berm(all);
  }

  test::TempFolder folder_;
  fs::path recording_ = folder_ / "recording";
  fs::path out_ = folder_ / "out";
};

TEST_F(EvalCommandTest, PrintsOneJsonObject) {
  const ProgramResult result = eval();
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  const json object = json::parse(result.out);
  EXPECT_EQ(object["scans"]["judged"], 2);
  EXPECT_TRUE(object["ground"].contains("iou"));
  EXPECT_FALSE(object.contains("per_scan"));
}

TEST_F(EvalCommandTest, WritesAFileOnRequest) {
  const ProgramResult result = eval({"--per-scan", "-o", (folder_ / "metrics.json").string()});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.out, "");
  EXPECT_EQ(json::parse(test::slurp(folder_ / "metrics.json"))["per_scan"].size(), 2U);
}

TEST_F(EvalCommandTest, ScansThatCannotBeJudgedEndWithThree) {
  fs::resize_file(out_ / "labels/000001.label", 399);
  const ProgramResult result = eval();
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.err, HasSubstr("000001"));
  const json object = json::parse(result.out);
  EXPECT_EQ(object["scans"]["failed"], 1);
  EXPECT_EQ(object["scans"]["judged"], 1);
}

TEST_F(EvalCommandTest, AnUnfinishedRunEndsWithThree) {
  fs::remove(out_ / "run.json");
  EXPECT_EQ(eval().exit_code, 3);
}

TEST_F(EvalCommandTest, AFolderThatIsNoRunEndsWithOne) {
  out_ = folder_.path();
  const ProgramResult result = eval();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("output folder of berm run"));
}

}  // namespace
}  // namespace berm
