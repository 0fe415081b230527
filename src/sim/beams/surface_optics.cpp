#include <array>
#include <cstddef>

#include "berm/sim/surface.hpp"

namespace berm::sim {
namespace {

// In the order of `Surface`: reflectivity, its sigma, relief, mirror.
constexpr std::array<SurfaceOptics, kSurfaces> kOptics = {{
    {100.0, 1.0, 0.004, 0.0},   // groomed_snow: a Livox reports 150 to 153 (P section 1), which is white on its scale
    {95.0, 5.0, 0.02, 0.0},     // rough_snow
    {8.0, 3.0, 0.003, 0.02},    // asphalt
    {20.0, 6.0, 0.015, 0.0},    // gravel
    {25.0, 10.0, 0.02, 0.0},    // rock
    {2.0, 1.0, 0.002, 0.98},    // water
    {30.0, 12.0, 0.03, 0.0},    // foliage
    {20.0, 8.0, 0.01, 0.0},     // bark
    {25.0, 10.0, 0.0, 0.0},     // net
    {45.0, 20.0, 0.001, 0.3},   // metal
    {40.0, 15.0, 0.001, 0.15},  // paint
    {60.0, 25.0, 0.005, 0.0},   // cloth
    {35.0, 6.0, 0.003, 0.0},    // concrete
}};

}  // namespace

const SurfaceOptics& optics_of(Surface surface) {
  return kOptics[static_cast<std::size_t>(surface)];
}

}  // namespace berm::sim
