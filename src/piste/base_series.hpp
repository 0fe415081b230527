#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "berm/core/pose.hpp"
#include "berm/core/series.hpp"

namespace berm {

/// A repaired series in base_link, with room for the neighbours of points near its ends: there every coordinate is NaN,
/// and since no comparison with NaN is true, a neighbour beyond an end never counts. Keeps its memory.
class BaseSeries {
 public:
  /// The farthest neighbour that may be asked for.
  static constexpr std::size_t kReach = 16;

  void assign(const SeriesView& series, const Pose& T_base_sensor);

  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::span<const float> x() const { return inner(x_); }
  [[nodiscard]] std::span<const float> y() const { return inner(y_); }
  [[nodiscard]] std::span<const float> z() const { return inner(z_); }
  /// Coordinates of the points `offset` places later, one per point; |offset| <= kReach.
  [[nodiscard]] std::span<const float> x_later(std::ptrdiff_t offset) const { return inner(x_, offset); }
  [[nodiscard]] std::span<const float> z_later(std::ptrdiff_t offset) const { return inner(z_, offset); }

 private:
  [[nodiscard]] std::span<const float> inner(const std::vector<float>& padded, std::ptrdiff_t offset = 0) const;

  std::size_t size_ = 0;
  std::vector<float> x_;
  std::vector<float> y_;
  std::vector<float> z_;
};

}  // namespace berm
