#include "beams.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace berm {
namespace {

constexpr double kMinRepeatedShare = 0.005;
constexpr std::size_t kMinRepeated = 20;
constexpr std::size_t kMinBeams = 100;
constexpr double kTrimmedShare = 0.001;
constexpr std::size_t kAzimuthBins = 360;
constexpr std::size_t kMinBinsOfFullTurn = 342;
/// A cone has half-widths that agree within this, and nothing beyond this radius; a rectangle reaches 1.41 in its
/// corners.
constexpr double kCircleTolerance = 0.12;
constexpr double kCircleRadius = 1.15;
constexpr double kMaxShareOutsideCircle = 0.002;
constexpr auto kPi = std::numbers::pi_v<float>;

using Place = std::array<std::uint32_t, 3>;

Place place_of(float x, float y, float z) {
  return {std::bit_cast<std::uint32_t>(x), std::bit_cast<std::uint32_t>(y), std::bit_cast<std::uint32_t>(z)};
}

/// Value below which the share `share` of `values` lies; reorders them.
float quantile(std::vector<float>& values, double share) {
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

/// Start of the widest arc without beams, as the number of the first occupied bin behind it.
std::size_t bin_behind_widest_gap(const std::array<bool, kAzimuthBins>& occupied) {
  std::size_t best = 0;
  std::size_t best_length = 0;
  std::size_t length = 0;
  for (std::size_t i = 0; i < 2 * kAzimuthBins; ++i) {
    if (!occupied[i % kAzimuthBins]) {
      ++length;
      continue;
    }
    if (length > best_length) {
      best_length = length;
      best = i % kAzimuthBins;
    }
    length = 0;
  }
  return best;
}

/// Whether the beams fill an ellipse inside the rectangle `view`.
bool is_circular(std::span<const Beam> beams, const std::vector<float>& azimuths_rad, const FieldOfView& view) {
  const double half_width = 0.5 * (view.azimuth_max_rad - view.azimuth_min_rad);
  const double half_height = 0.5 * (view.elevation_max_rad - view.elevation_min_rad);
  if (!(half_width > 0.0 && half_height > 0.0) ||
      std::abs(half_width - half_height) > kCircleTolerance * std::max(half_width, half_height)) {
    return false;
  }
  std::size_t outside = 0;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double u = (static_cast<double>(azimuths_rad[i]) - view.azimuth_min_rad) / half_width - 1.0;
    const double v = (static_cast<double>(beams[i].elevation_rad) - view.elevation_min_rad) / half_height - 1.0;
    outside += u * u + v * v > kCircleRadius * kCircleRadius ? 1U : 0U;
  }
  return static_cast<double>(outside) <= kMaxShareOutsideCircle * static_cast<double>(beams.size());
}

}  // namespace

PointCounts count_points(const PointsView& points) {
  PointCounts counts;
  counts.points = points.size();
  std::vector<Place> places;
  places.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float x = points.x[i];
    const float y = points.y[i];
    const float z = points.z[i];
    if (std::isnan(x) || std::isnan(y) || std::isnan(z)) {
      ++counts.nan;
    } else if (std::isinf(x) || std::isinf(y) || std::isinf(z)) {
      ++counts.no_return_inf;
    } else if (is_no_return(x, y, z)) {
      ++counts.no_return_zero;
    } else {
      places.push_back(place_of(x, y, z));
    }
  }
  std::sort(places.begin(), places.end());
  std::size_t longest = 0;
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    while (end < places.size() && places[end] == places[begin]) {
      ++end;
    }
    const std::size_t length = end - begin;
    counts.duplicates += length - 1;
    if (length > longest) {
      longest = length;
      const Place& p = places[begin];
      counts.repeated = RepeatedPoint{
          .position_m = {std::bit_cast<float>(p[0]), std::bit_cast<float>(p[1]), std::bit_cast<float>(p[2])},
          .share = static_cast<double>(length) / static_cast<double>(points.size())};
    }
  }
  if (longest < kMinRepeated || counts.repeated->share < kMinRepeatedShare) {
    counts.repeated.reset();
  } else {
    counts.duplicates -= longest - 1;
  }
  return counts;
}

