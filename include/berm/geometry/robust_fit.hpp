#pragma once

#include "berm/core/config.hpp"

namespace berm {

/// Robust fits reweigh the points again and again by Geman and McClure's function of their distance,
/// w = (s^2 / (s^2 + d^2))^2. The scale s starts where all points count and shrinks with each step to `scale_m`
/// (graduated non-convexity, Blake and Zisserman 1987), so that the start does not decide where the fit ends. It bears
/// about a third of points that agree on something else; where those are compact and far out, less.
/// Points more than 20 times as far from the middle of the points as their median have no say at all.
struct RobustFitConfig {
  double scale_m = 0.05;    ///< distance at which a point keeps a quarter of its weight: about twice the noise
  int max_iterations = 50;  ///< 40 steps lead from 50 km to 5 cm

  static void fields(auto&& field) {
    field("scale_m", &RobustFitConfig::scale_m, Range{1e-6, 100.0}, "distance at which a point keeps a quarter");
    field("max_iterations", &RobustFitConfig::max_iterations, Range{1, 1000}, "reweighings before giving up");
  }
  void check() const { check_fields(*this, "robust_fit"); }
};

}  // namespace berm
