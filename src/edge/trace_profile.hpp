#pragma once

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
    float rms_m = 0.0F;

    [[nodiscard]] float at(float s) const { return height_m + slope * (s - s0_m); }
  };

  void clear();
  void add(std::uint32_t at, float s, float h);

  [[nodiscard]] std::size_t size() const { return s_m.size(); }
  /// Least squares over the points [first, last]; level if they lie in one place.
  [[nodiscard]] Line fit(std::size_t first, std::size_t last) const;

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
