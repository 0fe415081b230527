#include "base_series.hpp"

#include <algorithm>
#include <limits>

namespace berm {
namespace {

/// Makes room for `size` values between two pads of NaN, and gives the place of the first.
float* pad(std::vector<float>& values, std::size_t size) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  values.resize(size + 2 * BaseSeries::kReach);
  std::fill_n(values.begin(), BaseSeries::kReach, kNan);
  std::fill_n(values.rbegin(), BaseSeries::kReach, kNan);
  return values.data() + BaseSeries::kReach;
}

}  // namespace

void BaseSeries::assign(const SeriesView& series, const Pose& T_base_sensor) {
  size_ = series.size();
  float* const x = pad(x_, size_);
  float* const y = pad(y_, size_);
  float* const z = pad(z_, size_);
  const Eigen::Matrix3f R = T_base_sensor.rotation().toRotationMatrix().cast<float>();
  const Eigen::Vector3f t = T_base_sensor.translation_m().cast<float>();
  for (std::size_t i = 0; i < size_; ++i) {
    const Eigen::Vector3f p = R * Eigen::Vector3f(series.x[i], series.y[i], series.z[i]) + t;
    x[i] = p.x();
    y[i] = p.y();
    z[i] = p.z();
  }
}

std::span<const float> BaseSeries::inner(const std::vector<float>& padded, std::ptrdiff_t offset) const {
  if (size_ == 0) {
    return {};
  }
  return {padded.data() + static_cast<std::ptrdiff_t>(kReach) + offset, size_};
}

}  // namespace berm
