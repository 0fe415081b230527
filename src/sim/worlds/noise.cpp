#include "noise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace berm::sim {
namespace {

/// Sixteen directions evenly around; more cannot be told apart.
constexpr std::array<std::array<double, 2>, 16> kDirections{{{1.0, 0.0},
                                                             {0.92387953, 0.38268343},
                                                             {0.70710678, 0.70710678},
                                                             {0.38268343, 0.92387953},
                                                             {0.0, 1.0},
                                                             {-0.38268343, 0.92387953},
                                                             {-0.70710678, 0.70710678},
                                                             {-0.92387953, 0.38268343},
                                                             {-1.0, 0.0},
                                                             {-0.92387953, -0.38268343},
                                                             {-0.70710678, -0.70710678},
                                                             {-0.38268343, -0.92387953},
                                                             {0.0, -1.0},
                                                             {0.38268343, -0.92387953},
                                                             {0.70710678, -0.70710678},
                                                             {0.92387953, -0.38268343}}};

/// Integer hash of a lattice point (Murmur3 finalizer over two primes).
std::size_t direction_of(std::int32_t ix, std::int32_t iy, std::uint32_t seed) {
  std::uint32_t h =
      seed ^ (static_cast<std::uint32_t>(ix) * 0x8da6b343U) ^ (static_cast<std::uint32_t>(iy) * 0xd8163841U);
  h ^= h >> 16;
  h *= 0x85ebca6bU;
  h ^= h >> 13;
  h *= 0xc2b2ae35U;
  h ^= h >> 16;
  return h & 15U;
}

double corner(std::int32_t ix, std::int32_t iy, std::uint32_t seed, double dx, double dy) {
  const auto& direction = kDirections[direction_of(ix, iy, seed)];
  return direction[0] * dx + direction[1] * dy;
}

double lattice_noise(double x, double y, std::uint32_t seed) {
  // Far outside of any world the lattice repeats instead of overflowing.
  constexpr double kLattice = 1e9;
  x = std::abs(x) < kLattice ? x : 0.0;
  y = std::abs(y) < kLattice ? y : 0.0;
  const double fx = std::floor(x);
  const double fy = std::floor(y);
  const auto ix = static_cast<std::int32_t>(fx);
  const auto iy = static_cast<std::int32_t>(fy);
  const double dx = x - fx;
  const double dy = y - fy;
  const double u = dx * dx * dx * (dx * (6.0 * dx - 15.0) + 10.0);
  const double v = dy * dy * dy * (dy * (6.0 * dy - 15.0) + 10.0);
  const double a = corner(ix, iy, seed, dx, dy);
  const double b = corner(ix + 1, iy, seed, dx - 1.0, dy);
  const double c = corner(ix, iy + 1, seed, dx, dy - 1.0);
  const double d = corner(ix + 1, iy + 1, seed, dx - 1.0, dy - 1.0);
  return (a + u * (b - a)) + v * ((c + u * (d - c)) - (a + u * (b - a)));
}

/// Standard deviation of one octave, measured.
constexpr double kOctaveSigma = 0.26;

}  // namespace

PlaneNoise::PlaneNoise(std::uint64_t seed, Purpose purpose, std::uint64_t index)
    : seed_(static_cast<std::uint32_t>(Random(seed, purpose, index).bits() >> 32U)) {}

double PlaneNoise::at(double x_m, double y_m, double wave_m) const {
  return lattice_noise(x_m / wave_m, y_m / wave_m, seed_);
}

double PlaneNoise::fractal(double x_m, double y_m, double wave_m, int octaves, double gain) const {
  double sum = 0.0;
  double variance = 0.0;
  double weight = 1.0;
  double x = x_m / wave_m;
  double y = y_m / wave_m;
  for (int i = 0; i < octaves; ++i) {
    sum += weight * lattice_noise(x, y, seed_ + static_cast<std::uint32_t>(i) * 0x9e3779b9U);
    variance += weight * weight;
    weight *= gain;
    // Turned by about 37 degrees from octave to octave, so that the lattices do not line up.
    const double turned = 2.0 * (0.8 * x - 0.6 * y);
    y = 2.0 * (0.6 * x + 0.8 * y);
    x = turned;
  }
  return sum / (kOctaveSigma * std::sqrt(variance));
}

Profile::Profile(double first_s_m, double step_m, std::vector<double> values)
    : first_s_m_(first_s_m), step_m_(step_m), values_(std::move(values)) {}

double Profile::at(double s_m) const {
  const double last = static_cast<double>(values_.size() - 1);
  const double t = std::clamp((s_m - first_s_m_) / step_m_, 0.0, last);
  const auto i = std::min(static_cast<std::size_t>(t), values_.size() < 2 ? 0 : values_.size() - 2);
  if (values_.size() < 2) {
    return values_.front();
  }
  const double u = t - static_cast<double>(i);
  const double b = values_[i];
  const double c = values_[i + 1];
  const double a = i > 0 ? values_[i - 1] : b;
  const double d = i + 2 < values_.size() ? values_[i + 2] : c;
  // Catmull-Rom.
  return b + 0.5 * u * (c - a + u * (2.0 * a - 5.0 * b + 4.0 * c - d + u * (3.0 * (b - c) + d - a)));
}

std::vector<double> smooth_random(std::size_t count, double wave, Random random) {
  const auto knots = static_cast<std::size_t>(static_cast<double>(count) / wave) + 5;
  std::vector<double> knot_values(knots);
  for (double& value : knot_values) {
    value = random.normal();
  }
  const double phase = random.uniform();
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / wave + phase;
    const auto k = static_cast<std::size_t>(t);
    const double u = t - static_cast<double>(k);
    // Uniform cubic B-spline: smooth with its curvature. 1.45 makes up for what it averages away.
    const double w0 = (1.0 - u) * (1.0 - u) * (1.0 - u) / 6.0;
    const double w1 = (3.0 * u * u * u - 6.0 * u * u + 4.0) / 6.0;
    const double w2 = (-3.0 * u * u * u + 3.0 * u * u + 3.0 * u + 1.0) / 6.0;
    const double w3 = u * u * u / 6.0;
    values[i] =
        1.45 * (w0 * knot_values[k] + w1 * knot_values[k + 1] + w2 * knot_values[k + 2] + w3 * knot_values[k + 3]);
  }
  return values;
}

void stretch_to(std::vector<double>& values, double low, double high) {
  const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
  const double from = *least;
  const double range = *greatest - from;
  for (double& value : values) {
    value = range > 0.0 ? low + (value - from) / range * (high - low) : 0.5 * (low + high);
  }
}

std::vector<double> smoothed(const std::vector<double>& values, double sigma) {
  const int reach = static_cast<int>(std::ceil(3.0 * sigma));
  std::vector<double> weights(static_cast<std::size_t>(2 * reach + 1));
  double sum = 0.0;
  for (int k = -reach; k <= reach; ++k) {
    const double weight = sigma > 0.0 ? std::exp(-0.5 * k * k / (sigma * sigma)) : 1.0;
    weights[static_cast<std::size_t>(k + reach)] = weight;
    sum += weight;
  }
  std::vector<double> result(values.size());
  const int last = static_cast<int>(values.size()) - 1;
  for (int i = 0; i <= last; ++i) {
    double total = 0.0;
    for (int k = -reach; k <= reach; ++k) {
      total +=
          weights[static_cast<std::size_t>(k + reach)] * values[static_cast<std::size_t>(std::clamp(i + k, 0, last))];
    }
    result[static_cast<std::size_t>(i)] = total / sum;
  }
  return result;
}

}  // namespace berm::sim
