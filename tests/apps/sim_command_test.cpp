#include <chrono>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <signal.h>

#include "program.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using test::ProgramResult;
using test::run_berm;
using test::spill;
using testing::AllOf;
using testing::HasSubstr;

/// Makes a scenario small, so that a test takes a second.
std::vector<std::string> small(const std::string& seconds) {
  std::vector<std::string> arguments = {"--seconds", seconds};
  for (const char* value : {"route.length_m=80", "world.margin_m=40", "piste.forks=0", "things.trees_per_hectare=20",
                            "things.building_every_m=0"}) {
    arguments.insert(arguments.end(), {"--set", value});
  }
  return arguments;
}

class SimCommandTest : public testing::Test {
 protected:
  [[nodiscard]] ProgramResult sim(const std::vector<std::string>& more, const std::string& scenario = "groomer_clear",
                                  const std::string& seconds = "0.2") const {
    std::vector<std::string> arguments = {"sim", scenario, "-o", out_.string()};
    const auto smaller = small(seconds);
    arguments.insert(arguments.end(), smaller.begin(), smaller.end());
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_berm(arguments);
  }

  /// One line that says what is wrong, this exit code, and no folder left behind.
  void expect_refused(const ProgramResult& result, int exit_code, const std::string& says) const {
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_THAT(result.err, AllOf(HasSubstr("berm: error: "), HasSubstr(says)));
    EXPECT_FALSE(fs::exists(out_)) << "a folder was left behind";
  }

  /// A model of 1 m cells, all of one height, with a hole in the west if `with_hole`.
  void write_model(const std::string& name, int columns, int rows, const std::string& cell) const {
    std::string text = "ncols " + std::to_string(columns) + "\nnrows " + std::to_string(rows) +
                       "\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -9999\n";
    for (int row = 0; row < rows; ++row) {
      for (int column = 0; column < columns; ++column) {
        text += cell + " ";
      }
      text += "\n";
    }
    spill(folder_ / name, text);
  }

  [[nodiscard]] std::vector<std::string> with_model(const std::string& name) const {
    return {"--set", "world.elevation=" + (folder_ / name).string()};
  }

  test::TempFolder folder_;
  fs::path out_ = folder_ / "out";
};

TEST_F(SimCommandTest, ListsWhatIsKnown) {
  const ProgramResult result = run_berm({"sim", "--list"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("groomer_snowfall\tSnow groomer"), HasSubstr("haul_road\tHaul truck")));
}

