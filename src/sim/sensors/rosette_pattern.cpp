#include <cmath>
#include <numbers>

#include "beam_pattern.hpp"
#include "berm/core/multiversion.hpp"

namespace berm::sim {
namespace {

/// Two thin prisms: each turns the beam by a constant angle in a direction that goes round with the prism. The two
/// turns add as arrows in the plane of deflections (equidistant: the length of their sum is the angle to the
/// boresight).
class RosettePattern : public DirectionMaker {
 public:
  explicit RosettePattern(const PatternConfig& config)
      : clock_(config.points_per_s, config.scan_hz), points_per_s_(config.points_per_s) {
    const double reach_rad = config.field_of_view_deg / 2.0 * std::numbers::pi / 180.0;
    hz_[0] = config.prism_hz;
    hz_[1] = config.prism_hz * config.prism_ratio;
    deflection_rad_[0] = reach_rad * config.prism_share;
    deflection_rad_[1] = reach_rad * (1.0 - config.prism_share);
  }

  void beams_of_scan(std::size_t scan, Beams& beams) const override;
  [[nodiscard]] std::size_t beams_per_scan() const override { return clock_.most(); }

 private:
  ShotClock clock_;
  double points_per_s_;
  double hz_[2] = {};
  double deflection_rad_[2] = {};
};

/// Directions from where the two turns add up to, in place.
BERM_MULTIVERSION void aim(std::size_t count, float* __restrict x, float* __restrict y, float* __restrict z) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto up = static_cast<double>(z[i]);
    const auto left = static_cast<double>(y[i]);
    const double q = left * left + up * up;
    const double scale = sine_over_root(q);
    x[i] = static_cast<float>(cosine_of_root(q));
    y[i] = static_cast<float>(scale * left);
    z[i] = static_cast<float>(scale * up);
  }
}

void RosettePattern::beams_of_scan(std::size_t scan, Beams& beams) const {
  const std::size_t first = clock_.first(scan);
  const std::size_t count = clock_.first(scan + 1) - first;
  beams.resize(count, false);
  Rotor one(clock_.angle_rad(first, hz_[0]), 2.0 * std::numbers::pi * hz_[0] / points_per_s_);
  Rotor two(clock_.angle_rad(first, hz_[1]), 2.0 * std::numbers::pi * hz_[1] / points_per_s_);
  const double start_s = clock_.since_start_s(first, scan);
  const double step_s = 1.0 / points_per_s_;
  for (std::size_t i = 0; i < count; ++i) {
    beams.y[i] = static_cast<float>(deflection_rad_[0] * one.cosine() + deflection_rad_[1] * two.cosine());
    beams.z[i] = static_cast<float>(deflection_rad_[0] * one.sine() + deflection_rad_[1] * two.sine());
    beams.time_s[i] = static_cast<float>(start_s + static_cast<double>(i) * step_s);
    one.advance();
    two.advance();
  }
  aim(count, beams.x.data(), beams.y.data(), beams.z.data());
}

}  // namespace

std::shared_ptr<const DirectionMaker> make_rosette(const PatternConfig& config) {
  return std::make_shared<RosettePattern>(config);
}

}  // namespace berm::sim
