#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "berm/io/output_folder.hpp"
#include "berm/sim/scan_maker.hpp"
#include "berm/sim/scenario.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/world.hpp"

namespace berm::sim {

/// What a made recording consists of.
[[nodiscard]] OutputResults recording_results();

/// Writes the files of a made recording into its folder. Scans may be written from any thread.
class RecordingWriter {
 public:
  explicit RecordingWriter(const OutputFolder& folder) : folder_(folder) {}

  /// scans/NNNNNN.pcd and labels/NNNNNN.label.
  void write_scan(std::size_t index, const MadeScan& scan) const;
  void write_poses(const Trajectory& truth, const Trajectory& measured) const;
  void write_scan_times(std::span<const Stamp> stamps) const;
  /// edges.csv, and terrain.asc around the way that was driven.
  void write_world(const World& world, const Trajectory& driven) const;
  /// The settings as they were used, and sequence.json.
  void write_settings(const Scenario& scenario, const Sensor& sensor, std::uint64_t seed, const World& world) const;

 private:
  const OutputFolder& folder_;
};

}  // namespace berm::sim
