#include <filesystem>
#include <memory>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "berm/eval/trajectory_metrics.hpp"
#include "berm/io/recording.hpp"
#include "berm/io/trajectory_file.hpp"
#include "berm/pipeline/machine.hpp"
#include "berm/pipeline/run.hpp"
#include "berm/sim/scenario.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/simulate.hpp"
#include "support/temp_folder.hpp"
#include "truck_recording.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

/// Runs over a simulated haul road, 4 s, with fixes and truth. It is made once for all tests.
class RunOdometryTest : public testing::Test {
 protected:
  static constexpr std::size_t kScans = 40;

  static void SetUpTestSuite() {
    made_ = std::make_unique<test::TempFolder>();
    sim::Scenario scenario = sim::read_scenario(fs::path(BERM_SCENARIOS) / "haul_road.yaml");
    scenario.scenario.seconds = 4.0;
    sim::SimulateOptions options;
    options.output = *made_ / "road";
    options.seed = 5;
    static_cast<void>(sim::simulate(scenario, sim::read_sensor(fs::path(BERM_SENSORS) / "vlp16.yaml"), options));
    fs::copy(*made_ / "road", *made_ / "no_fixes", fs::copy_options::recursive);
    fs::remove(*made_ / "no_fixes/gnss.tum");
  }
  static void TearDownTestSuite() { made_.reset(); }

  void SetUp() override { machine_.methods.odometry = "default"; }

  [[nodiscard]] RunSummary run_over(const std::string& name, RunOptions options = {}) const {
    options.output = options.output.empty() ? out_ : options.output;
    return run(Recording::open(*made_ / name), machine_, options);
  }
  [[nodiscard]] json report() const { return json::parse(test::slurp(out_ / "run.json")); }

  static inline std::unique_ptr<test::TempFolder> made_;
  test::TempFolder folder_;
  fs::path out_ = folder_ / "out";
  Machine machine_ = test::haul_truck();
};

TEST_F(RunOdometryTest, FollowsTheTruckWithoutFixesAndMapsWithItsOwnPoses) {
  const RunSummary summary = run_over("no_fixes");
  const auto truth = Recording::open(*made_ / "no_fixes").read_truth_poses();
  const Trajectory driven = read_tum(out_ / "trajectory.tum");
  EXPECT_EQ(driven.size(), kScans);
  EXPECT_LT(absolute_error_m(pair_poses(driven, *truth)).value_or(9.0), 0.10);
  ASSERT_TRUE(summary.odometry.has_value());
  EXPECT_EQ(summary.odometry->scans, kScans);
  EXPECT_EQ(summary.odometry->sessions, 1U);
  ASSERT_TRUE(summary.edges.has_value());
  EXPECT_TRUE(summary.edges->has_map);
  EXPECT_EQ(summary.edges->mapped, kScans);
  EXPECT_TRUE(fs::exists(out_ / "edges.ot"));
  EXPECT_TRUE(fs::exists(out_ / "road.csv"));
  EXPECT_FALSE(fs::exists(out_ / "trajectory_global.tum")) << "nothing says where on the earth it is";
  EXPECT_EQ(report()["odometry"]["scans"], kScans);
  EXPECT_EQ(report()["files"]["odometry"], "odometry.csv");
  EXPECT_THAT(test::slurp(out_ / "odometry.csv"), HasSubstr("scan,stamp,health,session"));
}

TEST_F(RunOdometryTest, JoinsFixesIntoATrajectoryInTheirWorld) {
  static_cast<void>(run_over("road"));
  const auto truth = Recording::open(*made_ / "road").read_truth_poses();
  const Trajectory global = read_tum(out_ / "trajectory_global.tum");
  ASSERT_EQ(global.size(), kScans);
  for (const PosePair& pair : pair_poses(global, *truth)) {
    EXPECT_LT((pair.estimate.translation_m() - pair.truth.translation_m()).norm(), 0.10);
  }
  const Trajectory odometric = read_tum(out_ / "trajectory.tum");
  EXPECT_LT(odometric.poses().front().T_world_base.translation_m().norm(), 1e-6) << "begins at the first scan";
}

TEST_F(RunOdometryTest, AnyNumberOfThreadsGivesTheSameBytes) {
  machine_.mapping.surface = true;
  static_cast<void>(run_over("no_fixes"));
  const fs::path other = folder_ / "threads";
  static_cast<void>(run_over("no_fixes", {.output = other, .threads = 3}));
  for (const char* name : {"trajectory.tum", "odometry.csv", "edges.ot", "edges.csv", "road.csv", "map.pcd"}) {
    EXPECT_TRUE(test::slurp(out_ / name) == test::slurp(other / name)) << name;
  }
}

TEST_F(RunOdometryTest, ThePublishedMethodCanBeChosen) {
  machine_.methods.odometry = "reference";
  machine_.methods.edge = "none";
  const RunSummary summary = run_over("no_fixes", {.count = 10});
  EXPECT_EQ(summary.odometry->scans, 10U);
  EXPECT_GT(summary.odometry->path_m, 1.0);
}

}  // namespace
}  // namespace berm
