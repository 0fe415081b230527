#include "plume_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace berm::sim {
namespace {

/// Groups that take less of the light than this are left out.
constexpr float kLeastDepth = 1e-6F;
/// Of the derivative of the error function.
constexpr float kSlope = 2.0F * std::numbers::inv_sqrtpi_v<float>;
/// A last step of Newton's that is this short leaves far less than the noise of any sensor: it squares what is off.
constexpr float kSettled_m = 5e-3F;

}  // namespace

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): a beam fills as many crossings as it reads
PlumeCrossings::PlumeCrossings(const PlumeTree& tree, const AirBeam& beam) {
  const Eigen::Array3f origin_m = beam.origin_m.cast<float>();
  const Eigen::Array3f direction = beam.direction.cast<float>();
  const auto end_m = static_cast<float>(beam.end_m);
  tree.visit(beam, [&](const PlumeGroup& group) { add(group, origin_m, direction, end_m); });
}

// In the frame where a plume is a unit sphere the beam is a line that passes its middle at a distance.
void PlumeCrossings::add(const PlumeGroup& group, const Eigen::Array3f& origin_m, const Eigen::Array3f& direction,
                         float end_m) {
  if (count_ == kMost) {
    return;
  }
  Four3 from;
  Four3 along;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    from[axis] = (origin_m[at] - group.center_m[axis]) * group.per_sigma[axis];
    along[axis] = direction[at] * group.per_sigma[axis];
  }
  const Four square = dot(along, along);
  const Four middle_m = -dot(from, along) / square;
  // From the nearest place itself: the difference of two squares would lose digits far away.
  const Four3 nearest = {from[0] + middle_m * along[0], from[1] + middle_m * along[1], from[2] + middle_m * along[2]};
  const Four peak_per_m = group.extinction_per_m * fade(0.5F * dot(nearest, nearest));
  const Four rate_per_m = (0.5F * square).sqrt();
  const Four half_depth = peak_per_m / (kSlope * rate_per_m);
  if (half_depth.sum() < 0.5F * kLeastDepth) {
    return;
  }
  const Four middle = middle_m * rate_per_m;
  const float before = (half_depth * error_function(middle)).sum();
  const float depth = before + (half_depth * error_function(end_m * rate_per_m - middle)).sum();
  if (depth < kLeastDepth) {
    return;
  }
  crossings_[count_++] = {half_depth, rate_per_m, middle};
  before_ += before;
  total_ += depth;
  most_per_m_ += peak_per_m.sum();
}

float PlumeCrossings::extinction_per_m(float range_m) const {
  Four sum = Four::Zero();
  for (std::size_t i = 0; i < count_; ++i) {
    const Crossing& crossing = crossings_[i];
    const Four place = range_m * crossing.rate_per_m - crossing.middle;
    sum += crossing.half_depth * crossing.rate_per_m * fade(place * place);
  }
  return kSlope * sum.sum();
}

float PlumeCrossings::depth(float range_m) const {
  Four sum = Four::Zero();
  for (std::size_t i = 0; i < count_; ++i) {
    const Crossing& crossing = crossings_[i];
    sum += crossing.half_depth * error_function(range_m * crossing.rate_per_m - crossing.middle);
  }
  return before_ + sum.sum();
}

// Newton's steps from what even air would give, halving where they leave.
PlumeCrossings::Place PlumeCrossings::place_of(float sought, float end_m, float end_depth) const {
  float low_m = 0.0F;
  float high_m = end_m;
  Place place{end_m * (sought / end_depth), 0.0F};
  for (int i = 0; i < 40 && high_m - low_m > kSettled_m; ++i) {
    place.extinction_per_m = extinction_per_m(place.range_m);
    const float excess = depth(place.range_m) - sought;
    const float step_m = excess / std::max(place.extinction_per_m, 1e-12F);
    const float next_m = place.range_m - step_m;
    (excess > 0.0F ? high_m : low_m) = place.range_m;
    if (std::abs(step_m) < kSettled_m) {
      place.range_m = std::clamp(next_m, 0.0F, end_m);
      break;
    }
    place.range_m = next_m > low_m && next_m < high_m ? next_m : 0.5F * (low_m + high_m);
  }
  return place;
}

}  // namespace berm::sim
