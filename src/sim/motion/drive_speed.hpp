#pragma once

#include <cstdint>

#include "berm/sim/motion.hpp"
#include "motion_noise.hpp"

namespace berm::sim {

/// Speed and turn on the spot, sample by sample: the speed wanders, the machine brakes, stands, turns, goes on.
class SpeedPlan {
 public:
  SpeedPlan(const VehicleConfig& config, double step_s, std::uint64_t seed);

  /// Goes on to the next sample.
  void step();
  [[nodiscard]] double speed_m_per_s() const { return speed_m_per_s_; }
  /// Heading on top of that of the way.
  [[nodiscard]] double turned_rad() const { return turned_rad_; }

 private:
  void plan_next_stop();
  void stand();
  [[nodiscard]] double wanted_m_per_s();

  VehicleConfig config_;
  double step_s_;
  Random random_;
  Drift drift_;
  double wander_ = 0.0;  ///< the drift, smoothed
  double speed_m_per_s_ = 0.0;
  double acceleration_ = 0.0;
  double turned_rad_ = 0.0;
  double time_s_ = 0.0;
  double next_stop_s_ = 0.0;
  double stood_s_ = 0.0;
  double stands_for_s_ = 0.0;
  bool stopping_ = false;
  bool has_turned_ = false;
};

}  // namespace berm::sim
