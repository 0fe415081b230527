#pragma once

#include <cstdint>
#include <vector>

#include "berm/sim/random.hpp"

namespace berm::sim {

/// Smooth random numbers in the plane: gradient noise (Perlin 1985, with the quintic of 2002), about -1..1,
/// continuous with its slope, the same for the same seed.
class PlaneNoise {
 public:
  PlaneNoise(std::uint64_t seed, Purpose purpose, std::uint64_t index);

  /// One octave with `wave_m` between its bumps; standard deviation about 0.25.
  [[nodiscard]] double at(double x_m, double y_m, double wave_m) const;
  /// Sum of octaves, each half as wide and `gain` as high; standard deviation about 1.
  [[nodiscard]] double fractal(double x_m, double y_m, double wave_m, int octaves, double gain = 0.5) const;

 private:
  std::uint32_t seed_ = 0;
};

/// Values along a line at a fixed step, between them a cubic spline through smooth values, beyond them the last.
class Profile {
 public:
  Profile() = default;
  Profile(double first_s_m, double step_m, std::vector<double> values);

  [[nodiscard]] double at(double s_m) const;
  [[nodiscard]] const std::vector<double>& values() const { return values_; }
  [[nodiscard]] double s_m(std::size_t i) const { return first_s_m_ + step_m_ * static_cast<double>(i); }

 private:
  double first_s_m_ = 0.0;
  double step_m_ = 1.0;
  std::vector<double> values_;
};

/// `count` smooth random values, `wave` values from bump to bump, standard deviation about 1.
[[nodiscard]] std::vector<double> smooth_random(std::size_t count, double wave, Random random);
/// Shifts and stretches `values` so that their least and greatest are `low` and `high`.
void stretch_to(std::vector<double>& values, double low, double high);
/// Gaussian smoothing; ends repeat.
[[nodiscard]] std::vector<double> smoothed(const std::vector<double>& values, double sigma);

/// 0 below `from`, 1 above `to`, with flat ends between.
[[nodiscard]] inline double smooth_step(double from, double to, double x) {
  const double t = (x - from) / (to - from);
  if (t <= 0.0) {
    return 0.0;
  }
  return t >= 1.0 ? 1.0 : t * t * (3.0 - 2.0 * t);
}

/// The lesser of both, rounded where they are within `round` of each other.
[[nodiscard]] inline double smooth_min(double a, double b, double round) {
  const double overlap = round - (a > b ? a - b : b - a);
  const double least = a < b ? a : b;
  return overlap <= 0.0 ? least : least - overlap * overlap / (4.0 * round);
}

}  // namespace berm::sim
