#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "berm/core/label.hpp"
#include "berm/core/point_cloud.hpp"

namespace berm {

/// Whether the beam of `label` met something that stands on the ground or is the ground.
[[nodiscard]] constexpr bool is_solid(Label label) {
  return label == Label::drivable || label == Label::terrain || label == Label::obstacle;
}

/// Numbers the rings of a scan from the lowest, without gaps.
class RingNumbers {
 public:
  static constexpr std::size_t kMaxRings = 256;

  /// By the ring channel; by elevation where a scan has none, or one with more numbers than any sensor has lasers: by
  /// the elevations that there are if they lie apart, in `guessed_rings` equal steps if not. The result has a number
  /// for each solid point, and any for others; it is valid until the next call.
  [[nodiscard]] std::span<const std::uint16_t> process(const PointsView& points, std::span<const Label> labels,
                                                       int guessed_rings);
  [[nodiscard]] std::size_t count() const { return count_; }

 private:
  [[nodiscard]] bool number_channel(const PointsView& points, std::span<const Label> labels);
  void number_elevations(const PointsView& points, std::span<const Label> labels, int rings);
  [[nodiscard]] bool number_apart();
  void number_evenly(int rings);

  std::size_t count_ = 0;
  std::vector<std::uint16_t> numbers_;
  std::vector<std::uint16_t> compact_;
  std::vector<std::uint16_t> elevation_bins_;  ///< of points
  std::vector<std::uint16_t> bins_;            ///< 1 where there is a point, then the number of its ring
  std::vector<std::uint16_t> scratch_;
};

}  // namespace berm
