#include "ring_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace berm {
namespace {

constexpr std::size_t kElevationBins = 1800;  // of 0.1 degrees
constexpr float kPi = std::numbers::pi_v<float>;

}  // namespace

std::span<const std::uint16_t> RingNumbers::process(const PointsView& points, std::span<const Label> labels,
                                                    int guessed_rings) {
  numbers_.assign(points.size(), 0);
  if (points.ring.empty() || !number_channel(points, labels)) {
    number_elevations(points, labels, guessed_rings);
  }
  return numbers_;
}

bool RingNumbers::number_channel(const PointsView& points, std::span<const Label> labels) {
  constexpr std::uint16_t kUnseen = 0;
  constexpr std::uint16_t kSeen = 1;
  compact_.assign(std::size_t{std::numeric_limits<std::uint16_t>::max()} + 1, kUnseen);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (is_solid(labels[i])) {
      compact_[points.ring[i]] = kSeen;
    }
  }
  count_ = 0;
  for (std::uint16_t& number : compact_) {
    if (number == kSeen) {
      number = static_cast<std::uint16_t>(count_++);
    }
  }
  if (count_ > kMaxRings) {
    return false;
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    numbers_[i] = is_solid(labels[i]) ? compact_[points.ring[i]] : std::uint16_t{0};
  }
  return true;
}

void RingNumbers::number_elevations(const PointsView& points, std::span<const Label> labels, int rings) {
  bins_.assign(kElevationBins, 0);
  elevation_bins_.assign(points.size(), 0);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (is_solid(labels[i])) {
      const float elevation_rad = std::atan2(points.z[i], std::hypot(points.x[i], points.y[i]));
      const float place = (elevation_rad / kPi + 0.5F) * static_cast<float>(kElevationBins);
      elevation_bins_[i] = static_cast<std::uint16_t>(std::clamp(place, 0.0F, static_cast<float>(kElevationBins - 1)));
      bins_[elevation_bins_[i]] = 1;
    }
  }
  if (!number_apart()) {
    number_evenly(rings);
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    numbers_[i] = is_solid(labels[i]) ? bins_[elevation_bins_[i]] : std::uint16_t{0};
  }
}

/// Beams of most spinning sensors have the elevations of a table, with nothing between.
bool RingNumbers::number_apart() {
  constexpr std::size_t kWidest = 4;
  count_ = 0;
  std::size_t width = 0;
  bool is_apart = true;
  scratch_.assign(bins_.begin(), bins_.end());
  for (std::uint16_t& bin : scratch_) {
    width = bin != 0 ? width + 1 : 0;
    count_ += width == 1 ? 1U : 0U;
    is_apart = is_apart && width <= kWidest;
    bin = static_cast<std::uint16_t>(count_ > 0 ? count_ - 1 : 0);
  }
  if (!is_apart || count_ > kMaxRings) {
    return false;
  }
  bins_.swap(scratch_);
  return true;
}

void RingNumbers::number_evenly(int rings) {
  const auto first = static_cast<std::size_t>(std::find(bins_.begin(), bins_.end(), 1) - bins_.begin());
  const auto behind = static_cast<std::size_t>(std::find(bins_.rbegin(), bins_.rend(), 1).base() - bins_.begin());
  count_ = static_cast<std::size_t>(rings);
  for (std::size_t i = first; i < behind; ++i) {
    bins_[i] = static_cast<std::uint16_t>((i - first) * count_ / (behind - first));
  }
}

}  // namespace berm
