#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "berm/io/recording.hpp"
#include "berm/odometry/odometry.hpp"
#include "berm/pipeline/machine.hpp"
#include "berm/pipeline/run.hpp"
#include "berm/sim/scenario.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/simulate.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kScansOfEach = 60;

void drive_a_piste(const fs::path& folder, std::uint64_t seed) {
  sim::Scenario scenario = sim::read_scenario(fs::path(BERM_SCENARIOS) / "groomer_clear.yaml");
  scenario.scenario.seconds = 0.1 * kScansOfEach;
  sim::SimulateOptions options;
  options.output = folder;
  options.seed = seed;
  static_cast<void>(sim::simulate(scenario, sim::read_sensor(fs::path(BERM_SENSORS) / "livox_mid70.yaml"), options));
}

/// The scans of both drives one after the other, 10 a second, and nothing else that was recorded.
void join(const fs::path& first, const fs::path& second, const fs::path& joined) {
  fs::create_directories(joined / "scans");
  fs::copy(first / "sequence.json", joined / "sequence.json");
  std::ofstream times(joined / "times.txt");
  for (std::size_t i = 0; i < 2 * kScansOfEach; ++i) {
    const fs::path& from = i < kScansOfEach ? first : second;
    fs::copy(from / "scans" / fmt::format("{:06}.pcd", i % kScansOfEach),
             joined / "scans" / fmt::format("{:06}.pcd", i));
    times << fmt::format("{:.9f}\n", 0.1 * static_cast<double>(i));
  }
}

/// Set down on another piste between two scans: said to be lost, a map of its own begun, nothing of the second piste
/// put into the map of the first.
TEST(RunKidnappedTest, IsLostAndBeginsAnewAndTheMapStaysClean) {
  const test::TempFolder made;
  drive_a_piste(made / "first", 101);
  drive_a_piste(made / "second", 104);
  join(made / "first", made / "second", made / "joined");
  Machine machine = read_machine(fs::path(BERM_MACHINES_FOLDER) / "groomer.yaml");
  machine.mapping.surface = true;
  const auto run_of = [&](const std::string& name) {
    return run(Recording::open(made / name), machine, {.output = made / (name + "_out")});
  };
  fs::remove(made / "first/gnss.tum");
  const RunSummary alone = run_of("first");
  const RunSummary joined = run_of("joined");
  ASSERT_TRUE(joined.odometry.has_value());
  constexpr auto kLost = static_cast<std::size_t>(OdometryHealth::lost);
  EXPECT_EQ(alone.odometry->health[kLost], 0U);
  EXPECT_GE(joined.odometry->health[kLost], 20U);
  EXPECT_EQ(joined.odometry->sessions, 2U);
  ASSERT_TRUE(alone.surface.has_value());
  ASSERT_TRUE(joined.surface.has_value());
  EXPECT_EQ(joined.surface->mapped, alone.surface->mapped);
  EXPECT_EQ(joined.surface->voxels, alone.surface->voxels);
}

}  // namespace
}  // namespace berm
