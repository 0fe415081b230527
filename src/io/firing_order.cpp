#include "firing_order.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace berm {
namespace {

constexpr std::size_t kFewestBeams = 1000;
constexpr std::size_t kWindows = 128;
constexpr std::size_t kSamples = 2000;
constexpr std::size_t kMaxLag = 16;
/// A larger lag has to be clearly nearer than a smaller one to be preferred: beams that move steadily are nearest at 1.
constexpr double kClearlyNearer = 0.75;
/// A prime, so that pairs of points spread over the whole scan.
constexpr std::size_t kScatter = 7919;
// What real recordings of ten sensors show lies at most at half, at least at twice these values.
constexpr double kUnorderedShare = 0.2;
constexpr double kColumnElevationShare = 0.5;
constexpr double kColumnAzimuthShare = 0.15;
constexpr double kRingElevationShare = 0.1;
constexpr double kMinTurns = 1.5;
/// Fine enough to part the lasers of sensors with 128 rings, 0.11 deg apart.
constexpr double kElevationBin_rad = 0.02 * std::numbers::pi / 180.0;
constexpr double kTwoPi = 2.0 * std::numbers::pi;

double azimuth_step_rad(const Beam& from, const Beam& to) {
  return std::remainder(static_cast<double>(to.azimuth_rad) - static_cast<double>(from.azimuth_rad), kTwoPi);
}

double median(std::vector<double>& values) {
  if (values.empty()) {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double median_step_rad(std::span<const Beam> beams, std::size_t lag) {
  std::vector<double> steps;
  const std::size_t stride = std::max<std::size_t>(1, beams.size() / kSamples);
  for (std::size_t i = 0; i + lag < beams.size(); i += stride) {
    // Points in between that met nothing were left out: count them, so that lasers that take turns keep their turn.
    if (beams[i + lag].index == beams[i].index + lag) {
      steps.push_back(angle_between_rad(beams[i], beams[i + lag]));
    }
  }
  return steps.empty() ? std::numbers::pi : median(steps);
}

double random_step_rad(std::span<const Beam> beams) {
  std::vector<double> steps;
  const std::size_t stride = std::max<std::size_t>(1, beams.size() / kSamples);
  for (std::size_t i = 0; i < beams.size(); i += stride) {
    steps.push_back(angle_between_rad(beams[i], beams[(i * kScatter + beams.size() / 2) % beams.size()]));
  }
  return median(steps);
}

/// Runs of crowded bins in the histogram of elevations: one per laser, as long as its elevation does not change with
/// the azimuth.
int count_elevation_peaks(std::span<const Beam> beams) {
  const auto bins = static_cast<std::size_t>(std::numbers::pi / kElevationBin_rad) + 1;
  std::vector<std::size_t> histogram(bins, 0);
  for (const Beam& beam : beams) {
    const double share = static_cast<double>(beam.elevation_rad) / std::numbers::pi + 0.5;
    ++histogram[std::min(bins - 1, static_cast<std::size_t>(std::max(0.0, share) * static_cast<double>(bins)))];
  }
  const auto is_empty = [](std::size_t count) { return count == 0; };
  const auto first = std::find_if_not(histogram.begin(), histogram.end(), is_empty);
  const auto last = std::find_if_not(histogram.rbegin(), histogram.rend(), is_empty).base();
  const std::size_t mean = beams.size() / static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, last - first));
  int peaks = 0;
  bool crowded = false;
  for (const std::size_t count : histogram) {
    const bool now = count > mean;
    peaks += now && !crowded ? 1 : 0;
    crowded = now;
  }
  return peaks;
}

struct Extent {
  double azimuth_rad = 0.0;  ///< of the unwrapped path
  double elevation_rad = 0.0;
};

Extent extent(std::span<const Beam> beams) {
  double azimuth = 0.0;
  double low = 0.0;
  double high = 0.0;
  float lowest = beams.front().elevation_rad;
  float highest = lowest;
  for (std::size_t i = 1; i < beams.size(); ++i) {
    azimuth += azimuth_step_rad(beams[i - 1], beams[i]);
    low = std::min(low, azimuth);
    high = std::max(high, azimuth);
    lowest = std::min(lowest, beams[i].elevation_rad);
    highest = std::max(highest, beams[i].elevation_rad);
  }
  return {.azimuth_rad = std::min(high - low, kTwoPi), .elevation_rad = static_cast<double>(highest - lowest)};
}

void measure_windows(std::span<const Beam> beams, BeamMotion& motion) {
  const Extent whole = extent(beams);
  std::vector<double> azimuths;
  std::vector<double> elevations;
  for (std::size_t window = 0; window < kWindows; ++window) {
    const std::size_t begin = window * beams.size() / kWindows;
    const std::size_t end = (window + 1) * beams.size() / kWindows;
    const Extent part = extent(beams.subspan(begin, end - begin));
    azimuths.push_back(part.azimuth_rad);
    elevations.push_back(part.elevation_rad);
  }
  constexpr double kTiny = 1e-9;
  motion.azimuth_share = median(azimuths) / std::max(whole.azimuth_rad, kTiny);
  motion.elevation_share = median(elevations) / std::max(whole.elevation_rad, kTiny);
}

}  // namespace

