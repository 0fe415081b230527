#pragma once

#include <array>
#include <cstdint>

#include <Eigen/Core>

#include "berm/sim/motion.hpp"

namespace berm::sim {

/// The line that a machine drives: the route, from which it strays smoothly but never off what is drivable.
class DrivenWay {
 public:
  DrivenWay(const Route& route, const VehicleConfig& config, std::uint64_t seed);

  /// Place on the map at arc length `s_m` of the route.
  [[nodiscard]] Eigen::Vector2d at(double s_m) const;
  /// Direction of a machine of the length of `config` there: from its rear to its front, which both follow the way.
  [[nodiscard]] double heading_rad(double s_m) const;
  /// Metres driven on the ground per metre of the route.
  [[nodiscard]] double stretch(double s_m) const;

 private:
  struct Wave {
    double per_m = 0.0;
    double phase_rad = 0.0;
  };

  [[nodiscard]] double strays_m(double s_m, const RoutePoint& point) const;

  const Route& route_;
  double wander_m_;
  double half_width_m_;
  double half_length_m_;
  std::array<Wave, 4> waves_{};
};

}  // namespace berm::sim
