#include "drive_legs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "berm/core/stamp.hpp"

namespace berm::sim {
namespace {

/// At 1.7 m/s a groomer brakes with 0.6 m/s2.
constexpr double kBraking_s = 3.0;
/// Half a turn, at 24 degrees a second at most.
constexpr double kHalfTurn_s = 12.0;

/// Where on the leg the machine is, as the time at which it would be there without ends, and how far it has turned.
struct LegPlace {
  double once_s = 0.0;
  double turned_rad = 0.0;
};

/// Way of something that sets off evenly within `kBraking_s`, in seconds of full speed.
double set_off(double time_s) {
  return time_s < kBraking_s ? time_s * time_s / (2.0 * kBraking_s) : time_s - 0.5 * kBraking_s;
}

/// How far along the leg: setting off (the first leg begins in motion), braking at its end.
double along_leg(double time_s, double leg_s, bool is_first) {
  const double lasts_s = leg_s + (is_first ? 0.5 : 1.0) * kBraking_s;
  const double to_end_s = lasts_s - time_s;
  if (to_end_s < 0.5 * lasts_s) {
    return leg_s - set_off(to_end_s);
  }
  return is_first ? time_s : set_off(time_s);
}

LegPlace place_at(double time_s, double leg_s) {
  const double first_s = leg_s + 0.5 * kBraking_s + kHalfTurn_s;
  const double later_s = leg_s + kBraking_s + kHalfTurn_s;
  const bool is_first = time_s < first_s;
  const double number = is_first ? 0.0 : 1.0 + std::floor((time_s - first_s) / later_s);
  const double since_s = is_first ? time_s : time_s - first_s - (number - 1.0) * later_s;
  const double drives_s = (is_first ? first_s : later_s) - kHalfTurn_s;
  const double along_s = since_s < drives_s ? along_leg(since_s, leg_s, is_first) : leg_s;
  const double turn = std::clamp((since_s - drives_s) / kHalfTurn_s, 0.0, 1.0);
  const bool is_back = std::fmod(number, 2.0) == 1.0;
  return {std::clamp(is_back ? leg_s - along_s : along_s, 0.0, leg_s),
          std::numbers::pi * (number + 0.5 - 0.5 * std::cos(std::numbers::pi * turn))};
}

}  // namespace

Trajectory drive_legs(const Trajectory& once, double leg_s, std::size_t samples, Stamp step_ns) {
  Trajectory trajectory;
  trajectory.reserve(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const Stamp stamp_ns = static_cast<Stamp>(i) * step_ns;
    const LegPlace place = place_at(to_seconds(stamp_ns), leg_s);
    // `once` reaches to leg_s and a sample more: there is always a pose.
    trajectory.append(stamp_ns, *once.at(from_seconds(place.once_s)) *
                                    Pose::from_yaw_pitch_roll(place.turned_rad, 0.0, 0.0, {0.0, 0.0, 0.0}));
  }
  return trajectory;
}

}  // namespace berm::sim
