#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "berm/core/scan.hpp"
#include "berm/core/trajectory.hpp"

namespace berm::test {

/// A recording that the simulator is to make.
struct RunPlan {
  std::string name;
  std::string scenario;               ///< scenarios/NAME.yaml
  std::vector<std::string> settings;  ///< other values for keys of the scenario: "section.key=value"
  std::uint64_t seed = 1;
  double seconds = 10.0;
  std::string sensor = "livox_mid70";  ///< sensors/NAME.yaml
};

struct LabelledScan {
  Scan scan;
  std::vector<std::uint32_t> truth;  ///< raw labels as on disk
};

struct SimulatedRun {
  std::vector<LabelledScan> scans;
  Trajectory truth;  ///< T_world_base
  // Of the machine, nose up: from its true poses.
  double min_slope_deg = 0.0;
  double max_slope_deg = 0.0;
};

/// Where the simulator finds its settings.
struct SimulatorFolders {
  std::filesystem::path scenarios;
  std::filesystem::path sensors;
};

/// Makes the run in a folder of its own, reads it back and removes the folder. Throws as `sim::simulate`.
[[nodiscard]] SimulatedRun simulate_run(const RunPlan& plan, const SimulatorFolders& folders);

}  // namespace berm::test
