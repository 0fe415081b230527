#include <memory>
#include <sstream>
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

/// The program over a simulated piste of four seconds and its map, made once.
class LocalizeCommandTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made_ = std::make_unique<test::TempFolder>();
    const ProgramResult sim =
        run_berm({"sim", "groomer_clear", "-o", (*made_ / "recording").string(), "--seconds", "4", "--seed", "2",
                  "--set", "vehicle.speed_m_per_s=2.1", "--set", "vehicle.start_m=14", "--set", "traffic.parked=1"});
    ASSERT_EQ(sim.exit_code, 0) << sim.err;
    const ProgramResult map = run_to(*made_ / "map", {"--map-surface", "--method", "odometry=none"});
    ASSERT_EQ(map.exit_code, 0) << map.err;
  }
  static void TearDownTestSuite() { made_.reset(); }

  [[nodiscard]] static ProgramResult run_to(const fs::path& out, const std::vector<std::string>& more) {
    std::vector<std::string> all = {"run", (*made_ / "recording").string(), "-m", "groomer", "-o", out.string()};
    all.insert(all.end(), more.begin(), more.end());
    return run_berm(all);
  }

  static inline std::unique_ptr<test::TempFolder> made_;
  test::TempFolder folder_;
  fs::path out_ = folder_ / "out";
};

TEST_F(LocalizeCommandTest, StartsFromThePosesOfTheRecordingAndIsJudged) {
  const ProgramResult result = run_to(out_, {"--localize", (*made_ / "map").string()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("located in the map: "));
  const ProgramResult eval = run_berm({"eval", out_.string(), (*made_ / "recording").string()});
  EXPECT_EQ(eval.exit_code, 0) << eval.err;
  const json localization = json::parse(eval.out)["localization"];
  EXPECT_GE(localization["poses"], 3) << "the first second or two goes into the search";
  EXPECT_LT(localization["max_m"], 0.3);
}

TEST_F(LocalizeCommandTest, AStartThatLooksTheOtherWayEndsWithLosses) {
  std::istringstream gnss(test::slurp(*made_ / "recording/gnss.tum"));
  std::string stamp;
  std::string x_m;
  std::string y_m;
  gnss >> stamp >> x_m >> y_m;
  // The machine looks some 100 degrees away from x.
  const std::string turned = x_m + "," + y_m + ",0";
  const ProgramResult result = run_to(out_, {"--localize", (*made_ / "map/map").string(), "--start", turned});
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_THAT(result.err, HasSubstr("was never located in"));
}

TEST_F(LocalizeCommandTest, SaysWhatIsWrong) {
  const ProgramResult alone = run_to(out_, {"--start", "1,2,3"});
  EXPECT_EQ(alone.exit_code, 2);
  EXPECT_THAT(alone.err, HasSubstr("--localize"));
  const ProgramResult words = run_to(out_, {"--localize", (*made_ / "map").string(), "--start", "here"});
  EXPECT_EQ(words.exit_code, 2);
  const ProgramResult few = run_to(out_, {"--localize", (*made_ / "map").string(), "--start", "1,2"});
  EXPECT_EQ(few.exit_code, 2);
  const ProgramResult none = run_to(out_, {"--localize", (folder_ / "none").string()});
  EXPECT_EQ(none.exit_code, 1);
  EXPECT_THAT(none.err, HasSubstr("holds no map of a surface"));
  EXPECT_FALSE(fs::exists(out_));
}

}  // namespace
}  // namespace berm
