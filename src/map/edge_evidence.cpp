#include "edge_evidence.hpp"

#include <algorithm>

namespace berm {

EdgeEvidence::EdgeEvidence(const EdgeMap& map) : cells_(kCell_m) {
  map.for_each([&](const VoxelKey& key, const EdgeVoxel& voxel) {
    if (voxel.left == 0 && voxel.right == 0) {
      return;
    }
    samples_.push_back(
        {voxel_center_m(key, map.config().voxel_m), static_cast<float>(voxel.left), static_cast<float>(voxel.right)});
  });
  const auto cell_of = [](const EdgeSample& sample) {
    return std::pair(cell(sample.position_m.x()), cell(sample.position_m.y()));
  };
  std::stable_sort(samples_.begin(), samples_.end(),
                   [&](const EdgeSample& a, const EdgeSample& b) { return cell_of(a) < cell_of(b); });
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const auto [x, y] = cell_of(samples_[i]);
    auto& range = cells_.at_or_new({x, y, 0});
    if (range.second == 0) {
      range.first = static_cast<std::uint32_t>(i);
    }
    range.second = static_cast<std::uint32_t>(i + 1);
  }
}

}  // namespace berm
