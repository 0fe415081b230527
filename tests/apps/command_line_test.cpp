#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "program.hpp"

namespace berm {
namespace {

using test::ProgramResult;
using test::run_berm;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

TEST(CommandLine, HelpHasExamplesAndGoesToStdout) {
  for (const char* command : {"", "run", "eval", "info", "draw", "machine"}) {
    std::vector<std::string> arguments = {command, "--help"};
    if (*command == '\0') {
      arguments = {"--help"};
    }
    const ProgramResult result = run_berm(arguments);
    EXPECT_EQ(result.exit_code, 0) << command;
    EXPECT_THAT(result.out, HasSubstr("Examples:")) << command;
    EXPECT_EQ(result.err, "") << command;
  }
}

TEST(CommandLine, VersionIsOneLine) {
  const ProgramResult result = run_berm({"--version"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.out, MatchesRegex("berm [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

struct Wrong {
  std::vector<std::string> arguments;
  std::string says;
};

TEST(CommandLine, WrongUsageEndsWithTwoAndOneLineThatHelps) {
  const std::vector<Wrong> wrong = {
      {{}, "--help"},
      {{"dance"}, "--help"},
      {{"run"}, "berm run --help"},
      {{"run", "x", "--machine", "car"}, "--output"},
      {{"run", "x", "-o", "y"}, "--machine"},
      {{"run", "x", "-o", "y", "--machine", "car", "--nonsense"}, "--nonsense"},
      {{"run", "x", "-o", "y", "--machine", "car", "--threads", "0"}, "--threads"},
      {{"run", "x", "-o", "y", "--machine", "car", "--threads", "many"}, "--threads"},
      {{"run", "x", "-o", "y", "--machine", "car", "--first=-1"}, "--first"},
      {{"run", "x", "-o", "y", "--machine", "car", "--count", "0"}, "--count"},
      {{"run", "x", "-o", "y", "--machine", "tank"}, "car, groomer or haul_truck"},
      {{"run", "x", "-o", "y", "--machine", "car", "--set", "mount.heigth_m=2"}, "did you mean 'height_m'"},
      {{"run", "x", "-o", "y", "--machine", "car", "--set", "mount.height_m=-2"}, "0 to 50"},
      {{"run", "x", "-o", "y", "--machine", "car", "--set", "mount.height_m"}, "SECTION.KEY=VALUE"},
      {{"run", "x", "-o", "y", "--machine", "car", "--method", "ground=best"}, "default or reference"},
      {{"run", "x", "-o", "y", "--machine", "car", "--method", "grond=default"}, "did you mean 'ground'"},
      {{"run", "x", "-o", "y", "--machine", "car", "-q", "-v"}, "--quiet"},
      {{"eval", "x"}, "RECORDING"},
      {{"draw", "x", "-o", "y", "--view", "below"}, "--view"},
      {{"draw", "x", "-o", "y", "--width", "0"}, "width"},
      {{"machine"}, "--help"},
      {{"machine", "show", "tank"}, "car, groomer or haul_truck"},
  };
  for (const Wrong& usage : wrong) {
    const ProgramResult result = run_berm(usage.arguments);
    const std::string shown = testing::PrintToString(usage.arguments);
    EXPECT_EQ(result.exit_code, 2) << shown << result.err;
    EXPECT_THAT(result.err, StartsWith("berm: error: ")) << shown;
    EXPECT_THAT(result.err, HasSubstr(usage.says)) << shown;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << shown << result.err;
    EXPECT_EQ(result.out, "") << shown;
  }
}

}  // namespace
}  // namespace berm
