#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "berm/core/error.hpp"
#include "berm/io/height_raster.hpp"
#include "berm/io/surface_folder.hpp"
#include "berm/io/terrain_model.hpp"
#include "berm/sim/scenario.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/simulate.hpp"
#include "groomer_scan.hpp"
#include "support/file_error.hpp"
#include "truck_run.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;

class RunSurfaceTest : public test::TruckRunTest {
 protected:
  void SetUp() override {
    TruckRunTest::SetUp();
    machine_.mapping.surface = true;
    machine_.mapping.tile_m = 10.0;
    machine_.mapping.max_range_m = 20.0;
    machine_.mapping.keep_m = 21.0;
  }

  [[nodiscard]] SurfaceFolder surface() const { return SurfaceFolder::open(out_ / "map"); }
};

TEST_F(RunSurfaceTest, WritesTilesTheCloudAndTheElevation) {
  put_poses(drive_.poses());
  const RunSummary summary = run_it();
  const json report = this->report();
  EXPECT_EQ(report["files"]["surface"], "map/tiles.json");
  EXPECT_EQ(report["files"]["map"], "map.pcd");
  EXPECT_TRUE(report["files"].contains("elevation"));
  EXPECT_TRUE(fs::exists(out_ / report["files"]["elevation"].get<std::string>()));
  const json& figures = report["surface"];
  EXPECT_EQ(figures["scans_mapped"], kScans);
  EXPECT_EQ(figures["voxels"], surface().points());
  EXPECT_EQ(figures["tiles"], surface().index().tiles.size());
  EXPECT_GT(figures["voxels"], 5000);
  EXPECT_GT(figures["elevation_cells"], 500);
  EXPECT_FALSE(figures.contains("snow_depth"));
  EXPECT_GT(report["stages"]["surface"]["max_ms"], 0.0);
  EXPECT_EQ(summary.surface->voxels, surface().points());
  // The road is level at 0.
  std::vector<double> heights_m;
  const SurfaceFolder map = surface();
  for (const auto& [key, entry] : map.index().tiles) {
    for (const SurfacePoint& point : surface().load(key)) {
      const Eigen::Vector3d place_m(point.x_m, point.y_m, point.z_m);
      if (point.label != Label::obstacle && std::abs(drive_.offset_m(place_m)) < 5.0) {
        heights_m.push_back(std::abs(place_m.z()));
      }
    }
  }
  ASSERT_GT(heights_m.size(), 1000U);
  std::nth_element(heights_m.begin(), heights_m.begin() + static_cast<std::ptrdiff_t>(heights_m.size() / 2),
                   heights_m.end());
  EXPECT_LT(heights_m[heights_m.size() / 2], 0.05);
}

TEST_F(RunSurfaceTest, AnyNumberOfThreadsGivesTheSameBytes) {
  put_poses(drive_.poses());
  static_cast<void>(run_it());
  const fs::path other = folder_ / "threads";
  static_cast<void>(run_it({.output = other, .threads = 5}));
  std::size_t files = 0;
  for (const auto& entry : fs::directory_iterator(out_ / "map")) {
    const std::string name = entry.path().filename().string();
    EXPECT_TRUE(test::slurp(entry.path()) == test::slurp(other / "map" / name)) << name;
    ++files;
  }
  EXPECT_GT(files, 4U);
  for (const auto& name : {std::string("map.pcd"), report()["files"]["elevation"].get<std::string>()}) {
    EXPECT_TRUE(test::slurp(out_ / name) == test::slurp(other / name)) << name;
  }
}

TEST_F(RunSurfaceTest, TilesAreOnTheDiskWhileTheRunGoesOn) {
  put_poses(drive_.poses());
  bool seen = false;
  static_cast<void>(run_it({.output = out_, .on_progress = [&](std::size_t, std::size_t) {
                              if (fs::exists(out_ / "map" / SurfaceFolder::kIndex)) {
                                const SurfaceFolder map = SurfaceFolder::open(out_ / "map");
                                for (const auto& [key, entry] : map.index().tiles) {
                                  seen = !map.load(key).empty() || seen;
                                }
                              }
                            }}));
  EXPECT_TRUE(seen);
}

TEST_F(RunSurfaceTest, WithoutPosesOrTheSwitchThereIsNone) {
  static_cast<void>(run_it());
  EXPECT_THAT(report()["notes"].dump(), HasSubstr("no map of the surface was written, since there are no poses"));
  EXPECT_FALSE(fs::exists(out_ / "map"));
  put_poses(drive_.poses());
  static_cast<void>(run_it({.output = out_, .force = true}));
  EXPECT_TRUE(fs::exists(out_ / "map"));
  machine_.mapping.surface = false;
  static_cast<void>(run_it({.output = out_, .force = true}));
  for (const char* name : {"map", "map.pcd", "elevation.tif", "elevation.asc"}) {
    EXPECT_FALSE(fs::exists(out_ / name)) << name << " is of the earlier run";
  }
  EXPECT_FALSE(report().contains("surface"));
}

