#pragma once

#include <cstdint>
#include <vector>

#include "berm/core/config.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/sim/world.hpp"

namespace berm::sim {

/// How the machine drives and shakes.
struct VehicleConfig {
  double speed_m_per_s = 1.5;
  double speed_change = 0.2;      ///< share by which the speed wanders
  double stop_every_s = 0.0;      ///< mean time between stops; 0: none
  double stop_s = 3.0;            ///< how long it stands
  double turn_on_spot_deg = 0.0;  ///< turned there and back during the first stop
  double length_m = 4.5;          ///< of the tracks or the wheelbase
  double width_m = 3.0;           ///< between the middles of the tracks
  double heave_m = 0.015;         ///< standard deviation, at about 1 Hz
  double pitch_deg = 0.4;         ///< the same of the pitch
  double roll_deg = 0.3;          ///< the same of the roll
  double hum_m = 0.001;           ///< high-frequency vibration, about 17 Hz
  double wander_m = 0.3;          ///< how far it strays from the middle of the route
  double start_m = 10.0;          ///< where on the route it begins

  static void fields(auto&& field);
  void check() const { check_fields(*this, "vehicle"); }
};

struct GnssConfig {
  double rate_hz = 100.0;  ///< 0: no GNSS/INS
  double noise_m = 0.01;   ///< horizontal; twice that in height
  double drift_m = 0.02;   ///< standard deviation of what wanders slowly
  double drift_s = 60.0;   ///< its correlation time
  double attitude_noise_deg = 0.02;
  double heading_noise_deg = 0.05;
  double outage_every_s = 0.0;  ///< mean time between outages; 0: none
  double outage_s = 5.0;
  double jump_m = 0.0;  ///< one jump of the position, halfway

  static void fields(auto&& field);
  void check() const { check_fields(*this, "gnss"); }
};

/// Rate of the true trajectory. Between its samples the machine moves as `Trajectory::at` says: that is the truth, and
/// beams start from there.
constexpr double kTruthHz = 100.0;

/// The true poses T_world_base from 0 to `seconds` (and one sample more), stamps from 0. The machine stands on the
/// terrain with its tracks or wheels. Throws Error(invalid_argument) if the route ends before the time does.
[[nodiscard]] Trajectory drive(const World& world, const VehicleConfig& config, double seconds, std::uint64_t seed);

/// What a GNSS/INS would say of a true trajectory.
[[nodiscard]] Trajectory measure_gnss(const Trajectory& truth, const GnssConfig& config, std::uint64_t seed);

}  // namespace berm::sim
