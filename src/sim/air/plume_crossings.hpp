#pragma once

#include <array>
#include <cstddef>

#include "plume_tree.hpp"

namespace berm::sim {

/// Sigmas from its middle to where a plume ends.
constexpr double kPlumeReach = 4.0;

/// The plumes that one beam passes: Gaussians along the beam, whose depths are error functions.
class PlumeCrossings {
 public:
  struct Place {
    float range_m;
    float extinction_per_m;
  };

  PlumeCrossings(const PlumeTree& tree, const AirBeam& beam);

  [[nodiscard]] bool is_empty() const { return count_ == 0; }
  /// One-way optical depth of the whole beam.
  [[nodiscard]] float total() const { return total_; }
  /// No place on the line of the beam has more extinction.
  [[nodiscard]] float most_per_m() const { return most_per_m_; }
  /// One-way optical depth from the sensor to a range.
  [[nodiscard]] float depth(float range_m) const;
  /// The place up to which the depth is `sought`, between 0 and `end_m`; `end_depth` is that of `end_m`, and more.
  [[nodiscard]] Place place_of(float sought, float end_m, float end_depth) const;

 private:
  [[nodiscard]] float extinction_per_m(float range_m) const;

  /// Groups that one beam can be in at once; more of them add nothing that could be seen.
  static constexpr std::size_t kMost = 16;

  /// Depth up to a range: half_depth * (erf(range * rate - middle) + erf(middle)), for four plumes.
  struct Crossing {
    Four half_depth;
    Four rate_per_m;
    Four middle;
  };

  void add(const PlumeGroup& group, const Eigen::Array3f& origin_m, const Eigen::Array3f& direction, float end_m);

  std::array<Crossing, kMost> crossings_;
  std::size_t count_ = 0;
  float before_ = 0.0F;  ///< of the sums of half_depth * erf(middle)
  float total_ = 0.0F;
  float most_per_m_ = 0.0F;
};

}  // namespace berm::sim
