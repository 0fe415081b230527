#include "surface_lanes.hpp"

#include "beam_optics.hpp"
#include "berm/core/multiversion.hpp"

namespace berm::sim {
namespace {

constexpr std::size_t kPacket = 8;

/// As `received_light`, of which this is the loop: 1 over the square of the range and what the near field takes.
[[gnu::always_inline]] inline float spread_light(float near_field_m2, float range_m) {
  constexpr float kMostLoss = 1e4F;
  const float squared = range_m * range_m;
  const float square = squared > 1e-6F ? squared : 1e-6F;
  const float near = near_field_m2 / square;
  const float cubed = near * near * near;
  return 1.0F / (square * (1.0F + (cubed < kMostLoss ? cubed : kMostLoss)));
}

BERM_MULTIVERSION void shade_lanes(const Footprint& beam, float near_field_m2, std::size_t count,
                                   SurfaceLanes& __restrict s) {
  const Footprint footprint = beam;
  for (std::size_t i = 0; i < count; ++i) {
    const float range_m = s.range_m[i];
    const float cosine = s.cosine[i];
    const float bounded = cosine > kLeastCosine ? cosine : kLeastCosine;
    const float width_m = footprint.width_m(range_m);
    const float height_m = footprint.height_m(range_m);
    const float ridge_m =
        corduroy_m({s.across_m[i], s.slope_x[i], s.slope_y[i], s.dx[i], s.dy[i], width_m, height_m / bounded});
    const float bright = s.share[i] * shade(s.roughness[i], cosine);
    s.echo_m[i] = range_m - s.ridges[i] * ridge_m / bounded;
    s.energy[i] = bright * s.reflectivity[i];
    s.light[i] = 0.01F * s.reflectivity[i] * s.share[i] * cosine * spread_light(near_field_m2, range_m);
    s.variance_m2[i] = relief_variance_m2(s.relief_m[i], cosine, width_m * height_m);
    s.spot_sigma[i] = bright * s.reflectivity_sigma[i];
  }
}

}  // namespace

void shade_all(const OpticsConfig& optics, SurfaceLanes& lanes) {
  // Whole packets: what lies in the lanes behind is never read.
  const std::size_t count = (lanes.count + kPacket - 1) / kPacket * kPacket;
  shade_lanes(Footprint(optics), static_cast<float>(optics.near_field_m * optics.near_field_m), count, lanes);
}

}  // namespace berm::sim
