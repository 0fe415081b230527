#include "berm/eval/sharpness.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "berm/core/error.hpp"

namespace berm {
namespace {

constexpr std::size_t kLeastPoints = 10;
/// Least standard deviation along the second axis, as a share of the patch: a stalk is no plane.
constexpr double kLeastSpread = 0.12;
constexpr double kMostCubes = 1e9;

struct Place {
  std::int64_t x;
  std::int64_t y;
  std::int64_t z;
  std::size_t point;

  [[nodiscard]] bool is_beside(const Place& other) const { return x == other.x && y == other.y && z == other.z; }
};

/// Standard deviations along the thinnest and the middle axis, of points about their mean.
struct Spread {
  double thin_m = 0.0;
  double middle_m = 0.0;
};

Spread spread_of(const std::vector<Eigen::Vector3d>& points_m) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points_m) {
    mean += point;
  }
  mean /= static_cast<double>(points_m.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : points_m) {
    covariance += (point - mean) * (point - mean).transpose();
  }
  covariance /= static_cast<double>(points_m.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance, Eigen::EigenvaluesOnly);
  const auto deviation = [&solver](Eigen::Index i) { return std::sqrt(std::max(solver.eigenvalues()[i], 0.0)); };
  return {deviation(0), deviation(1)};
}

Sharpness summarize(std::vector<double> thicknesses_m) {
  Sharpness sharpness{.patches = thicknesses_m.size()};
  if (thicknesses_m.empty()) {
    return sharpness;
  }
  for (const double thickness_m : thicknesses_m) {
    sharpness.mean_thickness_m += thickness_m / static_cast<double>(thicknesses_m.size());
  }
  const auto middle = thicknesses_m.begin() + static_cast<std::ptrdiff_t>(thicknesses_m.size() / 2);
  std::nth_element(thicknesses_m.begin(), middle, thicknesses_m.end());
  sharpness.median_thickness_m = *middle;
  return sharpness;
}

}  // namespace

Sharpness measure_sharpness(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                            double patch_m) {
  if (x.size() != y.size() || x.size() != z.size() || !(patch_m > 0.0)) {
    throw Error(ErrorCode::invalid_argument, "sharpness: coordinates differ in length, or patches have no size");
  }
  std::vector<Place> places;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Eigen::Vector3d at = Eigen::Vector3d(x[i], y[i], z[i]) / patch_m;
    if (at.allFinite() && at.cwiseAbs().maxCoeff() < kMostCubes) {
      const auto cube = [&at](Eigen::Index axis) { return static_cast<std::int64_t>(std::floor(at[axis])); };
      places.push_back({cube(0), cube(1), cube(2), i});
    }
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return std::tie(a.x, a.y, a.z, a.point) < std::tie(b.x, b.y, b.z, b.point);
  });
  std::vector<double> thicknesses_m;
  std::vector<Eigen::Vector3d> points_m;
  for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
    points_m.clear();
    for (end = begin; end < places.size() && places[end].is_beside(places[begin]); ++end) {
      const std::size_t i = places[end].point;
      points_m.emplace_back(x[i], y[i], z[i]);
    }
    if (points_m.size() < kLeastPoints) {
      continue;
    }
    if (const Spread spread = spread_of(points_m); spread.middle_m >= kLeastSpread * patch_m) {
      thicknesses_m.push_back(spread.thin_m);
    }
  }
  return summarize(std::move(thicknesses_m));
}

}  // namespace berm
