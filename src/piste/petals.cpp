#include "petals.hpp"

#include <algorithm>
#include <cmath>

namespace berm {

Petals::Petals(double min_rise_rad) : half_rise_tan_(static_cast<float>(std::tan(min_rise_rad / 2.0))) {}

/// tan(phi / 2) = side / (r + x) = (r - x) / side: of the two the one that loses no digits, and right behind the sensor
/// a large number.
void Petals::measure_angles(const SeriesView& series) {
  constexpr float kRightBehind = 1e6F;
  half_tans_.resize(series.size());
  for (std::size_t i = 0; i < half_tans_.size(); ++i) {
    const float x = series.x[i];
    const float side_squared = series.y[i] * series.y[i] + series.z[i] * series.z[i];
    const float side = std::sqrt(side_squared);
    const float r = std::sqrt(x * x + side_squared);
    const float numerator = x < 0.0F ? r - x : side;
    const float denominator = x < 0.0F ? side : r + x;
    half_tans_[i] = std::min(numerator / denominator, kRightBehind);
  }
}

/// Whether phi lies `min_rise` above a lower one: tan(a - b) = (tan a - tan b) / (1 + tan a tan b).
bool Petals::is_above(float half_tan, float lower) const {
  return half_tan - lower > half_rise_tan_ * (1.0F + half_tan * lower);
}

std::span<const std::size_t> Petals::find(const SeriesView& series) {
  measure_angles(series);
  begins_.clear();
  if (half_tans_.empty()) {
    return begins_;
  }
  begins_.push_back(0);
  bool falls = false;
  std::size_t turn = 0;  // where phi was highest since the last minimum, or lowest since the last maximum
  float extreme = 0.0F;  // tan(phi / 2) there
  for (std::size_t i = 0; i < half_tans_.size(); ++i) {
    const float half_tan = half_tans_[i];
    const bool goes_on = falls ? half_tan < extreme : half_tan > extreme;
    const bool turned = falls ? is_above(half_tan, extreme) : is_above(extreme, half_tan);
    if (turned && falls) {
      begins_.push_back(turn);
    }
    if (goes_on || turned) {
      falls = falls != turned;
      turn = i;
      extreme = half_tan;
    }
  }
  return begins_;
}

}  // namespace berm
