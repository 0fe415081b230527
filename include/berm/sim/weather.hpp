#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "berm/core/config.hpp"
#include "berm/sim/random.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/world.hpp"

namespace berm::sim {

struct SnowfallConfig {
  double flakes_per_m3 = 0.0;
  double mean_diameter_m = 0.001;
  double flake_reflectivity = 0.05;
  double drift_flakes_per_m3 = 0.0;
  double drift_height_m = 0.4;
  double gustiness = 0.5;
  double gust_size_m = 12.0;
  double wind_m_per_s = 3.0;
  double wind_from_deg = 0.0;

  static void fields(auto&& field) {
    field("flakes_per_m3", &SnowfallConfig::flakes_per_m3, Range{0.0, 1e6}, "falling flakes; 0: no snowfall");
    field("mean_diameter_m", &SnowfallConfig::mean_diameter_m, Range{1e-5, 0.05},
          "of the flakes, whose diameters are exponentially distributed (Gunn and Marshall 1958)");
    field("flake_reflectivity", &SnowfallConfig::flake_reflectivity, Range{0.0, 1.0},
          "median share of the light on a flake that comes back as from a diffuse surface");
    field("drift_flakes_per_m3", &SnowfallConfig::drift_flakes_per_m3, Range{0.0, 1e7},
          "blowing snow at the ground, on top of the falling");
    field("drift_height_m", &SnowfallConfig::drift_height_m, Range{0.01, 100.0},
          "height in which blowing snow thins to 1/e");
    field("gustiness", &SnowfallConfig::gustiness, Range{0.0, 1.0}, "0: even; 1: in clouds with nothing between");
    field("gust_size_m", &SnowfallConfig::gust_size_m, Range{1.0, 1000.0}, "how large such clouds are");
    field("wind_m_per_s", &SnowfallConfig::wind_m_per_s, Range{0.0, 60.0}, "clouds of flakes move with the wind");
    field("wind_from_deg", &SnowfallConfig::wind_from_deg, Range{-360.0, 360.0},
          "0: from the north, 90: from the east");
  }
  void check() const { check_fields(*this, "snowfall"); }
};

/// A beam on its way through the air.
struct AirBeam {
  Eigen::Vector3d origin_m = Eigen::Vector3d::Zero();    ///< world frame
  Eigen::Vector3d direction = Eigen::Vector3d::UnitX();  ///< unit
  double end_m = 0.0;                                    ///< where it meets something, or leaves the sensor's range
  double time_s = 0.0;                                   ///< since the start of the recording
  double height_m = 1e3;                                 ///< of the origin above the ground
  double slope = 0.0;                                    ///< change of the height above the ground per metre
};

/// An echo out of the air.
struct AirEcho {
  double range_m = 0.0;
  double light = 0.0;         ///< as `received_light`; at least about the detection limit
  double reflectivity = 0.0;  ///< percent, as that of surfaces
  bool dust = false;
};

/// What the air does to a beam.
struct AirPath {
  bool has_echo = false;
  AirEcho echo;               ///< the nearest one that the sensor would find
  double transmission = 1.0;  ///< share of the light from `end_m` that comes back all the way, 0..1
};

struct AirLanes;

/// Flakes and dust as a volume: where along a beam they give an echo, and how much light they take.
class Weather {
 public:
  /// `seed` places the gusts.
  Weather(const SnowfallConfig& snowfall, const OpticsConfig& optics, std::vector<Plume> plumes, std::uint64_t seed);

  /// Whether no beam ever meets anything: then `along` need not be called.
  [[nodiscard]] bool is_clear() const;
  /// Takes all chance from `random`. Thread-safe.
  [[nodiscard]] AirPath along(const AirBeam& beam, Random& random) const;
  /// The same for many beams at once, which is several times as quick. Thread-safe for `beams` of its own.
  void along(AirLanes& beams) const;

  /// Expected number of flakes nearer than `range_m` that the sensor would find in a beam far above the ground, without
  /// gusts: what tests hold `along` against.
  [[nodiscard]] double expected_flakes(double range_m) const;

 private:
  struct Air;
  std::shared_ptr<const Air> air_;
};

}  // namespace berm::sim
