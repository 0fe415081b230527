#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "support/simulated_run.hpp"

namespace berm::bench {

struct PisteRun {
  test::RunPlan plan;
  std::string flakes;  ///< class of the snowfall; empty: clear air
};

struct RunChoice {
  std::uint64_t seed_offset = 0;                      ///< added to the seed of every run
  bool quick = false;                                 ///< four runs of 3 s
  std::optional<std::filesystem::path> alpine_dem{};  ///< elevation models; none: runs on made terrain alone
};

/// The groomer's runs that the accuracy is measured on.
[[nodiscard]] std::vector<PisteRun> piste_runs(const RunChoice& choice);

/// Some of them with `sensor` on the groomer, 3 s each.
[[nodiscard]] std::vector<PisteRun> runs_with_sensor(const std::string& sensor, std::uint64_t seed_offset);

}  // namespace berm::bench
