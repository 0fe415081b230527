#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "berm/sim/scenario.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/world.hpp"

namespace berm::sim {

struct SimulateOptions {
  std::filesystem::path output;
  bool force = false;       ///< replace a made recording in `output`
  std::uint64_t seed = 1;   ///< of everything that is left to chance
  std::size_t threads = 1;  ///< scans that are made at a time; the files do not depend on it

  /// Called on the calling thread with what begins: "building the world".
  std::function<void(const std::string&)> on_stage;
  /// Called on the calling thread after every scan with the number of scans done and their total.
  std::function<void(std::size_t, std::size_t)> on_progress;
  /// Asked after every scan; true ends the work early.
  std::function<bool()> should_stop;
};

struct SimulateSummary {
  std::size_t scans = 0;
  std::size_t selected = 0;  ///< scans that were asked for
  std::uint64_t beams = 0;
  std::uint64_t returns = 0;     ///< beams that came back, off anything
  std::uint64_t in_the_air = 0;  ///< those off flakes and dust
  double driven_m = 0.0;
  bool interrupted = false;  ///< `should_stop` ended it: sequence.json was not written
};

/// The world of a scenario, cut into its elevation model if it names one; throws as `simulate` does.
[[nodiscard]] World build_world(const Scenario& scenario, std::uint64_t seed);

/// Makes a recording of a scenario with `sensor` and writes its sequence folder (docs/formats.md): scans and their true
/// labels, times, poses of the GNSS/INS and true ones, true edges, the true terrain around the way, the scenario and
/// the sensor as they were used, and sequence.json last. Same scenario, sensor and seed, same bytes.
///
/// Throws ConfigError for settings that cannot be used, among them a scenario.seconds that leaves no scan;
/// Error(invalid_argument) if the route cannot be laid, or ends before the time does, or the sensor starts inside of
/// something; FileError for the elevation model and the output.
[[nodiscard]] SimulateSummary simulate(const Scenario& scenario, const Sensor& sensor, const SimulateOptions& options);

}  // namespace berm::sim