TEST_F(RunSurfaceTest, CoordinatesOfAProjectionLoseNothing) {
  machine_.datum.origin = "none";
  drive_.origin_m = {676'123.4, 5'234'567.8, 2100.0};
  put_poses(drive_.poses());
  static_cast<void>(run_it());
  EXPECT_EQ(surface().index().frame.origin_m, Eigen::Vector3d(676'000.0, 5'235'000.0, 2000.0));
  EXPECT_EQ(report()["surface"]["origin_m"], json({676'000.0, 5'235'000.0, 2000.0}));
  const HeightRaster elevation = read_height_raster(out_ / report()["files"]["elevation"].get<std::string>());
  EXPECT_NEAR(elevation.origin_x_m, drive_.origin_m.x(), 100.0);
  EXPECT_TRUE(std::any_of(elevation.heights_m.begin(), elevation.heights_m.end(),
                          [](float height_m) { return std::abs(height_m - 2100.0F) < 0.1F; }));
}

TEST_F(RunSurfaceTest, ATerrainModelThatCannotBeReadIsFoundOutBeforeTheRun) {
  put_poses(drive_.poses());
  EXPECT_THROW(static_cast<void>(run_it({.output = out_, .terrain = folder_ / "none.asc"})), FileError);
  EXPECT_FALSE(fs::exists(out_));
  HeightRaster elsewhere{.origin_x_m = 1e6, .origin_y_m = 1e6, .cell_m = 1.0, .columns = 2, .rows = 2};
  elsewhere.heights_m.assign(4, 1.0F);
  write_ascii_grid(folder_ / "elsewhere.asc", elsewhere);
  static_cast<void>(run_it({.output = out_, .terrain = folder_ / "elsewhere.asc"}));
  EXPECT_THAT(report()["notes"].dump(), HasSubstr("does not lie under the map"));
}

/// Depth of the snow that is put between the simulated surface and a made summer terrain.
double made_depth_m(double x_m, double y_m) {
  return 1.5 + 0.8 * std::sin(0.15 * x_m) * std::cos(0.11 * y_m);
}

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

TEST(RunSnowDepthTest, IsThatOfASimulatedPiste) {
  const test::TempFolder folder;
  sim::Scenario scenario = sim::read_scenario(fs::path(BERM_SCENARIOS) / "groomer_snowfall.yaml");
  scenario.scenario.seconds = 8.0;
  sim::SimulateOptions simulation;
  simulation.output = folder / "recording";
  simulation.seed = 21;
  static_cast<void>(sim::simulate(scenario, sim::read_sensor(fs::path(BERM_SENSORS) / "livox_mid70.yaml"), simulation));
  HeightRaster summer = read_height_raster(folder / "recording/terrain.asc");
  for (std::size_t row = 0; row < summer.rows; ++row) {
    for (std::size_t column = 0; column < summer.columns; ++column) {
      const double x_m = summer.origin_x_m + summer.cell_m * (static_cast<double>(column) + 0.5);
      const double y_m = summer.origin_y_m + summer.cell_m * (static_cast<double>(row) + 0.5);
      summer.heights_m[row * summer.columns + column] -= static_cast<float>(made_depth_m(x_m, y_m));
    }
  }
  write_ascii_grid(folder / "summer.asc", summer);

  Machine machine = test::groomer();
  machine.mapping.surface = true;
  machine.mapping.terrain = (folder / "summer.asc").string();
  const fs::path out = folder / "out";
  const RunSummary summary = run(Recording::open(folder / "recording"), machine, {.output = out, .threads = 2});
  ASSERT_TRUE(summary.surface.has_value());
  EXPECT_GT(summary.surface->depth_cells, 2000U);
  EXPECT_NEAR(summary.surface->median_depth_m.value_or(0.0), 1.5, 0.8);

  const fs::path depths = out / "elevation_depth.asc";
  if (!fs::exists(depths)) {
    const std::string command = "gdal_translate -q -b 5 -of AAIGrid '" + (out / "elevation.tif").string() + "' '" +
                                depths.string() + "' 2>/dev/null";
    if (std::system(command.c_str()) != 0) {  // NOLINT(cert-env33-c,concurrency-mt-unsafe): a tool of GDAL
      GTEST_SKIP() << "there is no gdal_translate";
    }
  }
  const HeightRaster depth = read_height_raster(depths);
  std::vector<double> errors_m;
  for (std::size_t row = 0; row < depth.rows; ++row) {
    for (std::size_t column = 0; column < depth.columns; ++column) {
      const double x_m = depth.origin_x_m + depth.cell_m * (static_cast<double>(column) + 0.5);
      const double y_m = depth.origin_y_m + depth.cell_m * (static_cast<double>(row) + 0.5);
      if (!std::isnan(depth.at(column, row))) {
        errors_m.push_back(std::abs(double{depth.at(column, row)} - made_depth_m(x_m, y_m)));
      }
    }
  }
  ASSERT_EQ(errors_m.size(), summary.surface->depth_cells);
  RecordProperty("median_error_mm", static_cast<int>(1e3 * median(errors_m)));
  EXPECT_LT(median(errors_m), 0.05);
}

}  // namespace
}  // namespace berm
