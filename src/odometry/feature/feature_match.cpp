#include "feature_match.hpp"

#include <cmath>

namespace berm {
namespace {

/// sin(x) / x, (1 - cos(x)) / x^2 and (x - sin(x)) / x^3: the coefficients of Rodrigues' formula and of its derivative.
struct Rodrigues {
  double a;
  double b;
  double c;
};

Rodrigues rodrigues(double angle_rad2) {
  // Below, the first two terms of the series are exact to rounding.
  constexpr double kSmall = 1e-7;
  if (angle_rad2 < kSmall) {
    return {1.0 - angle_rad2 / 6.0, 0.5 - angle_rad2 / 24.0, 1.0 / 6.0 - angle_rad2 / 120.0};
  }
  const double angle = std::sqrt(angle_rad2);
  const double sine = std::sin(angle);
  return {sine / angle, (1.0 - std::cos(angle)) / angle_rad2, (angle - sine) / (angle_rad2 * angle)};
}

Eigen::Vector3d rotated(const Eigen::Vector3d& turn, const Rodrigues& r, const Eigen::Vector3d& v) {
  const Eigen::Vector3d once = turn.cross(v);
  return v + r.a * once + r.b * turn.cross(once);
}

}  // namespace

Eigen::Vector3d displaced_m(const Displacement& displacement, const Eigen::Vector3d& base_m, double share) {
  const Eigen::Vector3d turn = share * displacement.tail<3>();
  return rotated(turn, rodrigues(turn.squaredNorm()), base_m) + share * displacement.head<3>();
}

double residual_m(const FeatureMatch& match, const Displacement& displacement, Vector6d* gradient) {
  const Eigen::Vector3d turn = match.share * displacement.tail<3>();
  const Rodrigues r = rodrigues(turn.squaredNorm());
  const Eigen::Vector3d turned_m = rotated(turn, r, match.base_m);
  const Eigen::Vector3d from_anchor_m = turned_m + match.share * displacement.head<3>() - match.anchor_m;
  double distance_m = match.axis.dot(from_anchor_m);
  Eigen::Vector3d direction = match.axis;
  if (match.on_line) {
    direction = from_anchor_m - distance_m * match.axis;
    distance_m = direction.norm();
    // On the line itself every direction leads away from it, and none is better.
    direction = distance_m > 0.0 ? Eigen::Vector3d(direction / distance_m) : Eigen::Vector3d::Zero();
  }
  if (gradient != nullptr) {
    // d(exp(w) p) / dw = -[exp(w) p]x Jl(w), with the left Jacobian Jl = I + b [w]x + c [w]x^2.
    const Eigen::Vector3d torque_m = turned_m.cross(direction);
    const Eigen::Vector3d once = turn.cross(torque_m);
    gradient->head<3>() = match.share * direction;
    gradient->tail<3>() = match.share * (torque_m - r.b * once + r.c * turn.cross(once));
  }
  return distance_m;
}

}  // namespace berm
