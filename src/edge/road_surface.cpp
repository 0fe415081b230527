#include "road_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Cholesky>

namespace berm {
namespace {

constexpr std::size_t kSamples = 1500;
constexpr float kFitReach_m = 28.0F;
constexpr float kMostMissed = 9.0F;  // squared, in scales: beyond, places say nothing
/// Scales of the residual, from doubt to certainty: ruts and gravel stay within the last.
constexpr std::array<float, 6> kScales_m{0.8F, 0.4F, 0.25F, 0.15F, 0.1F, 0.1F};
/// One sigma of the coefficients in units of 20 m before anything is seen, and how many places that is worth: the
/// machine stands on the plane.
constexpr std::array<double, 6> kPrior_m{0.15, 1.0, 1.0, 0.5, 0.5, 0.5};
constexpr double kPriorWeight = 3.0;

}  // namespace

void RoadSurface::fit(std::span<const float> x, std::span<const float> y, std::span<const float> z) {
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  reset();
  const std::size_t stride = std::max<std::size_t>(1, x.size() / kSamples);
  for (const float scale_m : kScales_m) {
    Eigen::Matrix<double, 6, 6> a = Eigen::Matrix<double, 6, 6>::Zero();
    Vector6 b = Vector6::Zero();
    for (std::size_t i = 0; i < 6; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      a(row, row) = kPriorWeight / (kPrior_m[i] * kPrior_m[i]);
    }
    for (std::size_t i = 0; i < x.size(); i += stride) {
      if (x[i] * x[i] + y[i] * y[i] > kFitReach_m * kFitReach_m) {
        continue;
      }
      const float missed = (z[i] - height_m(x[i], y[i])) / scale_m;
      if (missed * missed > kMostMissed) {
        continue;
      }
      const double u = double{x[i] * kPerMetre};
      const double v = double{y[i] * kPerMetre};
      Vector6 terms;
      terms << 1.0, u, v, u * u, u * v, v * v;
      const double weight = double{std::exp(-missed * missed)};
      a += weight * terms * terms.transpose();
      b += weight * double{z[i]} * terms;
    }
    c_ = a.llt().solve(b).cast<float>();
  }
}

}  // namespace berm
