#include <ostream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::ProgramResult;
using test::run_berm;

/// A scenario, and the machine that its recordings are run with.
struct Case {
  const char* scenario;
  const char* machine;
};

void PrintTo(const Case& example, std::ostream* stream) {
  *stream << example.scenario;
}

class SimScenariosTest : public testing::TestWithParam<Case> {};

TEST_P(SimScenariosTest, IsSimulatedRunAndJudged) {
  const test::TempFolder folder;
  const std::string recording = (folder / "recording").string();
  const std::string out = (folder / "out").string();
  const ProgramResult made = run_berm({"sim", GetParam().scenario, "-o", recording, "--seconds", "2", "-q"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  EXPECT_EQ(made.err, "");
  const ProgramResult run = run_berm({"run", recording, "--machine", GetParam().machine, "-o", out});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err.find("instead of the machine's"), std::string::npos)
      << "the mount of the scenario is not that of its machine: " << run.err;
  const ProgramResult judged = run_berm({"eval", out, recording});
  ASSERT_EQ(judged.exit_code, 0) << judged.err;
  EXPECT_FALSE(nlohmann::json::parse(judged.out).empty());
}

INSTANTIATE_TEST_SUITE_P(All, SimScenariosTest,
                         testing::Values(Case{"groomer_snowfall", "groomer"}, Case{"groomer_clear", "groomer"},
                                         Case{"groomer_forks", "groomer"}, Case{"groomer_night_storm", "groomer"},
                                         Case{"haul_road", "haul_truck"}, Case{"haul_road_dust", "haul_truck"},
                                         Case{"flat_road", "car"}, Case{"car_park", "car"}),
                         [](const auto& example) { return std::string(example.param.scenario); });

}  // namespace
}  // namespace berm
