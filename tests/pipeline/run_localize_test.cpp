#include <filesystem>
#include <fstream>
#include <memory>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "berm/eval/evaluate.hpp"
#include "berm/io/recording.hpp"
#include "berm/io/surface_folder.hpp"
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

/// A map of a simulated haul road, and a second, faster drive along it without fixes; both are made once for all tests.
class RunLocalizeTest : public testing::Test {
 protected:
  static constexpr std::size_t kScans = 30;

  static void SetUpTestSuite() {
    made_ = std::make_unique<test::TempFolder>();
    drive("mapped", 6.0, 4.0, 5);
    drive("again", 8.0, 3.0, 5);
    fs::remove(*made_ / "again/gnss.tum");
    Machine machine = truck();
    machine.methods.odometry = "none";
    machine.mapping.surface = true;
    static_cast<void>(run(Recording::open(*made_ / "mapped"), machine,
                          {.output = *made_ / "map", .poses = *made_ / "mapped/truth.tum"}));
  }
  static void TearDownTestSuite() { made_.reset(); }

  static void drive(const std::string& name, double speed_mps, double seconds, std::uint64_t seed) {
    sim::Scenario scenario = sim::read_scenario(fs::path(BERM_SCENARIOS) / "haul_road.yaml");
    scenario.scenario.seconds = seconds;
    scenario.vehicle.speed_m_per_s = speed_mps;
    sim::SimulateOptions options;
    options.output = *made_ / name;
    options.seed = seed;
    static_cast<void>(sim::simulate(scenario, sim::read_sensor(fs::path(BERM_SENSORS) / "vlp16.yaml"), options));
  }
  static Machine truck() {
    Machine machine = test::haul_truck();
    machine.methods.edge = "none";
    machine.methods.odometry = "default";
    return machine;
  }

  /// The pose of the second drive at its first scan, moved and turned.
  [[nodiscard]] static Pose start(double forward_m, double left_m, double turn_deg) {
    const auto truth = Recording::open(*made_ / "again").read_truth_poses();
    return truth->poses().front().T_world_base *
           Pose::from_yaw_pitch_roll(turn_deg * std::numbers::pi / 180.0, 0.0, 0.0, {forward_m, left_m, 0.0});
  }
  [[nodiscard]] RunSummary localize(const std::string& name, RunOptions options) const {
    options.output = options.output.empty() ? out_ : options.output;
    options.localize = options.localize.empty() ? *made_ / "map" : options.localize;
    return run(Recording::open(*made_ / name), machine_, options);
  }
  /// A copy of the map that may be broken.
  [[nodiscard]] fs::path own_map() const {
    const fs::path copy = folder_ / "own";
    fs::copy(*made_ / "map/map", copy, fs::copy_options::recursive);
    return copy;
  }
  /// The tile nearest to the start.
  [[nodiscard]] static fs::path first_tile(const fs::path& map) {
    const SurfaceFolder folder = SurfaceFolder::open(map);
    const Eigen::Vector3d place_m = start(0.0, 0.0, 0.0).translation_m() - folder.index().frame.origin_m;
    const double tile_m = folder.index().frame.tile_m;
    const TileKey key{static_cast<std::int32_t>(std::floor(place_m.x() / tile_m)),
                      static_cast<std::int32_t>(std::floor(place_m.y() / tile_m))};
    return map / folder.index().tiles.at(key).file;
  }
  [[nodiscard]] std::string refusal(RunOptions options) const {
    try {
      static_cast<void>(localize("again", std::move(options)));
    } catch (const Error& error) {
      EXPECT_FALSE(fs::exists(out_)) << "found out before the first scan";
      return error.what();
    }
    return "";
  }

  static inline std::unique_ptr<test::TempFolder> made_;
  test::TempFolder folder_;
  fs::path out_ = folder_ / "out";
  Machine machine_ = truck();
};

TEST_F(RunLocalizeTest, FindsAnotherDriveInTheMap) {
  const RunSummary summary = localize("again", {.start = start(1.2, -1.0, 7.0)});
  ASSERT_TRUE(summary.localization.has_value());
  EXPECT_EQ(summary.localization->scans, kScans);
  EXPECT_GT(summary.localization->located, kScans / 2);
  EXPECT_EQ(read_tum(out_ / "trajectory_map.tum").size(), summary.localization->located);
  EXPECT_THAT(test::slurp(out_ / "localization.csv"), HasSubstr("scan,stamp,health,ground_fit"));
  const json report = json::parse(test::slurp(out_ / "run.json"));
  EXPECT_EQ(report["localization"]["located"], summary.localization->located);
  EXPECT_EQ(report["files"]["trajectory_map"], "trajectory_map.tum");
  EXPECT_GT(report["stages"]["localize"]["max_ms"], 0.0);

  const Evaluation evaluation = evaluate(out_, Recording::open(*made_ / "again"));
  ASSERT_TRUE(evaluation.localization.has_value());
  EXPECT_EQ(evaluation.localization->poses, summary.localization->located);
  EXPECT_LT(evaluation.localization->max_m, 0.3);
  EXPECT_LT(evaluation.localization->rmse_m, 0.1);
  EXPECT_LT(evaluation.localization->max_deg, 1.0);
}

