#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/simulated_run.hpp"

namespace berm::bench {

struct OdometryRun {
  test::RunPlan plan;
  std::string machine;   ///< machines/NAME.yaml, whose stages make the labels
  bool is_bare = false;  ///< nothing stands there: the odometry has to say that it is weak
};

/// Drives of 50 m and more: pistes from flat to 34 degrees in clear air and snowfall, with little and with much beside
/// them, one driven fast, one with stops, a bare slope, mine roads and a flat road; another seed each.
[[nodiscard]] std::vector<OdometryRun> odometry_runs(std::uint64_t seed_offset);

}  // namespace berm::bench
