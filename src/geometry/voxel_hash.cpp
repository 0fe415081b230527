#include "berm/geometry/voxel_hash.hpp"

#include <cmath>
#include <string>

#include "berm/core/error.hpp"

namespace berm {

double detail::checked_voxel_m(double voxel_m) {
  if (!std::isfinite(voxel_m) || voxel_m <= 0.0) {
    throw Error(ErrorCode::invalid_argument,
                "voxel hash: voxels of " + std::to_string(voxel_m) + " m, expected a positive length");
  }
  return voxel_m;
}

}  // namespace berm
