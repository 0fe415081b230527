#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "beam_random.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/surface.hpp"

namespace berm::sim {

/// Corduroy: ridges of 2 cm from valley to top, 2.4 cm apart.
constexpr float kCorduroyHeight_m = 0.02F;
constexpr float kCorduroyPitch_m = 0.024F;

/// Below this cosine relief no longer grows along the ray: the tops of the relief hide the rest of it.
constexpr float kLeastCosine = 0.2F;

/// Relief within about this distance belongs together: crumbs, ruts of a track plate, stones.
constexpr float kReliefPatch_m = 0.05F;

// What is inlined by force here is for loops over many echoes: no branch, no call.

/// How wide and high a beam is.
struct Footprint {
  explicit Footprint(const OpticsConfig& optics)
      : aperture_m(static_cast<float>(optics.aperture_m)),
        width_rad(static_cast<float>(optics.divergence_x_mrad * 1e-3)),
        height_rad(static_cast<float>(optics.divergence_y_mrad * 1e-3)) {}

  [[nodiscard]] float width_m(float range_m) const { return aperture_m + width_rad * range_m; }
  [[nodiscard]] float height_m(float range_m) const { return aperture_m + height_rad * range_m; }

  float aperture_m;
  float width_rad;
  float height_rad;
};

/// B / A of Oren and Nayar: 0.9 is what infinite roughness tends to, 0.3 a roughness of 17 degrees.
[[nodiscard]] float roughness_of(Surface surface);

/// Light that a surface throws back at an angle, over that at normal incidence: Oren and Nayar 1994 for light that goes
/// back where it came from, A cos + B sin^2. Very rough (snow, gravel, crowns) it hardly depends on the angle, smooth
/// it is Lambert's cosine.
[[nodiscard, gnu::always_inline]] inline float shade(float roughness, float cosine) {
  return cosine + roughness * (1.0F - cosine * cosine);
}

/// 1/2 at signal 1, 98 % at 2.7, 2 % at 0.37.
[[nodiscard]] inline float detection_probability(float signal) {
  const float squared = signal * signal;
  // Of the form 1 - 1/..., because large signals overflow to infinity.
  return 1.0F - 1.0F / (1.0F + squared * squared);
}

/// Variance of the reported range. Its standard deviation is the sensor's, `sigma_m`, at good signal and twice that at
/// signal 1.
[[nodiscard, gnu::always_inline]] inline float range_variance_m2(float signal, float sigma_m) {
  return sigma_m * sigma_m * (1.0F + 3.0F / (signal > 0.1F ? signal : 0.1F));
}

/// Variance along the ray of relief too small for the mesh, averaged over the footprint.
[[nodiscard, gnu::always_inline]] inline float relief_variance_m2(float relief_m, float cosine, float footprint_m2) {
  const float bounded = cosine > kLeastCosine ? cosine : kLeastCosine;
  const float patches = 1.0F + footprint_m2 / (bounded * kReliefPatch_m * kReliefPatch_m);
  return relief_m * relief_m / (bounded * bounded * patches);
}

/// Mean of the cosine of the corduroy over a width: the sinc, up to where it has died away.
[[nodiscard, gnu::always_inline]] inline float corduroy_damping(float width_m) {
  const float turns = 0.5F * width_m / kCorduroyPitch_m;
  const bool is_narrow = turns < 1e-3F;
  const float bounded = is_narrow ? 1e-3F : turns;
  const float sinc = sin_turn(bounded - rounded(bounded)) / (2.0F * std::numbers::pi_v<float> * bounded);
  return is_narrow ? 1.0F : sinc;
}

/// A beam on corduroy.
struct OnRidges {
  float across_m;  ///< from the middle of the run, across the ridges
  float slope_x;   ///< change of across_m along x and y
  float slope_y;
  float dx;  ///< direction of the beam
  float dy;
  float width_m;   ///< of its footprint
  float length_m;  ///< of the footprint on the ground, in the direction of the beam
};

/// Height of the corduroy along the normal, averaged over the footprint: nearly 0 where that is some centimetres wide.
[[nodiscard, gnu::always_inline]] inline float corduroy_m(const OnRidges& at) {
  const float flat = std::sqrt(at.dx * at.dx + at.dy * at.dy);
  // Straight down there is no forward; the ridges then lie across the width.
  const bool is_steep = flat <= 1e-3F;
  const float forward_x = is_steep ? 1.0F : at.dx / (is_steep ? 1.0F : flat);
  const float forward_y = is_steep ? 0.0F : at.dy / (is_steep ? 1.0F : flat);
  const float across_width_m = at.width_m * std::abs(forward_x * at.slope_y - forward_y * at.slope_x);
  const float across_length_m = at.length_m * std::abs(forward_x * at.slope_x + forward_y * at.slope_y);
  // From two pitches on less than a sixth is left of 1 cm.
  const float most_m = across_width_m > across_length_m ? across_width_m : across_length_m;
  const bool is_wide = most_m > 2.0F * kCorduroyPitch_m;
  const float turns = at.across_m * (1.0F / kCorduroyPitch_m);
  const float ridge = cos_turn(turns - rounded(turns)) * corduroy_damping(is_wide ? 0.0F : across_width_m) *
                      corduroy_damping(is_wide ? 0.0F : across_length_m);
  return is_wide ? 0.0F : 0.5F * kCorduroyHeight_m * ridge;
}

/// Share of the light that is mirrored away; `straight` is that at normal incidence. It grows towards grazing angles as
/// Schlick 1994 has it, where the surface is smooth enough: that of water or paint, not that of asphalt.
[[nodiscard]] inline float mirrored(float straight, float cosine) {
  if (straight <= 0.0F) {
    return 0.0F;
  }
  const float grazing = 1.0F - std::clamp(cosine, 0.0F, 1.0F);
  const float squared = grazing * grazing;
  return straight * (1.0F + (1.0F - straight) * squared * squared * grazing);
}

}  // namespace berm::sim
