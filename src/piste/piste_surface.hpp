#pragma once

#include <cstdint>
#include <span>

#include <Eigen/Core>

#include "trace_windows.hpp"

namespace berm {

/// The groomed surface as one cubic polynomial of the map, z(x, y) in the levelled frame: the machine that made it
/// leaves nothing shorter than a few of its own lengths, so that banks and natural ground stand out against it.
class PisteSurface {
 public:
  static constexpr int kTerms = 10;
  using Terms = Eigen::Matrix<double, kTerms, 1>;

  /// What heights and slopes of windows of a groomed surface differ from the polynomial by, one sigma.
  struct Noise {
    double height_m = 0.05;
    double slope = 0.06;
  };

  PisteSurface() { reset(); }
  /// Back to the level plane.
  void reset();
  /// Weighted least squares over heights and slopes of the windows whose `is_piste` is 1, drawn to the level plane
  /// where there is little to go by. Windows that the surface so far misses weigh less: the residuals are those of
  /// `compare`, or empty for no surface so far.
  void fit(const TraceWindows& windows, std::span<const std::uint8_t> is_piste,
           std::span<const float> height_residual_m, std::span<const float> slope_residual, const Noise& noise);

  [[nodiscard]] float height_m(float x_m, float y_m) const;
  /// How far each window lies from the surface, and by how much its slope differs; absolute values.
  void compare(const TraceWindows& windows, std::span<float> height_residual_m, std::span<float> slope_residual) const;

  /// Value and variance of a combination of the coefficients.
  [[nodiscard]] double value(const Terms& terms) const { return coefficients_.dot(terms); }
  [[nodiscard]] double variance(const Terms& terms) const;
  /// The combination that is the height at a place.
  [[nodiscard]] static Terms height_terms(double x_m, double y_m);
  /// The combination that is the rise per metre there, towards (along_x, along_y).
  [[nodiscard]] static Terms slope_terms(double x_m, double y_m, double along_x, double along_y);

 private:
  using Information = Eigen::Matrix<double, kTerms, kTerms>;

  Terms coefficients_;
  Information information_;
};

}  // namespace berm