std::vector<Beam> real_beams(const PointsView& points, const std::optional<RepeatedPoint>& repeated) {
  const std::array<float, 3> origin = repeated ? repeated->position_m : std::array<float, 3>{};
  std::vector<Beam> beams;
  beams.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float x = points.x[i] - origin[0];
    const float y = points.y[i] - origin[1];
    const float z = points.z[i] - origin[2];
    const float across = std::hypot(x, y);
    const float range = std::hypot(across, z);
    // Also false for NaN.
    if (!(range > 0.0F) || std::isinf(range) || is_no_return(points.x[i], points.y[i], points.z[i])) {
      continue;
    }
    beams.push_back({.index = static_cast<std::uint32_t>(i),
                     .azimuth_rad = std::atan2(y, x),
                     .elevation_rad = std::atan2(z, across),
                     .range_m = range});
  }
  return beams;
}

double angle_between_rad(const Beam& a, const Beam& b) {
  // Haversines keep their digits for small angles.
  const double half_elevation = 0.5 * (static_cast<double>(a.elevation_rad) - static_cast<double>(b.elevation_rad));
  const double half_azimuth = 0.5 * (static_cast<double>(a.azimuth_rad) - static_cast<double>(b.azimuth_rad));
  const double s = std::sin(half_elevation);
  const double t = std::sin(half_azimuth);
  const double h =
      s * s + std::cos(static_cast<double>(a.elevation_rad)) * std::cos(static_cast<double>(b.elevation_rad)) * t * t;
  return 2.0 * std::asin(std::sqrt(std::min(1.0, h)));
}

std::optional<FieldOfView> field_of_view(std::span<const Beam> beams) {
  if (beams.size() < kMinBeams) {
    return std::nullopt;
  }
  std::array<bool, kAzimuthBins> occupied{};
  for (const Beam& beam : beams) {
    const auto bin = static_cast<std::size_t>((beam.azimuth_rad + kPi) / (2.0F * kPi) * kAzimuthBins);
    occupied[std::min(bin, kAzimuthBins - 1)] = true;
  }
  FieldOfView view;
  view.full_turn =
      std::count(occupied.begin(), occupied.end(), true) >= static_cast<std::ptrdiff_t>(kMinBinsOfFullTurn);
  const std::size_t first_bin = bin_behind_widest_gap(occupied);
  const float start_rad = static_cast<float>(first_bin) / kAzimuthBins * 2.0F * kPi - kPi;
  std::vector<float> azimuths_rad;
  std::vector<float> elevations_rad;
  for (const Beam& beam : beams) {
    azimuths_rad.push_back(beam.azimuth_rad < start_rad ? beam.azimuth_rad + 2.0F * kPi : beam.azimuth_rad);
    elevations_rad.push_back(beam.elevation_rad);
  }
  std::vector<float> sorted_rad = azimuths_rad;
  view.azimuth_min_rad = static_cast<double>(quantile(sorted_rad, kTrimmedShare));
  view.azimuth_max_rad = static_cast<double>(quantile(sorted_rad, 1.0 - kTrimmedShare));
  view.elevation_min_rad = static_cast<double>(quantile(elevations_rad, kTrimmedShare));
  view.elevation_max_rad = static_cast<double>(quantile(elevations_rad, 1.0 - kTrimmedShare));
  // Cut at a gap behind the sensor, the numbers would exceed 180 deg; name the front as people do.
  if (view.azimuth_min_rad > static_cast<double>(kPi)) {
    view.azimuth_min_rad -= 2.0 * static_cast<double>(kPi);
    view.azimuth_max_rad -= 2.0 * static_cast<double>(kPi);
  }
  view.circular = !view.full_turn && is_circular(beams, azimuths_rad, view);
  return view;
}

}  // namespace berm
