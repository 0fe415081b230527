#include "berm/snow/repair.hpp"

#include <cstddef>

#include "berm/core/error.hpp"
#include "returns.hpp"

namespace berm {
namespace {

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
  x_.assign(points.x.begin(), points.x.end());
  y_.assign(points.y.begin(), points.y.end());
  z_.assign(points.z.begin(), points.z.end());
  interpolated_.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    interpolated_[i] = falling[i] != 0 || !is_usable(x_[i], y_[i], z_[i]) ? 1 : 0;
  }
  std::size_t begin = 0;
  while (begin < size) {
    if (interpolated_[begin] == 0) {
      ++begin;
      continue;
    }
    std::size_t end = begin + 1;
    while (end < size && interpolated_[end] != 0) {
      ++end;
    }
    fill_gap(x_, begin, end);
    fill_gap(y_, begin, end);
    fill_gap(z_, begin, end);
    begin = end;
  }
  return {.x = x_, .y = y_, .z = z_, .interpolated = interpolated_};
}

}  // namespace berm
