#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "berm/core/config.hpp"
#include "berm/sim/random.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/world.hpp"

namespace berm::sim {

struct SnowfallConfig {
  double flakes_per_m3 = 0.0;  ///< 0: no snowfall
  double mean_diameter_m = 0.003;
  double drift_flakes_per_m3 = 0.0;  ///< blowing snow at the ground, on top
  double drift_height_m = 0.4;       ///< height in which it thins to 1/e
  double gustiness = 0.5;            ///< 0: even; 1: in clouds with nothing between
  double wind_m_per_s = 3.0;
  double wind_from_deg = 0.0;

  static void fields(auto&& field);
  void check() const { check_fields(*this, "snowfall"); }
};

/// An echo out of the air.
struct AirEcho {
  double range_m = 0.0;
  double reflectivity = 0.0;  ///< as reported
  double blocked = 0.0;       ///< share of the beam that does not go on, 0..1
  bool dust = false;
};

/// Flakes and dust as a volume: where along a beam they give an echo, with which strength.
class Weather {
 public:
  Weather(const SnowfallConfig& snowfall, const OpticsConfig& optics, std::vector<Plume> plumes);

  [[nodiscard]] bool is_clear() const;
  /// The nearest echo before `end_m`, if there is one. `height_m`: of the sensor above the ground; `slope`: change of
  /// the beam's height above the ground per metre of range.
  [[nodiscard]] std::optional<AirEcho> first_echo(const Eigen::Vector3d& origin_m, const Eigen::Vector3d& direction,
                                                  double end_m, double time_s, double height_m, double slope,
                                                  Random& random) const;
  /// Expected number of flake echoes nearer than `range_m` for a beam that stays far above the ground: the closed form
  /// that tests hold `first_echo` against.
  [[nodiscard]] double expected_flakes(double range_m) const;
};

}  // namespace berm::sim
