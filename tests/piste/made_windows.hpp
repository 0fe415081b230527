#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "trace_windows.hpp"

namespace berm::test {

using HeightOf = std::function<double(double x_m, double y_m)>;

/// Where a window lies and which way it looks.
struct WindowPlace {
  double x_m = 0.0;
  double y_m = 0.0;
  double heading_rad = 0.0;
  double length_m = 0.6;
};

/// A window on the ground that `z_of` says, `variance_m2` about it.
inline void add_window(TraceWindows& windows, const WindowPlace& place, const HeightOf& z_of,
                       double variance_m2 = 1e-6) {
  constexpr double kStep_m = 1e-3;
  const double u = std::cos(place.heading_rad);
  const double v = std::sin(place.heading_rad);
  const double rise_m =
      z_of(place.x_m + kStep_m * u, place.y_m + kStep_m * v) - z_of(place.x_m - kStep_m * u, place.y_m - kStep_m * v);
  const double range_m = std::hypot(place.x_m, place.y_m);
  windows.x.push_back(static_cast<float>(place.x_m));
  windows.y.push_back(static_cast<float>(place.y_m));
  windows.z.push_back(static_cast<float>(z_of(place.x_m, place.y_m)));
  windows.along_x.push_back(static_cast<float>(u));
  windows.along_y.push_back(static_cast<float>(v));
  windows.slope.push_back(static_cast<float>(0.5 * rise_m / kStep_m));
  windows.variance_m2.push_back(static_cast<float>(variance_m2));
  windows.length_m.push_back(static_cast<float>(place.length_m));
  windows.nominal_m.push_back(static_cast<float>(std::max(0.6, 0.05 * range_m)));
  windows.range_m.push_back(static_cast<float>(range_m));
}

/// `count` windows that look any way, anywhere in a sector of a ring of half angle `half_angle_rad` around straight
/// ahead, as dense as beams lay them: evenly over bearings and logarithms of range.
inline TraceWindows scattered_windows(int count, double from_m, double to_m, double half_angle_rad,
                                      const HeightOf& z_of, unsigned seed = 1) {
  std::mt19937 random(seed);
  const auto uniform = [&random](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) * 0x1p-32;
  };
  TraceWindows windows;
  for (int i = 0; i < count; ++i) {
    const double range_m = std::exp(uniform(std::log(from_m), std::log(to_m)));
    const double bearing_rad = uniform(-half_angle_rad, half_angle_rad);
    add_window(windows, {range_m * std::cos(bearing_rad), range_m * std::sin(bearing_rad), uniform(-3.1, 3.1)}, z_of);
  }
  return windows;
}

}  // namespace berm::test
