#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::ProgramResult;
using test::run_berm;
using testing::HasSubstr;

/// The program over a simulated haul road of two seconds, which is made once.
class RunEdgesCommandTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<test::TempFolder>();
    const ProgramResult result =
        run_berm({"sim", "haul_road", "-o", (*made_ / "recording").string(), "--seconds", "2", "--seed", "3"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
  }
  static void TearDownTestSuite() { made_.reset(); }

  [[nodiscard]] static fs::path recording() { return *made_ / "recording"; }
  [[nodiscard]] static ProgramResult run_to(const fs::path& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> all = {"run", recording().string(), "-m", "haul_truck", "-o", out.string()};
    all.insert(all.end(), more.begin(), more.end());
    return run_berm(all);
  }
  [[nodiscard]] static json report(const fs::path& out) { return json::parse(test::slurp(out / "run.json")); }

  static inline std::unique_ptr<test::TempFolder> made_;
  test::TempFolder folder_;
  fs::path out_ = folder_ / "out";
};

TEST_F(RunEdgesCommandTest, AMapItsLinesAndTheRoadAreWrittenAndJudged) {
  const ProgramResult result = run_to(out_);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("note: no datum"));
  EXPECT_THAT(result.err, HasSubstr("road edges: "));
  const json files = report(out_)["files"];
  for (const char* key : {"edge_map", "edges", "edge_points", "road", "trajectory"}) {
    EXPECT_TRUE(fs::exists(out_ / files[key].get<std::string>())) << key;
  }
  const ProgramResult eval = run_berm({"eval", out_.string(), recording().string()});
  EXPECT_EQ(eval.exit_code, 0) << eval.err;
  const json edges = json::parse(eval.out)["edges"];
  EXPECT_GT(edges["precision"], 0.8);
  EXPECT_GT(edges["places"]["found_right"], 50);
  EXPECT_LT(edges["lateral_median_m"], 0.3);
}

TEST_F(RunEdgesCommandTest, AMapIsContinuedFromRunToRun) {
  ASSERT_EQ(run_to(out_).exit_code, 0);
  ASSERT_EQ(run_to(folder_ / "a", {"--count", "9", "--threads", "1"}).exit_code, 0);
  const fs::path old = folder_ / "a/edges.ot";
  ASSERT_EQ(run_to(folder_ / "b", {"--first", "9", "--map", old.string()}).exit_code, 0);
  EXPECT_TRUE(test::slurp(folder_ / "b/edges.ot") == test::slurp(out_ / "edges.ot"));

  const ProgramResult voxel = run_to(folder_ / "c", {"--map", old.string(), "--set", "map.voxel_m=0.1"});
  EXPECT_EQ(voxel.exit_code, 1);
  EXPECT_THAT(voxel.err, HasSubstr("set map.voxel_m=0.2"));
  const ProgramResult own = run_to(folder_ / "a", {"--map", old.string(), "--force"});
  EXPECT_EQ(own.exit_code, 1);
  EXPECT_THAT(own.err, HasSubstr("choose another folder"));
  const ProgramResult none = run_to(folder_ / "c", {"--map", old.string(), "--method", "edge=none"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("--method edge=default"));
  EXPECT_FALSE(fs::exists(folder_ / "c"));
}

TEST_F(RunEdgesCommandTest, PosesCanBeNamed) {
  const ProgramResult missing = run_to(out_, {"--poses", (folder_ / "none.tum").string()});
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_THAT(missing.err, HasSubstr("none.tum: there is no such file of poses"));
  const fs::path truth = recording() / "truth.tum";
  ASSERT_EQ(run_to(out_, {"--poses", truth.string(), "--method", "edge=reference"}).exit_code, 0);
  EXPECT_EQ(report(out_)["poses"]["file"], truth.string());
  EXPECT_EQ(report(out_)["machine"]["methods"]["edge"], "reference");
}

}  // namespace
}  // namespace berm
