#include <cmath>
#include <numbers>

#include "beam_pattern.hpp"
#include "berm/core/angle.hpp"

namespace berm::sim {
namespace {

/// A column of lasers seen in a mirror that turns fast and tilts slowly, up and down like a pendulum. The mirror turns
/// the picture of the column, too: upright at azimuth `kUpright`, lying a quarter of a turn later.
class SwirlPattern : public DirectionMaker {
 public:
  explicit SwirlPattern(const PatternConfig& config);

  void beams_of_scan(std::size_t scan, Beams& beams) const override;
  [[nodiscard]] std::size_t beams_per_scan() const override { return clock_.most(); }

 private:
  struct Offset {
    double up_rad;
    double left_rad;
  };

  ShotClock clock_;
  double points_per_s_;
  double turn_hz_;
  double sweep_hz_;
  double middle_cosine_;
  double middle_sine_;
  double swing_rad_;
  std::vector<Offset> fan_;
};

constexpr double kUpright = -30.0 * kRadPerDeg;

SwirlPattern::SwirlPattern(const PatternConfig& config)
    : clock_(config.points_per_s, config.scan_hz),
      points_per_s_(config.points_per_s),
      turn_hz_(config.turn_hz),
      sweep_hz_(config.sweep_hz),
      middle_cosine_(std::cos((config.max_elevation_deg + config.min_elevation_deg) / 2.0 * kRadPerDeg)),
      middle_sine_(std::sin((config.max_elevation_deg + config.min_elevation_deg) / 2.0 * kRadPerDeg)),
      swing_rad_((config.max_elevation_deg - config.min_elevation_deg - config.fan_height_deg) / 2.0 * kRadPerDeg) {
  for (int i = 0; i < config.fan_lasers; ++i) {
    const double place = config.fan_lasers > 1 ? static_cast<double>(i) / (config.fan_lasers - 1) - 0.5 : 0.0;
    fan_.push_back({-place * config.fan_height_deg * kRadPerDeg, -place * config.fan_width_deg * kRadPerDeg});
  }
}

void SwirlPattern::beams_of_scan(std::size_t scan, Beams& beams) const {
  const std::size_t first = clock_.first(scan);
  const std::size_t count = clock_.first(scan + 1) - first;
  beams.resize(count, true);
  Rotor turn(clock_.angle_rad(first, turn_hz_), 2.0 * std::numbers::pi * turn_hz_ / points_per_s_);
  Rotor sweep(clock_.angle_rad(first, sweep_hz_), 2.0 * std::numbers::pi * sweep_hz_ / points_per_s_);
  const double start_s = clock_.since_start_s(first, scan);
  const double upright_cosine = std::cos(kUpright);
  const double upright_sine = std::sin(kUpright);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t laser = (first + i) % fan_.size();
    const double up = fan_[laser].up_rad * (turn.cosine() * upright_cosine + turn.sine() * upright_sine);
    const double left = fan_[laser].left_rad * (turn.sine() * upright_cosine - turn.cosine() * upright_sine);
    const double tilt_rad = swing_rad_ * sweep.cosine() + up;
    const double tilt_cosine = cosine_of_root(tilt_rad * tilt_rad);
    const double tilt_sine = tilt_rad * sine_over_root(tilt_rad * tilt_rad);
    // Elevation, then to the left, then around. `left` is small: the length differs from 1 by its square.
    const double shrink = 1.0 / std::sqrt(1.0 + left * left);
    const double forward = (middle_cosine_ * tilt_cosine - middle_sine_ * tilt_sine) * shrink;
    const double height = (middle_sine_ * tilt_cosine + middle_cosine_ * tilt_sine) * shrink;
    const double side = left * shrink;
    beams.x[i] = static_cast<float>(turn.cosine() * forward - turn.sine() * side);
    beams.y[i] = static_cast<float>(turn.sine() * forward + turn.cosine() * side);
    beams.z[i] = static_cast<float>(height);
    beams.time_s[i] = static_cast<float>(start_s + static_cast<double>(i) / points_per_s_);
    beams.ring[i] = static_cast<std::uint16_t>(laser);
    turn.advance();
    sweep.advance();
  }
}

}  // namespace

std::shared_ptr<const DirectionMaker> make_swirl(const PatternConfig& config) {
  return std::make_shared<SwirlPattern>(config);
}

}  // namespace berm::sim
