#include "piste_surface.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <Eigen/Cholesky>

#include "berm/core/multiversion.hpp"

namespace berm {
namespace {

using Terms = PisteSurface::Terms;

constexpr double kScale_m = 20.0;       // unit of the polynomial: keeps its terms of one size
constexpr float kNoiseGrows_m = 10.0F;  // beyond, heights are known less well in proportion to the range
constexpr float kSlopeShare = 0.3F;     // slopes of neighbouring windows are not independent of their heights
constexpr float kMinSlopeLength_m = 0.25F;

/// Powers of x and y in each term.
struct Powers {
  int x = 0;
  int y = 0;
};
constexpr std::array<Powers, PisteSurface::kTerms> kPowers{
    {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}, {3, 0}, {2, 1}, {1, 2}, {0, 3}}};

/// Monomials x^i y^j up to a degree, by degree, then by the power of y.
constexpr std::size_t monomial(int x, int y) {
  const int degree = x + y;
  return static_cast<std::size_t>(degree * (degree + 1) / 2 + y);
}
constexpr std::size_t kHeightMonomials = monomial(0, 6) + 1;  // products of two terms
constexpr std::size_t kSlopeMonomials = monomial(0, 4) + 1;   // of two derivatives of terms
constexpr std::size_t kDerivatives = monomial(0, 2) + 1;

/// Sums over windows that the normal equations are made of: far fewer than these have entries, since all are products
/// of powers of the same two numbers.
struct Moments {
  std::array<double, kHeightMonomials> height{};  ///< weight * monomial
  std::array<double, PisteSurface::kTerms> height_z{};
  std::array<double, kSlopeMonomials> slope_uu{};  ///< weight * monomial * u^2, and so on: (u, v) is the direction
  std::array<double, kSlopeMonomials> slope_uv{};
  std::array<double, kSlopeMonomials> slope_vv{};
  std::array<double, kDerivatives> slope_ub{};  ///< with the slope b
  std::array<double, kDerivatives> slope_vb{};
};

/// A window as the fit sees it.
struct Sample {
  double x = 0.0;  ///< in units of the polynomial
  double y = 0.0;
  double z = 0.0;
  double u = 0.0;
  double v = 0.0;
  double slope = 0.0;
  double height_weight = 0.0;
  double slope_weight = 0.0;
};

BERM_MULTIVERSION void add_sample(const Sample& s, Moments& m) {
  std::array<double, kHeightMonomials> p;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled below
  p[0] = 1.0;
  for (std::size_t degree = 1, at = 1; degree <= 6; ++degree) {
    const std::size_t before = at - degree;
    for (std::size_t j = 0; j < degree; ++j) {
      p[at + j] = p[before + j] * s.x;
    }
    p[at + degree] = p[at - 1] * s.y;
    at += degree + 1;
  }
  for (std::size_t i = 0; i < m.height.size(); ++i) {
    m.height[i] += s.height_weight * p[i];
  }
  const double wz = s.height_weight * s.z;
  for (std::size_t i = 0; i < m.height_z.size(); ++i) {
    m.height_z[i] += wz * p[i];
  }
  const double uu = s.slope_weight * s.u * s.u;
  const double uv = s.slope_weight * s.u * s.v;
  const double vv = s.slope_weight * s.v * s.v;
  for (std::size_t i = 0; i < m.slope_uu.size(); ++i) {
    m.slope_uu[i] += uu * p[i];
    m.slope_uv[i] += uv * p[i];
    m.slope_vv[i] += vv * p[i];
  }
  const double ub = s.slope_weight * s.u * s.slope;
  const double vb = s.slope_weight * s.v * s.slope;
  for (std::size_t i = 0; i < m.slope_ub.size(); ++i) {
    m.slope_ub[i] += ub * p[i];
    m.slope_vb[i] += vb * p[i];
  }
}

/// factor * moments[x^i y^j]; 0 where a derivative of a constant has left no such monomial.
template <std::size_t n>
double pick(const std::array<double, n>& moments, int factor, int x, int y) {
  return x < 0 || y < 0 || monomial(x, y) >= n ? 0.0 : factor * moments[monomial(x, y)];
}

/// The normal equations: entry (r, c) sums the products of the terms r and c, or of their derivatives along (u, v).
void assemble(const Moments& m, Eigen::Matrix<double, PisteSurface::kTerms, PisteSurface::kTerms>& a, Terms& b) {
  for (std::size_t r = 0; r < kPowers.size(); ++r) {
    const Powers p = kPowers[r];
    const auto row = static_cast<Eigen::Index>(r);
    for (std::size_t c = 0; c < kPowers.size(); ++c) {
      const Powers q = kPowers[c];
      const int x = p.x + q.x;
      const int y = p.y + q.y;
      a(row, static_cast<Eigen::Index>(c)) = m.height[monomial(x, y)] + pick(m.slope_uu, p.x * q.x, x - 2, y) +
                                             pick(m.slope_uv, p.x * q.y + p.y * q.x, x - 1, y - 1) +
                                             pick(m.slope_vv, p.y * q.y, x, y - 2);
    }
    b[row] = m.height_z[monomial(p.x, p.y)] + pick(m.slope_ub, p.x, p.x - 1, p.y) + pick(m.slope_vb, p.y, p.x, p.y - 1);
  }
}

/// One sigma of the coefficients before anything is seen: the frame is level, a slope turns by 0.05 per 20 m or so.
Terms prior_information() {
  Terms sigma;
  sigma << 1.0, 3.0, 3.0, 0.5, 0.5, 0.5, 0.2, 0.2, 0.2, 0.2;
  return sigma.array().square().inverse();
}

BERM_MULTIVERSION void compare_windows(const TraceWindows& windows, const std::array<float, PisteSurface::kTerms>& c,
                                       float* height_residual_m, float* slope_residual) {
  constexpr auto kPerMetre = static_cast<float>(1.0 / kScale_m);
  const std::size_t size = windows.size();
  for (std::size_t i = 0; i < size; ++i) {
    const float x = windows.x[i] * kPerMetre;
    const float y = windows.y[i] * kPerMetre;
    const float z = c[0] + x * (c[1] + x * (c[3] + x * c[6])) + y * (c[2] + y * (c[5] + y * c[9])) +
                    x * y * (c[4] + x * c[7] + y * c[8]);
    const float dz_dx = c[1] + x * (2.0F * c[3] + 3.0F * x * c[6]) + y * (c[4] + 2.0F * x * c[7] + y * c[8]);
    const float dz_dy = c[2] + y * (2.0F * c[5] + 3.0F * y * c[9]) + x * (c[4] + x * c[7] + 2.0F * y * c[8]);
    height_residual_m[i] = std::abs(windows.z[i] - z);
    slope_residual[i] =
        std::abs(windows.slope[i] - kPerMetre * (dz_dx * windows.along_x[i] + dz_dy * windows.along_y[i]));
  }
}

float cauchy(float residual, float scale) {
  return 1.0F / (1.0F + residual * residual / (4.0F * scale * scale));
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

void PisteSurface::compare(const TraceWindows& windows, std::span<float> height_residual_m,
                           std::span<float> slope_residual) const {
  std::array<float, kTerms> c;  // NOLINT(cppcoreguidelines-pro-type-member-init): filled below
  for (std::size_t i = 0; i < c.size(); ++i) {
    c[i] = static_cast<float>(coefficients_[static_cast<Eigen::Index>(i)]);
  }
  compare_windows(windows, c, height_residual_m.data(), slope_residual.data());
}

double PisteSurface::variance(const Terms& terms) const {
  return terms.dot(information_.llt().solve(terms));
}

void PisteSurface::reset() {
  coefficients_.setZero();
  information_ = prior_information().asDiagonal();
}

void PisteSurface::fit(const TraceWindows& windows, std::span<const std::uint8_t> is_piste,
                       std::span<const float> height_residual_m, std::span<const float> slope_residual,
                       const Noise& noise) {
  const auto height_noise = static_cast<float>(noise.height_m);
  const auto slope_noise = static_cast<float>(noise.slope);
  const bool is_first = height_residual_m.empty();
  Moments moments;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (is_piste[i] == 0) {
      continue;
    }
    const float length = windows.length_m[i];
    const float sigma = height_noise * std::max(1.0F, windows.range_m[i] / kNoiseGrows_m);
    const float missed = is_first ? 1.0F : cauchy(height_residual_m[i], height_noise);
    const float turned = is_first ? 1.0F : cauchy(slope_residual[i], slope_noise);
    Sample sample{.x = double{windows.x[i]} / kScale_m,
                  .y = double{windows.y[i]} / kScale_m,
                  .z = double{windows.z[i]},
                  .u = double{windows.along_x[i]} / kScale_m,
                  .v = double{windows.along_y[i]} / kScale_m,
                  .slope = double{windows.slope[i]},
                  .height_weight = double{missed * std::min(1.0F, length) / (sigma * sigma)}};
    if (length > kMinSlopeLength_m) {
      sample.slope_weight = double{turned * kSlopeShare / (slope_noise * slope_noise)};
    }
    add_sample(sample, moments);
  }
  Terms right;
  assemble(moments, information_, right);
  information_ += prior_information().asDiagonal();
  coefficients_ = information_.llt().solve(right);
}

}  // namespace berm
