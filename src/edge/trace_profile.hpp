#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace berm {

/// Heights above the road along one unbroken piece of a trace, in the direction that it is walked.
class TraceProfile {
 public:
  /// A straight line of heights, h = height + slope * (s - s0).
  struct Line {
    float s0_m = 0.0F;
    float height_m = 0.0F;
    float slope = 0.0F;
    float variance_m2 = 0.0F;  ///< of the heights about it

    [[nodiscard]] float at(float s) const { return height_m + slope * (s - s0_m); }
    [[nodiscard]] float rms_m() const { return std::sqrt(variance_m2); }
  };

  void clear();
  void add(std::uint32_t at, float s, float h);

  [[nodiscard]] std::size_t size() const { return s_m.size(); }
  /// Least squares over the points [first, last]; level if they lie in one place.
  [[nodiscard]] Line fit(std::size_t first, std::size_t last) const {
    // Here, and with one division by the number: it runs twice per point of a scan.
    const Sums& a = sums_[first];
    const Sums& b = sums_[last + 1];
    const double share = 1.0 / static_cast<double>(last + 1 - first);
    const double s = (b.s - a.s) * share;
    const double h = (b.h - a.h) * share;
    const double ss = (b.ss - a.ss) * share - s * s;
    const double sh = (b.sh - a.sh) * share - s * h;
    const double hh = (b.hh - a.hh) * share - h * h;
    const double slope = ss > 1e-6 ? sh / ss : 0.0;
    return {.s0_m = static_cast<float>(s),
            .height_m = static_cast<float>(h),
            .slope = static_cast<float>(slope),
            .variance_m2 = static_cast<float>(std::max(hh - slope * sh, 0.0))};
  }

  std::vector<std::uint32_t> index;  ///< of the point in the traces
  std::vector<float> s_m;            ///< way on the map from the first point
  std::vector<float> h_m;            ///< above the surface of the road

 private:
  /// Of all points before one.
  struct Sums {
    double s = 0, h = 0, ss = 0, sh = 0, hh = 0;
  };
  std::vector<Sums> sums_;
};

}  // namespace berm
