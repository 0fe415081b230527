#pragma once

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
[[nodiscard]] float detection_probability(float signal);

/// Variance of the reported range. Its standard deviation is the sensor's at good signal and twice that at signal 1.
[[nodiscard]] float range_variance_m2(float signal, const OpticsConfig& optics);

/// Variance along the ray of relief too small for the mesh, averaged over the footprint.
[[nodiscard]] float relief_variance_m2(const SurfaceOptics& surface, float cosine, float range_m,
                                       const OpticsConfig& optics);

/// Height of the corduroy along the normal, averaged over the footprint: nearly 0 where that is some centimetres wide.
[[nodiscard]] float corduroy_m(const Hit& hit, const Eigen::Vector3f& direction, float cosine,
                               const OpticsConfig& optics);

/// Share of the light that is mirrored away. It grows towards grazing angles as Schlick 1994 has it, where the surface
/// is smooth enough: that of water or paint, not that of asphalt.
[[nodiscard]] float mirrored(const SurfaceOptics& surface, float cosine);

}  // namespace berm::sim
