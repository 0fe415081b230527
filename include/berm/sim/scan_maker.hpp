#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/sim/ray_caster.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/weather.hpp"

namespace berm::sim {

/// Memory that making a scan needs on the way; its owner hands it from scan to scan.
class ScanScratch {
 public:
  ScanScratch();
  ~ScanScratch();
  ScanScratch(ScanScratch&&) noexcept;
  ScanScratch& operator=(ScanScratch&&) noexcept;

 private:
  friend class ScanMaker;
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

/// A scan as the sensor would give it, and what each of its points truly is.
struct MadeScan {
  Stamp stamp_ns = 0;
  PointChannels points;               ///< x y z intensity time, ring where the sensor has rings
  std::vector<std::uint32_t> labels;  ///< SemanticKITTI ids; number of a mover (from 1) in the upper 16 bits
  std::size_t beams = 0;
  ScanScratch scratch;  ///< no part of the result
};

struct Return;

/// Fires the beams of a sensor into a world: mixed and double echoes, porous crowns and nets, grazing and dark
/// surfaces, snowfall, dust, noise, motion within the scan.
class ScanMaker {
 public:
  /// `caster`, `weather` and `T_world_base` are kept by reference and have to outlive this. Throws ConfigError as
  /// `Sensor::check`.
  ScanMaker(const Sensor& sensor, const Pose& T_base_sensor, const RayCaster& caster, const Weather& weather,
            const Trajectory& T_world_base, std::uint64_t seed);

  /// Throws Error(invalid_argument) if the sensor stands below the terrain or inside of something when the trajectory
  /// begins, and says what to change. For the recorder to call before the first scan.
  void check_start(const Terrain& terrain) const;

  /// Makes scan `index`; the same bytes whenever and wherever. Thread-safe as long as every thread has its own `scan`,
  /// which keeps its memory. Throws Error(invalid_argument) if the trajectory does not last until the end of the scan.
  void make(std::size_t index, MadeScan& scan) const;

 private:
  struct Place;
  /// The rays of the middles of all beams; where the sensor is as the scan begins.
  Place aim(std::size_t index, Stamp stamp_ns, ScanScratch::Memory& memory) const;
  void cast(const Place& place, ScanScratch::Memory& memory) const;
  void write(double height_m, ScanScratch::Memory& memory, MadeScan& scan) const;
  /// False: the sensor leaves out beams without echo.
  bool write_point(const Return& got, const Beams& beams, std::size_t beam, std::size_t at, MadeScan& scan) const;

  Sensor sensor_;
  BeamPattern pattern_;
  Pose T_base_sensor_;
  const RayCaster& caster_;
  const Weather& weather_;
  const Trajectory& T_world_base_;
  std::uint64_t seed_;
};

}  // namespace berm::sim
