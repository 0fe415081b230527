#include "road_median.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <utility>

namespace berm {
namespace {

/// Of normal errors: standard deviation over median of absolute values, and sigma of the median over that of the mean.
constexpr double kSigmaOverMad = 1.4826;
constexpr double kMedianOverMean = 1.2533;

}  // namespace

double median_of(std::vector<double> values) {
  if (values.empty()) {
    return 0.0;
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) {
    return *middle;
  }
  return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

std::optional<Measure> LookedValues::median(double least_scatter, double floor) const {
  if (values_.empty()) {
    return std::nullopt;
  }
  const double middle = median_of(values_);
  std::vector<double> off = values_;
  for (double& value : off) {
    value = std::abs(value - middle);
  }
  const double scatter = std::max(kSigmaOverMad * median_of(std::move(off)), least_scatter);
  const double random = kMedianOverMean * scatter / std::sqrt(std::popcount(looks_));
  return Measure{middle, std::hypot(random, floor)};
}

}  // namespace berm
