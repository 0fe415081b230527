#include "berm/map/edge_map.hpp"

namespace berm {

EdgeMap::EdgeMap(const EdgeMapConfig& config) : config_(config), voxels_(config.voxel_m) {
  config_.check();
}

}  // namespace berm