TEST_F(RunLocalizeTest, AnyNumberOfThreadsGivesTheSameBytes) {
  static_cast<void>(localize("again", {.count = 20, .start = start(0.5, 0.5, 0.0)}));
  const fs::path other = folder_ / "threads";
  static_cast<void>(localize("again", {.output = other, .threads = 3, .count = 20, .start = start(0.5, 0.5, 0.0)}));
  for (const char* name : {"trajectory_map.tum", "localization.csv", "trajectory.tum"}) {
    EXPECT_TRUE(test::slurp(out_ / name) == test::slurp(other / name)) << name;
  }
}

TEST_F(RunLocalizeTest, TheMapOfAnotherRoadIsNeverTakenForThisOne) {
  drive("elsewhere", 8.0, 3.0, 6);
  fs::remove(*made_ / "elsewhere/gnss.tum");
  const RunSummary summary = localize("elsewhere", {.start = start(0.0, 0.0, 0.0)});
  EXPECT_EQ(summary.localization->located, 0U);
  EXPECT_FALSE(fs::exists(out_ / "trajectory_map.tum"));
  EXPECT_THAT(summary.notes, testing::Contains(HasSubstr("was never located in")));
}

TEST_F(RunLocalizeTest, SaysBeforeTheFirstScanWhatIsMissing) {
  EXPECT_THAT(refusal({}), HasSubstr("--start X,Y,YAW"));
  EXPECT_THAT(refusal({.localize = folder_ / "none", .start = start(0, 0, 0)}), HasSubstr("holds no map of a surface"));
  EXPECT_THAT(refusal({.start = Pose(Eigen::Quaterniond::Identity(), {4000.0, 0.0, 0.0})}),
              HasSubstr("no ground near"));
  machine_.methods.odometry = "none";
  EXPECT_THAT(refusal({.start = start(0, 0, 0)}), HasSubstr("--method odometry=default"));
}

TEST_F(RunLocalizeTest, RefusesABrokenMapBeforeTheFirstScan) {
  const fs::path map = own_map();
  const fs::path tile = first_tile(map);
  const std::string whole = test::slurp(tile);

  test::spill(tile, whole.substr(0, whole.size() / 3));
  EXPECT_THAT(refusal({.localize = map, .start = start(0, 0, 0)}), HasSubstr("too few for its"));
  std::string bent = whole;
  bent.replace(whole.find("DATA binary") + 12, 4, "\xff\xff\xff\xff");
  test::spill(tile, bent);
  EXPECT_THAT(refusal({.localize = map, .start = start(0, 0, 0)}), HasSubstr(tile.filename().string()));
  fs::remove(tile);
  EXPECT_THAT(refusal({.localize = map, .start = start(0, 0, 0)}), HasSubstr("is named in tiles.json"));
  test::spill(map / "tiles.json", "{\"schema\": \"berm.surface/1\"");
  EXPECT_THAT(refusal({.localize = map, .start = start(0, 0, 0)}), HasSubstr("tiles.json"));
}

TEST_F(RunLocalizeTest, RefusesAMapThatIsTooCoarse) {
  const fs::path map = own_map();
  json index = json::parse(test::slurp(map / "tiles.json"));
  index["voxel_m"] = 0.8;
  test::spill(map / "tiles.json", index.dump());
  EXPECT_THAT(refusal({.localize = map, .start = start(0, 0, 0)}), HasSubstr("too coarse"));
}

TEST_F(RunLocalizeTest, LeavesOutATileThatTurnsOutToBeBrokenAndSaysSo) {
  const fs::path map = own_map();
  const fs::path near = first_tile(map);
  // All but the tile of the start and those that are read with it.
  machine_.localize.reach_m = 20.0;
  const SurfaceFolder folder = SurfaceFolder::open(map);
  const Eigen::Vector3d place_m = start(0.0, 0.0, 0.0).translation_m() - folder.index().frame.origin_m;
  for (const auto& [key, entry] : folder.index().tiles) {
    const Eigen::Vector2d middle_m(folder.index().frame.tile_m * (key.x + 0.5),
                                   folder.index().frame.tile_m * (key.y + 0.5));
    if ((middle_m - place_m.head<2>()).norm() > 45.0) {
      std::string bytes = test::slurp(map / entry.file);
      bytes.replace(bytes.find("DATA binary") + 12, 4, "\xff\xff\xff\xff");
      test::spill(map / entry.file, bytes);
    }
  }
  const RunSummary summary = localize("again", {.localize = map, .start = start(0.0, 0.0, 0.0)});
  EXPECT_GT(summary.localization->broken_tiles, 0U);
  EXPECT_THAT(summary.notes, testing::Contains(HasSubstr("a tile of the map was left out")));
}

}  // namespace
}  // namespace berm
