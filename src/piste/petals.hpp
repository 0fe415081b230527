#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "berm/core/series.hpp"

namespace berm {

/// Cuts a scan into the petals of its rosette. phi, the angle between a beam and the boresight (+x of the sensor),
/// rises and falls once per petal (P eq. 9); a petal runs from one minimum of phi to the next. A minimum counts where
/// phi has come down by `min_rise` and goes up by `min_rise` again, so neither noise nor points of equal phi make
/// petals of their own. Keeps its memory.
class Petals {
 public:
  explicit Petals(double min_rise_rad);

  /// Where petals begin, rising, valid until the next call; the first is 0 whether or not phi has a minimum there. A
  /// scan of a sensor without a rosette can be one petal. Points at the sensor itself and NaN are passed over.
  [[nodiscard]] std::span<const std::size_t> find(const SeriesView& series);

 private:
  [[nodiscard]] bool is_above(float half_tan, float lower) const;
  void measure_angles(const SeriesView& series);

  float half_rise_tan_;
  std::vector<float> half_tans_;  ///< tan(phi / 2): rises with phi, and takes no arc function
  std::vector<std::size_t> begins_;
};

}  // namespace berm