TEST_F(SimCommandTest, MakesARecording) {
  const ProgramResult result = sim({"--seed", "9", "--sensor", "vlp16"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, AllOf(HasSubstr("building the world"), HasSubstr("2 scans over")));
  EXPECT_EQ(result.out, "");
  const auto sheet = nlohmann::json::parse(test::slurp(out_ / "sequence.json"));
  EXPECT_EQ(sheet["seed"], 9);
  EXPECT_EQ(sheet["scenario"], "groomer_clear");
  EXPECT_EQ(sheet["sensor"], "Velodyne VLP-16");
  EXPECT_THAT(test::slurp(out_ / "scenario.yaml"), HasSubstr("sensor: \"vlp16\""));
  EXPECT_THAT(test::slurp(out_ / "scans/000001.pcd").substr(0, 200), HasSubstr("FIELDS x y z intensity ring time\n"));
}

TEST_F(SimCommandTest, AnExistingFolderNeedsForce) {
  EXPECT_EQ(sim({"-q"}).exit_code, 0);
  const ProgramResult again = sim({"-q"});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_THAT(again.err, HasSubstr("--force"));
  spill(out_ / "mine.txt", "");
  EXPECT_EQ(sim({"-q", "--force", "--seed", "2"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(out_ / "mine.txt"));
}

TEST_F(SimCommandTest, ForceNeverReplacesARecordingThatWasNotMade) {
  fs::create_directories(out_ / "scans");
  spill(out_ / "scans/000000.pcd", "real");
  spill(out_ / "sequence.json", "{\"scan_hz\": 10}");
  const ProgramResult result = sim({"--force"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("was not written by a simulation of berm"));
  EXPECT_EQ(test::slurp(out_ / "scans/000000.pcd"), "real");
}

TEST_F(SimCommandTest, NonsenseOnTheCommandLineIsWrongUsage) {
  expect_refused(run_berm({"sim"}), 2, "expected SCENARIO and -o FOLDER");
  expect_refused(run_berm({"sim", "groomer_clear"}), 2, "expected SCENARIO and -o FOLDER");
  expect_refused(sim({}, "gromer_clear"), 2, "did you mean 'groomer_clear'");
  expect_refused(sim({"--sensor", "vlp_16"}), 2, "did you mean 'vlp16'");
  expect_refused(sim({"--set", "vehicle.sped_m_per_s=3"}), 2, "did you mean 'speed_m_per_s'");
  expect_refused(sim({"--set", "world.kind=moon"}), 2, "expected piste, haul_road, flat_road or car_park");
  expect_refused(sim({"--set", "vehicle.speed_m_per_s=nan"}), 2, "vehicle.speed_m_per_s");
  expect_refused(sim({"--set", "vehicle"}), 2, "SECTION.KEY=VALUE");
  expect_refused(sim({"--seed", "-1"}), 2, "seed");
  expect_refused(sim({}, "groomer_clear", "x"), 2, "seconds");
  expect_refused(sim({}, (folder_ / "none.yaml").string()), 1, "none.yaml");
}

TEST_F(SimCommandTest, ZeroSecondsAreRefusedZeroSpeedIsNot) {
  for (const char* seconds : {"0", "0.05", "-1", "nan"}) {
    SCOPED_TRACE(seconds);
    expect_refused(sim({}, "groomer_clear", seconds), 2, "seconds");
  }
  EXPECT_EQ(sim({"-q", "--set", "vehicle.speed_m_per_s=0"}).exit_code, 0);
}

TEST_F(SimCommandTest, AWayThatEndsTooEarlySaysWhen) {
  expect_refused(sim({}, "groomer_clear", "500"), 2, "ask for at most");
  expect_refused(sim({"--set", "vehicle.start_m=5000"}), 2, "the route of 80 m ends");
}

TEST_F(SimCommandTest, ASensorInTheGroundIsRefused) {
  expect_refused(sim({"--set", "mount.height_m=0"}), 2, "sensor: ");
}

TEST_F(SimCommandTest, BrokenElevationModelsAreRefused) {
  write_model("nodata.asc", 20, 20, "-9999");
  expect_refused(sim(with_model("nodata.asc")), 1, "all of its 20 x 20 cells are NODATA");
  spill(folder_ / "lying.asc", "ncols 9000\nnrows 9000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n");
  expect_refused(sim(with_model("lying.asc")), 1, "9000 x 9000 heights take at least");
  spill(folder_ / "huge.asc", "ncols 100000\nnrows 10000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n");
  expect_refused(sim(with_model("huge.asc")), 1, "are more than the 100000000 that are read");
  spill(folder_ / "text.asc", "hello\n");
  expect_refused(sim(with_model("text.asc")), 1, "no key of an ESRI ASCII grid");
  expect_refused(sim(with_model("none.asc")), 1, "none.asc");
}

TEST_F(SimCommandTest, ARouteThatLeavesTheModelIsRefused) {
  write_model("small.asc", 30, 30, "5");
  expect_refused(sim(with_model("small.asc")), 2, "route");
}

TEST_F(SimCommandTest, AnInterruptEndsItCleanly) {
  test::Program program({"sim", "groomer_clear", "-o", out_.string(), "--seconds", "60"});
  for (int tries = 0; tries < 4000 && !fs::exists(out_ / "scans/000001.pcd"); ++tries) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  program.send(SIGINT);
  const ProgramResult result = program.wait();
  EXPECT_EQ(result.exit_code, 128 + SIGINT) << result.err;
  EXPECT_THAT(result.err, HasSubstr("stopped by a signal after"));
  EXPECT_FALSE(fs::exists(out_ / "sequence.json"));
  EXPECT_TRUE(fs::exists(out_ / ".berm-unfinished"));
}

}  // namespace
}  // namespace berm
