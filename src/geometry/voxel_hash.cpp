#include "berm/geometry/voxel_hash.hpp"

#include <cmath>
#include <string>

#include "berm/core/error.hpp"

namespace berm {
namespace {

/// Last step of splitmix64 (Steele, Lea, Flood 2014): every bit of the input changes half of the output.
std::uint64_t stir(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
  bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
  return bits ^ (bits >> 31U);
}

}  // namespace

std::optional<VoxelKey> voxel_key(const Eigen::Vector3d& point_m, double voxel_m) {
  const double x = std::floor(point_m.x() / voxel_m);
  const double y = std::floor(point_m.y() / voxel_m);
  const double z = std::floor(point_m.z() / voxel_m);
  // Compared as doubles, because casting NaN or what no integer holds is undefined.
  const auto countable = [](double value) { return std::abs(value) <= kMaxVoxelKey; };
  if (!countable(x) || !countable(y) || !countable(z)) {
    return std::nullopt;
  }
  return VoxelKey{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), static_cast<std::int32_t>(z)};
}

Eigen::Vector3d voxel_center_m(const VoxelKey& key, double voxel_m) {
  return {(key.x + 0.5) * voxel_m, (key.y + 0.5) * voxel_m, (key.z + 0.5) * voxel_m};
}

std::size_t VoxelKeyHash::operator()(const VoxelKey& key) const noexcept {
  const auto bits = [](std::int32_t value) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(value)); };
  return static_cast<std::size_t>(stir(stir(bits(key.x) | (bits(key.y) << 32U)) + bits(key.z)));
}

double detail::checked_voxel_m(double voxel_m) {
  if (!std::isfinite(voxel_m) || voxel_m <= 0.0) {
    throw Error(ErrorCode::invalid_argument,
                "voxel hash: voxels of " + std::to_string(voxel_m) + " m, expected a positive length");
  }
  return voxel_m;
}

}  // namespace berm
