#include <algorithm>
#include <cmath>
#include <numbers>

#include "beam_pattern.hpp"
#include "berm/core/angle.hpp"

namespace berm::sim {
namespace {

/// A laser as it looks when the head points forward at the start of its column.
struct Laser {
  double x;
  double y;
  double z;
  double delay_s;
  std::uint16_t ring;
};

class SpinningPattern : public DirectionMaker {
 public:
  explicit SpinningPattern(const PatternConfig& config);

  void beams_of_scan(std::size_t scan, Beams& beams) const override;
  [[nodiscard]] std::size_t beams_per_scan() const override { return clock_.most() * lasers_.size(); }

 private:
  ShotClock clock_;  ///< a shot is a column
  double turns_per_s_;
  std::vector<Laser> lasers_;
};

std::vector<std::uint16_t> rank(const std::vector<double>& values) {
  std::vector<std::size_t> order(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] < values[b]; });
  std::vector<std::uint16_t> ranks(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    ranks[order[i]] = static_cast<std::uint16_t>(i);
  }
  return ranks;
}

// The head goes on turning while the lasers of a column fire.
SpinningPattern::SpinningPattern(const PatternConfig& config)
    : clock_(1.0 / config.column_s, config.scan_hz), turns_per_s_(config.clockwise ? -config.scan_hz : config.scan_hz) {
  const auto elevations_deg = parse_angles_deg(config.elevations_deg, "elevations_deg");
  auto offsets_deg = parse_angles_deg(config.azimuth_offsets_deg, "azimuth_offsets_deg");
  offsets_deg.resize(elevations_deg.size(), 0.0);
  const auto rings = rank(elevations_deg);
  const auto at_once = static_cast<std::size_t>(config.lasers_at_once);
  for (std::size_t i = 0; i < elevations_deg.size(); ++i) {
    const std::size_t group = i / at_once;
    const double delay_s = static_cast<double>(group) * config.firing_s;
    const double elevation_rad = elevations_deg[i] * kRadPerDeg;
    const double azimuth_rad = offsets_deg[i] * kRadPerDeg + 2.0 * std::numbers::pi * turns_per_s_ * delay_s;
    lasers_.push_back({std::cos(elevation_rad) * std::cos(azimuth_rad), std::cos(elevation_rad) * std::sin(azimuth_rad),
                       std::sin(elevation_rad), delay_s, rings[i]});
  }
}

void SpinningPattern::beams_of_scan(std::size_t scan, Beams& beams) const {
  const std::size_t first = clock_.first(scan);
  const std::size_t end = clock_.first(scan + 1);
  beams.resize((end - first) * lasers_.size(), true);
  std::size_t i = 0;
  for (std::size_t column = first; column < end; ++column) {
    const double angle_rad = clock_.angle_rad(column, turns_per_s_);
    const double cosine = std::cos(angle_rad);
    const double sine = std::sin(angle_rad);
    // Not before the start: a column that falls on it but for rounding counts as on it.
    const double start_s = std::max(0.0, clock_.since_start_s(column, scan));
    for (const Laser& laser : lasers_) {
      beams.x[i] = static_cast<float>(cosine * laser.x - sine * laser.y);
      beams.y[i] = static_cast<float>(sine * laser.x + cosine * laser.y);
      beams.z[i] = static_cast<float>(laser.z);
      beams.time_s[i] = static_cast<float>(start_s + laser.delay_s);
      beams.ring[i] = laser.ring;
      ++i;
    }
  }
}

}  // namespace

std::shared_ptr<const DirectionMaker> make_spinning(const PatternConfig& config) {
  return std::make_shared<SpinningPattern>(config);
}

}  // namespace berm::sim
