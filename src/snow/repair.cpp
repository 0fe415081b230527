#include "berm/snow/repair.hpp"

#include <algorithm>
#include <cstddef>

#include "berm/core/error.hpp"
#include "berm/core/multiversion.hpp"
#include "returns.hpp"

namespace berm {
namespace {

/// Copies the points and marks the gaps.
BERM_MULTIVERSION void find_gaps(const PointsView& points, std::span<const std::uint8_t> falling, float* x, float* y,
                                 float* z, std::uint8_t* gap) {
  const std::size_t size = points.size();
  const std::uint8_t* flake = falling.data();
  for (std::size_t i = 0; i < size; ++i) {
    x[i] = points.x[i];
    y[i] = points.y[i];
    z[i] = points.z[i];
    gap[i] = static_cast<std::uint8_t>((flake[i] != 0) | !is_usable(x[i], y[i], z[i]));
  }
}

/// Fills [begin, end) of one coordinate between its neighbours; with n - m + 2 steps from one to the other (P eq. 1).
void fill_gap(std::vector<float>& values, std::size_t begin, std::size_t end) {
  const bool has_before = begin > 0;
  const bool has_after = end < values.size();
  const float before = has_before ? values[begin - 1] : has_after ? values[end] : 0.0F;
  const float after = has_after ? values[end] : before;
  const auto steps = static_cast<float>(end - begin + 1);
  for (std::size_t i = begin; i < end; ++i) {
    values[i] = before + (after - before) * (static_cast<float>(i - begin + 1) / steps);
  }
}

}  // namespace

SeriesView SeriesRepair::process(const PointsView& points, std::span<const std::uint8_t> falling) {
  const std::size_t size = points.size();
  if (falling.size() != size) {
    throw Error(ErrorCode::invalid_argument, "SeriesRepair: one mark per point is needed");
  }
  for (auto* channel : {&x_, &y_, &z_}) {
    channel->resize(size);
  }
  interpolated_.resize(size);
  find_gaps(points, falling, x_.data(), y_.data(), z_.data(), interpolated_.data());
  const auto first = interpolated_.begin();
  const auto last = interpolated_.end();
  for (auto begin = std::find(first, last, 1); begin != last;) {
    const auto end = std::find(begin, last, 0);
    for (auto* channel : {&x_, &y_, &z_}) {
      fill_gap(*channel, static_cast<std::size_t>(begin - first), static_cast<std::size_t>(end - first));
    }
    begin = std::find(end, last, 1);
  }
  return {.x = x_, .y = y_, .z = z_, .interpolated = interpolated_};
}

}  // namespace berm
