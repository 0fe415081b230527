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

  /// Weighted least squares over heights and slopes of the windows whose `is_piste` is 1, drawn to the level plane
  /// where there is little to go by. Windows that an earlier fit of this surface misses weigh less.
  void fit(const TraceWindows& windows, std::span<const std::uint8_t> is_piste, const Noise& noise);
  void reset();

  [[nodiscard]] float height_m(float x_m, float y_m) const;
  /// Rise per metre towards (along_x, along_y).
  [[nodiscard]] float slope(float x_m, float y_m, float along_x, float along_y) const;

  /// Variance of what `terms` says: a height is `height_terms`.
  [[nodiscard]] double variance(const Terms& terms) const;
  [[nodiscard]] double value(const Terms& terms) const { return coefficients_.dot(terms); }
  [[nodiscard]] static Terms height_terms(double x_m, double y_m);
  [[nodiscard]] static Terms slope_terms(double x_m, double y_m, double along_x, double along_y);

 private:
  Terms coefficients_ = Terms::Zero();
  Eigen::Matrix<double, kTerms, kTerms> information_ = Eigen::Matrix<double, kTerms, kTerms>::Identity();
  bool is_fitted_ = false;
};

}  // namespace berm
