#include "reweigh.hpp"

namespace berm {
namespace {

/// The middle one of `values`, which are not empty; they are reordered.
double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::vector<double> plausible(const PointsView& points) {
  constexpr double kFarthest = 20.0;
  std::vector<double> allowed(points.size(), 0.0);
  std::vector<std::size_t> finite;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (std::isfinite(points.x[i]) && std::isfinite(points.y[i]) && std::isfinite(points.z[i])) {
      finite.push_back(i);
    }
  }
  if (finite.empty()) {
    return allowed;
  }
  std::vector<double> values(finite.size());
  const auto median_of = [&](auto&& value_of) {
    std::transform(finite.begin(), finite.end(), values.begin(), value_of);
    return median(values);
  };
  const double x_m = median_of([&](std::size_t i) { return static_cast<double>(points.x[i]); });
  const double y_m = median_of([&](std::size_t i) { return static_cast<double>(points.y[i]); });
  const double z_m = median_of([&](std::size_t i) { return static_cast<double>(points.z[i]); });
  const auto distance_m = [&](std::size_t i) {
    return std::hypot(points.x[i] - x_m, points.y[i] - y_m, points.z[i] - z_m);
  };
  const double limit_m = kFarthest * median_of(distance_m);
  for (const std::size_t i : finite) {
    // Where most points are at one place, their median distance says nothing of the others.
    allowed[i] = limit_m <= 0.0 || distance_m(i) <= limit_m ? 1.0 : 0.0;
  }
  return allowed;
}

}  // namespace berm
