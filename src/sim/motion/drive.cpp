#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "berm/core/angle.hpp"
#include "berm/core/error.hpp"
#include "berm/sim/motion.hpp"
#include "drive_legs.hpp"
#include "drive_speed.hpp"
#include "drive_stand.hpp"
#include "drive_way.hpp"
#include "motion_noise.hpp"

namespace berm::sim {
namespace {

constexpr double kTruthStep_s = 1.0 / kTruthHz;
constexpr Stamp kStep_ns = 10'000'000;
static_assert(static_cast<double>(kStep_ns) * kTruthHz == kNanosecondsPerSecond);

/// A heavy machine on its springs, tyres or snow.
constexpr double kHeave_hz = 1.0;
constexpr double kPitch_hz = 1.15;
constexpr double kRoll_hz = 0.85;
constexpr double kDamping = 0.15;
/// A diesel engine at 1000 turns a minute.
constexpr double kHum_hz = 17.0;
constexpr double kHumDamping = 0.02;
/// A bump lifts the front first: this much of the pitch follows the heave.
constexpr double kCoupling = 0.6;
/// What is left of the shaking where the machine stands, and the speed at which it is whole.
constexpr double kStandingShare = 0.1;
constexpr double kWholeAt_m_per_s = 1.0;

/// What the machine does on top of resting on its contact plane.
class Shake {
 public:
  Shake(const VehicleConfig& config, std::uint64_t seed)
      : config_(config),
        heave_(kHeave_hz, kDamping, kTruthStep_s, Random(seed, Purpose::vehicle, 3)),
        pitch_(kPitch_hz, kDamping, kTruthStep_s, Random(seed, Purpose::vehicle, 4)),
        roll_(kRoll_hz, kDamping, kTruthStep_s, Random(seed, Purpose::vehicle, 5)),
        hum_(kHum_hz, kHumDamping, kTruthStep_s, Random(seed, Purpose::vehicle, 6)) {}

  [[nodiscard]] Pose next(double speed_m_per_s) {
    const double share =
        kStandingShare + (1.0 - kStandingShare) * std::min(1.0, std::abs(speed_m_per_s) / kWholeAt_m_per_s);
    const double heave = heave_.next();
    const double own = std::sqrt(1.0 - kCoupling * kCoupling);
    // Nose down is positive.
    const double pitch = -kCoupling * heave + own * pitch_.next();
    const double roll = kCoupling * heave + own * roll_.next();
    const double up_m = share * config_.heave_m * heave + config_.hum_m * hum_.next();
    return Pose::from_yaw_pitch_roll(0.0, share * config_.pitch_deg * kRadPerDeg * pitch,
                                     share * config_.roll_deg * kRadPerDeg * roll, {0.0, 0.0, up_m});
  }

 private:
  const VehicleConfig& config_;
  Oscillation heave_;
  Oscillation pitch_;
  Oscillation roll_;
  Oscillation hum_;
};

[[noreturn]] void refuse_end(const World& world, const VehicleConfig& config, double seconds, double driven_s) {
  throw Error(ErrorCode::invalid_argument,
              fmt::format("the route of {:.0f} m ends after {:.1f} s, not {} s; ask for at most {:.1f} s, lengthen "
                          "route.length_m, or lower vehicle.speed_m_per_s ({}) or vehicle.start_m ({})",
                          world.route.length_m(), driven_s, seconds, std::floor(driven_s * 10.0) / 10.0,
                          config.speed_m_per_s, config.start_m));
}

void check_place(const Area& area, const Eigen::Vector2d& place_m) {
  const bool inside = place_m.x() >= area.min_x_m && place_m.x() <= area.max_x_m && place_m.y() >= area.min_y_m &&
                      place_m.y() <= area.max_y_m;
  if (!inside) {
    throw Error(ErrorCode::invalid_argument,
                fmt::format("the route leaves the terrain at x {:.1f} m, y {:.1f} m, which covers {:.1f} to {:.1f} m "
                            "and {:.1f} to {:.1f} m; shorten route.length_m or begin elsewhere in the model",
                            place_m.x(), place_m.y(), area.min_x_m, area.max_x_m, area.min_y_m, area.max_y_m));
  }
}

std::size_t count_samples(double seconds) {
  return static_cast<std::size_t>(std::ceil(seconds * kTruthHz - 1e-9)) + 2;
}

/// Along the route, without turning back.
Trajectory drive_once(const World& world, const VehicleConfig& config, double seconds, std::uint64_t seed) {
  const ContactArea area{config.length_m, config.width_m};
  const DrivenWay way(world.route, config, seed);
  // The front of the machine ends where the route does.
  const double end_m = world.route.length_m() - 0.5 * config.length_m;
  SpeedPlan speed(config, kTruthStep_s, seed);
  Shake shake(config, seed);
  const std::size_t samples = count_samples(seconds);
  Trajectory trajectory;
  trajectory.reserve(samples);
  double s_m = config.start_m;
  for (std::size_t i = 0; i < samples; ++i) {
    if (s_m > end_m) {
      refuse_end(world, config, seconds, static_cast<double>(i) * kTruthStep_s);
    }
    const Eigen::Vector2d place_m = way.at(s_m);
    check_place(world.area, place_m);
    const double heading_rad = way.heading_rad(s_m) + speed.turned_rad();
    const Pose T_world_plane = stand_on(*world.terrain, area, place_m.x(), place_m.y(), heading_rad);
    trajectory.append(static_cast<Stamp>(i) * kStep_ns, T_world_plane * shake.next(speed.speed_m_per_s()));
    s_m += speed.speed_m_per_s() * kTruthStep_s / way.stretch(s_m);
    speed.step();
  }
  return trajectory;
}

}  // namespace

void VehicleConfig::check() const {
  check_fields(*this, "vehicle");
  if (turn_on_spot_deg != 0.0 && (stop_every_s <= 0.0 || speed_m_per_s <= 0.0)) {
    check_problem("vehicle", "turn_on_spot_deg",
                  "needs a stop to turn in; set vehicle.stop_every_s and vehicle.speed_m_per_s, or turn by 0");
  }
  if (leg_s > 0.0 && leg_s < kShortestLeg_s) {
    check_problem("vehicle", "leg_s", fmt::format("is too short; expected 0 or at least {} s", kShortestLeg_s));
  }
}

Trajectory drive(const World& world, const VehicleConfig& config, double seconds, std::uint64_t seed) {
  config.check();
  if (!(seconds >= 0.0)) {
    throw Error(ErrorCode::invalid_argument, fmt::format("{} s cannot be driven, expected 0 or more", seconds));
  }
  if (config.leg_s > 0.0 && config.leg_s < seconds) {
    return drive_legs(drive_once(world, config, config.leg_s, seed), config.leg_s, count_samples(seconds), kStep_ns);
  }
  return drive_once(world, config, seconds, seed);
}

}  // namespace berm::sim
