#pragma once

#include <cstddef>
#include <span>

namespace berm {

/// How thick the surfaces of a map are.
struct Sharpness {
  double mean_thickness_m = 0.0;    ///< over all patches: standard deviation of the points about their plane
  double median_thickness_m = 0.0;  ///< the same
  std::size_t patches = 0;
};

/// Mean plane thickness of a map: its points in cubes of `patch_m`, a plane through each that holds at least 10 points
/// spread in two directions. A wall seen twice from poses that disagree is thicker than one seen from true poses; a map
/// with flakes in the air has patches where there is no surface at all. Compare maps of one recording and one voxel
/// size. x, y, z: one value per point, m. Throws Error(invalid_argument) if they differ in length or `patch_m` is not
/// positive; points that are not finite are left out.
[[nodiscard]] Sharpness measure_sharpness(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                                          double patch_m = 0.5);

}  // namespace berm
