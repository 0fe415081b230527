#pragma once

#include <algorithm>

#include "berm/sim/ray_caster.hpp"
#include "berm/sim/sensor.hpp"

namespace berm::sim {

/// Corduroy: ridges of 2 cm from valley to top, 2.4 cm apart.
constexpr float kCorduroyHeight_m = 0.02F;
constexpr float kCorduroyPitch_m = 0.024F;

/// Below this cosine relief no longer grows along the ray: the tops of the relief hide the rest of it.
constexpr float kLeastCosine = 0.2F;

/// Light that a surface throws back at an angle, over that at normal incidence: Oren and Nayar 1994 for light that goes
/// back where it came from, A cos + B sin^2. Very rough (snow, gravel, crowns) it hardly depends on the angle, smooth
/// it is Lambert's cosine.
[[nodiscard]] float shade(Surface surface, float cosine);

/// 1/2 at signal 1, 98 % at 2.7, 2 % at 0.37.
[[nodiscard]] inline float detection_probability(float signal) {
  const float squared = signal * signal;
  // Of the form 1 - 1/..., because large signals overflow to infinity.
  return 1.0F - 1.0F / (1.0F + squared * squared);
}

/// Variance of the reported range. Its standard deviation is the sensor's at good signal and twice that at signal 1.
[[nodiscard]] inline float range_variance_m2(float signal, const OpticsConfig& optics) {
  const auto sigma_m = static_cast<float>(optics.range_noise_m);
  return sigma_m * sigma_m * (1.0F + 3.0F / std::max(signal, 0.1F));
}

/// Variance along the ray of relief too small for the mesh, averaged over the footprint.
[[nodiscard]] float relief_variance_m2(const SurfaceOptics& surface, float cosine, float range_m,
                                       const OpticsConfig& optics);

/// Height of the corduroy along the normal, averaged over the footprint: nearly 0 where that is some centimetres wide.
[[nodiscard]] float corduroy_m(const Hit& hit, const Eigen::Vector3f& direction, float cosine,
                               const OpticsConfig& optics);

/// Share of the light that is mirrored away. It grows towards grazing angles as Schlick 1994 has it, where the surface
/// is smooth enough: that of water or paint, not that of asphalt.
[[nodiscard]] inline float mirrored(const SurfaceOptics& surface, float cosine) {
  const auto straight = static_cast<float>(surface.mirror);
  if (straight <= 0.0F) {
    return 0.0F;
  }
  const float grazing = 1.0F - std::clamp(cosine, 0.0F, 1.0F);
  const float squared = grazing * grazing;
  return straight * (1.0F + (1.0F - straight) * squared * squared * grazing);
}

}  // namespace berm::sim
