#include "piste_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>

namespace berm {
namespace {

constexpr double kScale_m = 20.0;       // unit of the polynomial: keeps its terms of one size
constexpr double kNoiseGrows_m = 10.0;  // beyond, heights are known less well in proportion to the range

using Terms = PisteSurface::Terms;

/// One sigma of the coefficients before anything is seen: the frame is level, a slope turns by 0.05 per 20 m or so.
Terms prior_information() {
  Terms sigma;
  sigma << 1.0, 3.0, 3.0, 0.5, 0.5, 0.5, 0.2, 0.2, 0.2, 0.2;
  return sigma.array().square().inverse();
}

/// Normal equations, upper triangle only.
struct Normal {
  std::array<double, std::size_t{PisteSurface::kTerms} * PisteSurface::kTerms> a{};
  std::array<double, PisteSurface::kTerms> b{};

  void add(const Terms& terms, double value, double weight) {
    for (std::size_t row = 0; row < PisteSurface::kTerms; ++row) {
      const double scaled = weight * terms[static_cast<Eigen::Index>(row)];
      b[row] += scaled * value;
      for (std::size_t column = 0; column < PisteSurface::kTerms; ++column) {
        a[row * PisteSurface::kTerms + column] += scaled * terms[static_cast<Eigen::Index>(column)];
      }
    }
  }
};

double cauchy(double residual, double scale) {
  return 1.0 / (1.0 + residual * residual / (4.0 * scale * scale));
}

}  // namespace

Terms PisteSurface::height_terms(double x_m, double y_m) {
  const double x = x_m / kScale_m;
  const double y = y_m / kScale_m;
  Terms terms;
  terms << 1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
  return terms;
}

Terms PisteSurface::slope_terms(double x_m, double y_m, double along_x, double along_y) {
  const double x = x_m / kScale_m;
  const double y = y_m / kScale_m;
  const double u = along_x / kScale_m;
  const double v = along_y / kScale_m;
  Terms terms;
  terms << 0.0, u, v, 2.0 * x * u, y * u + x * v, 2.0 * y * v, 3.0 * x * x * u, 2.0 * x * y * u + x * x * v,
      y * y * u + 2.0 * x * y * v, 3.0 * y * y * v;
  return terms;
}

float PisteSurface::height_m(float x_m, float y_m) const {
  return static_cast<float>(value(height_terms(double{x_m}, double{y_m})));
}

float PisteSurface::slope(float x_m, float y_m, float along_x, float along_y) const {
  return static_cast<float>(value(slope_terms(double{x_m}, double{y_m}, double{along_x}, double{along_y})));
}

double PisteSurface::variance(const Terms& terms) const {
  return terms.dot(information_.llt().solve(terms));
}

void PisteSurface::reset() {
  coefficients_.setZero();
  information_ = prior_information().asDiagonal();
  is_fitted_ = false;
}

void PisteSurface::fit(const TraceWindows& windows, std::span<const std::uint8_t> is_piste, const Noise& noise) {
  constexpr double kSlopeShare = 0.3;  // slopes of neighbouring windows are not independent of their heights
  Normal normal;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (is_piste[i] == 0) {
      continue;
    }
    const double x = windows.x[i];
    const double y = windows.y[i];
    const double z = windows.z[i];
    const double length = windows.length_m[i];
    const double grows = std::max(1.0, windows.range_m[i] / kNoiseGrows_m);
    const Terms height = height_terms(x, y);
    const double height_sigma = noise.height_m * grows;
    const double missed = is_fitted_ ? cauchy(z - value(height), noise.height_m) : 1.0;
    normal.add(height, z, missed * std::min(1.0, length) / (height_sigma * height_sigma));
    if (length > 0.25) {
      const Terms slope = slope_terms(x, y, windows.along_x[i], windows.along_y[i]);
      const double turned = is_fitted_ ? cauchy(windows.slope[i] - value(slope), noise.slope) : 1.0;
      normal.add(slope, windows.slope[i], turned * kSlopeShare / (noise.slope * noise.slope));
    }
  }
  information_ = Eigen::Map<const Eigen::Matrix<double, kTerms, kTerms>>(normal.a.data());
  information_ += prior_information().asDiagonal();
  coefficients_ = information_.llt().solve(Eigen::Map<const Terms>(normal.b.data()));
  is_fitted_ = true;
}

}  // namespace berm
