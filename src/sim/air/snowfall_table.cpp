#include "snowfall_table.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace berm::sim {
namespace {

/// Farther away no sensor has been seen to find flakes.
constexpr double kMaxRange = 100.0;
constexpr std::size_t kSteps = 2000;
constexpr std::size_t kQuantiles = 1024;
constexpr std::size_t kStepsPerKindTable = 10;
/// Spread of the logarithm of the reflectivity: crystals that happen to mirror against lumps that scatter.
constexpr double kLogSpread = 0.8;
/// Medians of eighths of a normal distribution.
constexpr std::array<double, 8> kNormalMedians = {-1.5341, -0.8871, -0.4888, -0.1573, 0.1573, 0.4888, 0.8871, 1.5341};

double interpolate(const std::vector<double>& table, double place) {
  const auto index = static_cast<std::size_t>(place);
  if (index + 1 >= table.size()) {
    return table.back();
  }
  return table[index] + (place - static_cast<double>(index)) * (table[index + 1] - table[index]);
}

}  // namespace

SnowfallTable::SnowfallTable(const SnowfallConfig& snowfall, const OpticsConfig& optics)
    : snowfall_(snowfall), optics_(optics), limit_(optics.detection_limit()) {
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    reflectivity_[kind] =
        std::min(1.0, snowfall.flake_reflectivity * std::exp(kLogSpread * kNormalMedians[kind % kBrightnesses]));
    const std::size_t place = kind / kBrightnesses;
    gain_[kind] = (static_cast<double>(place) + 0.5) * 2.0 / kPlaces;
  }
  tabulate();
}

// Share covered = gain D^2 / ((a + D)(b + D)) must reach `share`: a quadratic equation for D.
double SnowfallTable::least_diameter_m(std::size_t kind, double range_m) const {
  constexpr double kNever = 1e3;
  const double bare = received_light(optics_, reflectivity_[kind], 1.0, range_m);
  const double share = limit_ / std::max(bare, 1e-30);
  const double q = share / gain_[kind];
  if (share >= 1.0 || q >= 1.0) {
    return kNever;
  }
  const double a = optics_.aperture_m + optics_.divergence_x_mrad * 1e-3 * range_m;
  const double b = optics_.aperture_m + optics_.divergence_y_mrad * 1e-3 * range_m;
  const double half = q * (a + b) / 2.0;
  return (half + std::sqrt(half * half + (1.0 - q) * q * a * b)) / (1.0 - q);
}

// Integral of pi/4 (a + D)(b + D) over exponentially distributed D from the least upwards, in closed form.
SnowfallTable::Parts SnowfallTable::parts(double least_m, double range_m) const {
  const double mean_m = snowfall_.mean_diameter_m;
  const double a = optics_.aperture_m + optics_.divergence_x_mrad * 1e-3 * range_m + least_m;
  const double b = optics_.aperture_m + optics_.divergence_y_mrad * 1e-3 * range_m + least_m;
  const double scale = std::numbers::pi / 4.0 * std::exp(-least_m / mean_m);
  return {scale * a * b, scale * mean_m * (a + b), scale * 2.0 * mean_m * mean_m};
}

double SnowfallTable::per_metre(double range_m, KindShares* shares) const {
  if (range_m < optics_.min_range_m || range_m > optics_.max_range_m) {
    return 0.0;
  }
  double sum = 0.0;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    const Parts kind_parts = parts(least_diameter_m(kind, range_m), range_m);
    sum += (kind_parts[0] + kind_parts[1] + kind_parts[2]) / kKinds;
    if (shares != nullptr) {
      (*shares)[kind] = static_cast<float>(sum);
    }
  }
  return sum;
}

void SnowfallTable::tabulate() {
  step_m_ = std::min(kMaxRange, optics_.max_range_m) / kSteps;
  expected_.resize(kSteps + 1);
  for (std::size_t step = 0; step < kSteps; ++step) {
    KindShares* shares = step % kStepsPerKindTable == 0 ? &kinds_.emplace_back() : nullptr;
    expected_[step + 1] = expected_[step] + per_metre((static_cast<double>(step) + 0.5) * step_m_, shares) * step_m_;
  }
  steps_.resize(kQuantiles + 1);
  std::size_t step = 0;
  for (std::size_t i = 0; i <= kQuantiles; ++i) {
    const double flakes = expected_.back() * static_cast<double>(i) / kQuantiles;
    while (step + 1 < kSteps && expected_[step + 1] <= flakes) {
      ++step;
    }
    steps_[i] = static_cast<std::uint16_t>(step);
  }
}

double SnowfallTable::expected(double range_m) const {
  return interpolate(expected_, std::max(range_m, 0.0) / step_m_);
}

// The inverse of `expected`: the equal parts say between which steps to look.
double SnowfallTable::range_of(double flakes) const {
  const auto part = std::min(static_cast<std::size_t>(flakes / expected_.back() * kQuantiles), kQuantiles - 1);
  const auto first = expected_.begin() + steps_[part] + 1;
  const auto last = expected_.begin() + steps_[part + 1] + 1;
  const auto end = std::upper_bound(first, last, flakes);
  const double from = *(end - 1);
  const double share = *end > from ? std::clamp((flakes - from) / (*end - from), 0.0, 1.0) : 0.0;
  return (static_cast<double>(end - 1 - expected_.begin()) + share) * step_m_;
}

Flake SnowfallTable::draw(double range_m, Random& random) const {
  const auto table = std::min(static_cast<std::size_t>(range_m / step_m_) / kStepsPerKindTable, kinds_.size() - 1);
  const KindShares& shares = kinds_[table];
  const auto sought = static_cast<float>(random.uniform()) * shares.back();
  const auto found = std::upper_bound(shares.begin(), shares.end() - 1, sought);
  const auto kind = static_cast<std::size_t>(found - shares.begin());

  // At the edge of what is found the table may name a kind that is just not found here: its least flake stands in.
  double diameter_m = std::min(least_diameter_m(kind, range_m), 0.05);
  const Parts kind_parts = parts(diameter_m, range_m);
  const double part = random.uniform() * (kind_parts[0] + kind_parts[1] + kind_parts[2]);
  const int terms = part < kind_parts[0] ? 1 : (part < kind_parts[0] + kind_parts[1] ? 2 : 3);
  for (int i = 0; i < terms; ++i) {
    diameter_m += snowfall_.mean_diameter_m * random.exponential();
  }
  const double a = optics_.aperture_m + optics_.divergence_x_mrad * 1e-3 * range_m + diameter_m;
  const double b = optics_.aperture_m + optics_.divergence_y_mrad * 1e-3 * range_m + diameter_m;
  const double share = std::min(1.0, gain_[kind] * diameter_m * diameter_m / (a * b));
  return {reflectivity_[kind], share, received_light(optics_, reflectivity_[kind], share, range_m)};
}

}  // namespace berm::sim
