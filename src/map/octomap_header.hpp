#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "berm/geometry/voxel_hash.hpp"

namespace berm {

/// Nodes of a ColorOcTree in a file: float log-odds, three bytes of colour, a bit per child; children follow in order.
inline constexpr std::size_t kOctomapNodeBytes = 8;
/// Levels below the root; voxels are the last.
inline constexpr int kOctomapDepth = 16;
/// Keys of voxels: half of the range lies below the origin.
inline constexpr std::int32_t kOctomapHalfRange = 1 << (kOctomapDepth - 1);

/// What stands before the tree in an OctoMap file of berm.
struct OctomapHeader {
  VoxelKey origin;  ///< the voxel whose lower corner is OctoMap's origin
  std::string world;
  std::uint64_t nodes = 0;
  double voxel_m = 0.0;
};

/// The header with all its lines. Same values, same bytes.
[[nodiscard]] std::string write_octomap_header(const OctomapHeader& header);

struct ParsedOctomapHeader {
  OctomapHeader header;
  std::size_t bytes = 0;  ///< length of the header, that is where the tree starts
};

/// Comments of others are passed over. Throws FileError as `EdgeMap::from_octomap`: a line that is missing, double,
/// unknown or out of range, or a file that holds another number of nodes than it says.
[[nodiscard]] ParsedOctomapHeader parse_octomap_header(std::string_view bytes, const std::string& name);

}  // namespace berm
