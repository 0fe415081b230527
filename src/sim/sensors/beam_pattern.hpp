#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "berm/sim/sensor.hpp"

namespace berm::sim {

/// What the kinds of patterns have in common.
class DirectionMaker {
 public:
  virtual ~DirectionMaker() = default;
  virtual void beams_of_scan(std::size_t scan, Beams& beams) const = 0;
  [[nodiscard]] virtual std::size_t beams_per_scan() const = 0;
};

[[nodiscard]] std::shared_ptr<const DirectionMaker> make_spinning(const PatternConfig& config);
[[nodiscard]] std::shared_ptr<const DirectionMaker> make_rosette(const PatternConfig& config);
[[nodiscard]] std::shared_ptr<const DirectionMaker> make_swirl(const PatternConfig& config);

/// Numbers separated by blanks. Throws ConfigError naming `key` for anything else.
[[nodiscard]] std::vector<double> parse_angles_deg(const std::string& text, const std::string& key);

/// Shots at a constant rate, counted from the start of scan 0, in scans.
class ShotClock {
 public:
  ShotClock(double shots_per_s, double scan_hz) : shots_per_s_(shots_per_s), scan_hz_(scan_hz) {}

  /// First shot of a scan.
  [[nodiscard]] std::size_t first(std::size_t scan) const;
  /// The most shots of a scan.
  [[nodiscard]] std::size_t most() const;
  /// When a shot is fired after the start of a scan.
  [[nodiscard]] double since_start_s(std::size_t shot, std::size_t scan) const {
    return static_cast<double>(shot) / shots_per_s_ - static_cast<double>(scan) / scan_hz_;
  }
  /// Angle of what turns `hz` times a second when a shot is fired.
  [[nodiscard]] double angle_rad(std::size_t shot, double hz) const;

 private:
  double shots_per_s_;
  double scan_hz_;
};

/// cos and sin of an angle that grows by the same step, without a call of either. The error grows by 1e-16 a step.
class Rotor {
 public:
  Rotor(double angle_rad, double step_rad);

  [[nodiscard]] double cosine() const { return cosine_; }
  [[nodiscard]] double sine() const { return sine_; }
  void advance() {
    const double cosine = cosine_ * step_cosine_ - sine_ * step_sine_;
    sine_ = sine_ * step_cosine_ + cosine_ * step_sine_;
    cosine_ = cosine;
  }

 private:
  double cosine_;
  double sine_;
  double step_cosine_;
  double step_sine_;
};

/// 1 - q r0 (1 - q r1 (1 - q r2 ...)).
template <std::size_t kFirst = 0>
[[nodiscard, gnu::always_inline]] inline double nested_series(double q, const std::array<double, 7>& ratios) {
  if constexpr (kFirst == 7) {
    return 1.0;
  } else {
    return 1.0 - q * ratios[kFirst] * nested_series<kFirst + 1>(q, ratios);
  }
}

/// cos(sqrt(q)) as a power series. Patterns have angles of at most 90 degrees, q <= 2.5: the first term left out is
/// below 1e-7 there, less than a float holds.
[[nodiscard, gnu::always_inline]] inline double cosine_of_root(double q) {
  // Divisions are what costs in such a series.
  constexpr std::array<double, 7> kRatios = {1.0 / 2.0,  1.0 / 12.0,  1.0 / 30.0, 1.0 / 56.0,
                                             1.0 / 90.0, 1.0 / 132.0, 1.0 / 182.0};
  return nested_series(q, kRatios);
}

/// sin(sqrt(q)) / sqrt(q), the same way.
[[nodiscard, gnu::always_inline]] inline double sine_over_root(double q) {
  constexpr std::array<double, 7> kRatios = {1.0 / 6.0,   1.0 / 20.0,  1.0 / 42.0, 1.0 / 72.0,
                                             1.0 / 110.0, 1.0 / 156.0, 1.0 / 210.0};
  return nested_series(q, kRatios);
}

}  // namespace berm::sim
