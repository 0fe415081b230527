#pragma once

#include <cstdint>

#include "berm/core/config.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/sim/world.hpp"

namespace berm::sim {

/// How the machine drives and shakes.
struct VehicleConfig {
  double speed_m_per_s = 1.5;
  double speed_change = 0.2;
  double stop_every_s = 0.0;
  double stop_s = 3.0;
  double turn_on_spot_deg = 0.0;
  double leg_s = 0.0;
  double length_m = 4.5;
  double width_m = 3.0;
  double heave_m = 0.015;
  double pitch_deg = 0.4;
  double roll_deg = 0.3;
  double hum_m = 0.001;
  double wander_m = 0.3;
  double start_m = 10.0;

  static void fields(auto&& field) {
    field("speed_m_per_s", &VehicleConfig::speed_m_per_s, Range{0.0, 30.0}, "mean speed on the ground; 0: it stands");
    field("speed_change", &VehicleConfig::speed_change, Range{0.0, 0.5}, "share by which the speed wanders");
    field("stop_every_s", &VehicleConfig::stop_every_s, Range{0.0, 36000.0}, "mean time from stop to stop; 0: none");
    field("stop_s", &VehicleConfig::stop_s, Range{0.0, 600.0}, "how long it stands at least");
    field("turn_on_spot_deg", &VehicleConfig::turn_on_spot_deg, Range{-180.0, 180.0},
          "turned there and back during the first stop, positive: to the left");
    field("leg_s", &VehicleConfig::leg_s, Range{0.0, 36000.0},
          "after so long it turns round on the spot and drives back, again and again; 0: it never does");
    field("length_m", &VehicleConfig::length_m, Range{0.5, 20.0}, "of the tracks, or the wheelbase");
    field("width_m", &VehicleConfig::width_m, Range{0.5, 12.0}, "between the middles of the tracks or wheels");
    field("heave_m", &VehicleConfig::heave_m, Range{0.0, 0.3}, "standard deviation of the heave, at about 1 Hz");
    field("pitch_deg", &VehicleConfig::pitch_deg, Range{0.0, 5.0}, "the same of the pitch that goes with it");
    field("roll_deg", &VehicleConfig::roll_deg, Range{0.0, 5.0}, "the same of the roll");
    field("hum_m", &VehicleConfig::hum_m, Range{0.0, 0.02}, "standard deviation of the vibration, at about 17 Hz");
    field("wander_m", &VehicleConfig::wander_m, Range{0.0, 5.0},
          "standard deviation of how far it strays from the middle");
    field("start_m", &VehicleConfig::start_m, Range{0.0, 10000.0}, "where on the route it begins");
  }
  /// Also refuses a turn without a stop to turn in, and legs too short to brake in.
  void check() const;
};

/// What the GNSS/INS adds to the truth: RTK as it is on a good day, and on others.
struct GnssConfig {
  double rate_hz = 100.0;
  double noise_m = 0.008;
  double drift_m = 0.015;
  double drift_s = 60.0;
  double attitude_noise_deg = 0.02;
  double heading_noise_deg = 0.05;
  double outage_every_s = 0.0;
  double outage_s = 5.0;
  double jump_m = 0.0;

  static void fields(auto&& field) {
    field("rate_hz", &GnssConfig::rate_hz, Range{0.0, 200.0}, "poses per second; 0: no GNSS/INS");
    field("noise_m", &GnssConfig::noise_m, Range{0.0, 10.0}, "white noise, horizontal; twice that in height");
    field("drift_m", &GnssConfig::drift_m, Range{0.0, 20.0}, "standard deviation of what wanders slowly");
    field("drift_s", &GnssConfig::drift_s, Range{1.0, 36000.0}, "its correlation time (Gauss-Markov)");
    field("attitude_noise_deg", &GnssConfig::attitude_noise_deg, Range{0.0, 5.0}, "white noise of roll and pitch");
    field("heading_noise_deg", &GnssConfig::heading_noise_deg, Range{0.0, 5.0}, "white noise of the heading");
    field("outage_every_s", &GnssConfig::outage_every_s, Range{0.0, 36000.0},
          "mean time from outage to outage; 0: none");
    field("outage_s", &GnssConfig::outage_s, Range{0.0, 600.0}, "how long an outage lasts");
    field("jump_m", &GnssConfig::jump_m, Range{0.0, 20.0}, "one jump of the position that stays, halfway");
  }
  /// Also refuses rates and times that are nearly nothing but not 0.
  void check() const;
};

/// Rate of the true trajectory. Between its samples the machine moves as `Trajectory::at` says: that is the truth, and
/// beams start from there.
constexpr double kTruthHz = 100.0;

/// The true poses T_world_base from 0 to `seconds` (and one sample more), stamps from 0. base_link is in the middle of
/// the contact area: the machine stands on the terrain with its tracks or wheels, and shakes. Throws ConfigError as
/// `VehicleConfig::check`, Error(invalid_argument) if the route ends before the time does (saying how long it lasts) or
/// leaves the area of the world.
[[nodiscard]] Trajectory drive(const World& world, const VehicleConfig& config, double seconds, std::uint64_t seed);

/// What a GNSS/INS would say of a true trajectory: its poses at `rate_hz`, those of outages left out. Throws
/// ConfigError as `GnssConfig::check`.
[[nodiscard]] Trajectory measure_gnss(const Trajectory& truth, const GnssConfig& config, std::uint64_t seed);

}  // namespace berm::sim
