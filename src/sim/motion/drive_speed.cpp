#include "drive_speed.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace berm::sim {
namespace {

/// How long the speed keeps to one side of its mean.
constexpr double kWanderTime_s = 8.0;
/// Smooths the wander, so that nobody is jerked.
constexpr double kSmoothTime_s = 2.0;
/// How hard a heavy machine speeds up or brakes, and within which time it begins to.
constexpr double kMaxAcceleration_m_per_s2 = 1.2;
constexpr double kSpeedTime_s = 0.6;
constexpr double kJerkTime_s = 0.25;
/// Below this it stands.
constexpr double kStanding_m_per_s = 0.005;
/// Mean rate of a turn on the spot.
constexpr double kTurnRate_deg_per_s = 20.0;
/// Never quicker from one stop to the next than this share of the mean time.
constexpr double kStopSpread = 0.5;

/// 0 to 1 and back for 0..1, at rest at both ends and in the middle.
double there_and_back(double share) {
  return 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * share));
}

}  // namespace

SpeedPlan::SpeedPlan(const VehicleConfig& config, double step_s, std::uint64_t seed)
    : config_(config),
      step_s_(step_s),
      random_(seed, Purpose::vehicle, 0),
      drift_(kWanderTime_s, step_s, Random(seed, Purpose::vehicle, 1)),
      speed_m_per_s_(config.speed_m_per_s) {
  wander_ = drift_.next();
  speed_m_per_s_ = wanted_m_per_s();
  plan_next_stop();
}

void SpeedPlan::plan_next_stop() {
  next_stop_s_ = config_.stop_every_s > 0.0 && config_.speed_m_per_s > 0.0
                     ? time_s_ + config_.stop_every_s * random_.uniform(1.0 - kStopSpread, 1.0 + kStopSpread)
                     : std::numeric_limits<double>::infinity();
}

double SpeedPlan::wanted_m_per_s() {
  wander_ += (drift_.next() - wander_) * step_s_ / kSmoothTime_s;
  const double change = config_.speed_change * std::clamp(wander_, -1.8, 1.8);
  return stopping_ ? 0.0 : config_.speed_m_per_s * (1.0 + change);
}

void SpeedPlan::stand() {
  speed_m_per_s_ = 0.0;
  acceleration_ = 0.0;
  stood_s_ += step_s_;
  const bool turns = !has_turned_ && config_.turn_on_spot_deg != 0.0;
  if (turns) {
    stands_for_s_ = std::max(config_.stop_s, 2.0 * std::abs(config_.turn_on_spot_deg) / kTurnRate_deg_per_s);
    const double share = std::min(1.0, stood_s_ / stands_for_s_);
    turned_rad_ = config_.turn_on_spot_deg * std::numbers::pi / 180.0 * there_and_back(share);
  } else {
    stands_for_s_ = config_.stop_s;
  }
  if (stood_s_ >= stands_for_s_) {
    turned_rad_ = 0.0;
    has_turned_ = true;
    stopping_ = false;
    stood_s_ = 0.0;
    plan_next_stop();
  }
}

void SpeedPlan::step() {
  time_s_ += step_s_;
  if (!stopping_ && time_s_ >= next_stop_s_) {
    stopping_ = true;
  }
  const double wanted = wanted_m_per_s();
  if (stopping_ && (stood_s_ > 0.0 || speed_m_per_s_ <= kStanding_m_per_s)) {
    stand();
    return;
  }
  const double pull =
      std::clamp((wanted - speed_m_per_s_) / kSpeedTime_s, -kMaxAcceleration_m_per_s2, kMaxAcceleration_m_per_s2);
  acceleration_ += (pull - acceleration_) * step_s_ / kJerkTime_s;
  speed_m_per_s_ = std::max(0.0, speed_m_per_s_ + acceleration_ * step_s_);
}

}  // namespace berm::sim
