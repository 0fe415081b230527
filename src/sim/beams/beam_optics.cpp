#include "beam_optics.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beam_random.hpp"

namespace berm::sim {
namespace {

/// Relief within about this distance belongs together: crumbs, ruts of a track plate, stones.
constexpr float kReliefPatch_m = 0.05F;

/// B / A of Oren and Nayar: 0.9 is what infinite roughness tends to, 0.3 a roughness of 17 degrees.
float roughness_of(Surface surface) {
  switch (surface) {
    case Surface::groomed_snow:
    case Surface::rough_snow:
    case Surface::foliage:
    case Surface::net:
      return 0.9F;
    case Surface::gravel:
    case Surface::rock:
    case Surface::bark:
      return 0.6F;
    case Surface::asphalt:
    case Surface::concrete:
      return 0.3F;
    case Surface::water:
    case Surface::metal:
    case Surface::paint:
    case Surface::cloth:
      break;
  }
  return 0.0F;
}

/// Mean of a cosine of this pitch over a width: the sinc, up to where it has died away.
float damping(float width_m) {
  const float turns = 0.5F * width_m / kCorduroyPitch_m;
  if (turns < 1e-3F) {
    return 1.0F;
  }
  return sin_turn(turns - rounded(turns)) / (2.0F * std::numbers::pi_v<float> * turns);
}

float footprint_m(double divergence_mrad, float range_m, const OpticsConfig& optics) {
  return static_cast<float>(optics.aperture_m) + static_cast<float>(divergence_mrad * 1e-3) * range_m;
}

}  // namespace

float shade(Surface surface, float cosine) {
  return cosine + roughness_of(surface) * (1.0F - cosine * cosine);
}

float relief_variance_m2(const SurfaceOptics& surface, float cosine, float range_m, const OpticsConfig& optics) {
  const auto relief_m = static_cast<float>(surface.relief_m);
  const float bounded = std::max(cosine, kLeastCosine);
  const float footprint_m2 =
      footprint_m(optics.divergence_x_mrad, range_m, optics) * footprint_m(optics.divergence_y_mrad, range_m, optics);
  const float patches = 1.0F + footprint_m2 / (bounded * kReliefPatch_m * kReliefPatch_m);
  return relief_m * relief_m / (bounded * bounded * patches);
}

float corduroy_m(const Hit& hit, const Eigen::Vector3f& direction, float cosine, const OpticsConfig& optics) {
  const auto range_m = static_cast<float>(hit.range_m);
  const float width_m = footprint_m(optics.divergence_x_mrad, range_m, optics);
  const float length_m = footprint_m(optics.divergence_y_mrad, range_m, optics) / std::max(cosine, kLeastCosine);
  const float flat = direction.head<2>().norm();
  // Straight down there is no forward; the ridges then lie across the width.
  const Eigen::Vector2f forward =
      flat > 1e-3F ? Eigen::Vector2f(direction.head<2>() / flat) : Eigen::Vector2f(1.0F, 0.0F);
  const Eigen::Vector2f aside{-forward.y(), forward.x()};
  const float across_width_m = width_m * std::abs(aside.dot(hit.across_slope));
  const float across_length_m = length_m * std::abs(forward.dot(hit.across_slope));
  // From two pitches on less than a sixth is left of 1 cm.
  if (std::max(across_width_m, across_length_m) > 2.0F * kCorduroyPitch_m) {
    return 0.0F;
  }
  const double turns = hit.across_m / static_cast<double>(kCorduroyPitch_m);
  const float ridge = cos_turn(static_cast<float>(turns - rounded(turns)));

  return 0.5F * kCorduroyHeight_m * ridge * damping(across_width_m) * damping(across_length_m);
}

}  // namespace berm::sim