std::optional<BeamMotion> measure_motion(std::span<const Beam> beams) {
  if (beams.size() < kFewestBeams) {
    return std::nullopt;
  }
  BeamMotion motion;
  std::vector<double> steps_rad;
  steps_rad.reserve(beams.size());
  for (std::size_t i = 1; i < beams.size(); ++i) {
    const double step_rad = azimuth_step_rad(beams[i - 1], beams[i]);
    motion.net_turns += step_rad / kTwoPi;
    motion.travelled_turns += std::abs(step_rad) / kTwoPi;
    steps_rad.push_back(std::abs(step_rad));
  }
  motion.stagger_rad = median(steps_rad);
  motion.best_step_rad = median_step_rad(beams, 1);
  for (std::size_t lag = 2; lag <= kMaxLag; ++lag) {
    const double step = median_step_rad(beams, lag);
    if (step < kClearlyNearer * motion.best_step_rad) {
      motion.best_step_rad = step;
      motion.best_lag = static_cast<int>(lag);
    }
  }
  motion.random_step_rad = random_step_rad(beams);
  measure_windows(beams, motion);
  return motion;
}

FiringOrder classify(const BeamMotion& motion) {
  if (motion.best_step_rad > kUnorderedShare * motion.random_step_rad) {
    return FiringOrder::unordered;
  }
  if (motion.elevation_share > kColumnElevationShare && motion.azimuth_share < kColumnAzimuthShare) {
    return FiringOrder::column_wise;
  }
  // Lasers that take turns in steering by prisms stay in a narrow band as well, but are nearest to themselves.
  if (motion.elevation_share < kRingElevationShare && motion.best_lag == 1) {
    return FiringOrder::ring_wise;
  }
  return FiringOrder::non_repeating;
}

std::optional<RingCount> count_rings(std::span<const std::uint16_t> ring, std::span<const Beam> beams,
                                     FiringOrder order, const BeamMotion& motion) {
  if (!ring.empty()) {
    std::vector<std::uint16_t> values(ring.begin(), ring.end());
    std::sort(values.begin(), values.end());
    const auto distinct = std::unique(values.begin(), values.end()) - values.begin();
    return RingCount{.count = static_cast<int>(distinct), .from_field = true};
  }
  // Every ring is one turn.
  if (order == FiringOrder::ring_wise && std::abs(motion.net_turns) >= kMinTurns) {
    return RingCount{.count = static_cast<int>(std::lround(std::abs(motion.net_turns))), .from_field = false};
  }
  if (order == FiringOrder::column_wise) {
    return RingCount{.count = count_elevation_peaks(beams), .from_field = false};
  }
  return std::nullopt;
}

}  // namespace berm
