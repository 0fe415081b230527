#include "plume_tree.hpp"

#include <algorithm>
#include <utility>

namespace berm::sim {
namespace {

constexpr std::size_t kLeafPlumes = 2;

}  // namespace

PlumeTree::PlumeTree(std::vector<Plume> plumes, double reach) : plumes_(std::move(plumes)) {
  if (!plumes_.empty()) {
    build(0, plumes_.size(), reach);
  }
}

// Halves along the longest side, until few are left.
void PlumeTree::build(std::size_t first, std::size_t end, double reach) {
  Node node{Eigen::Array3d::Constant(1e300), Eigen::Array3d::Constant(-1e300), 0, 0, 0};
  Eigen::Array3d low_m = node.low_m;
  Eigen::Array3d high_m = node.high_m;
  for (std::size_t i = first; i < end; ++i) {
    const Eigen::Array3d middle_m = plumes_[i].center_m.array();
    const Eigen::Array3d half_m = plumes_[i].sigma_m.array() * reach;
    node.low_m = node.low_m.min(middle_m - half_m);
    node.high_m = node.high_m.max(middle_m + half_m);
    low_m = low_m.min(middle_m);
    high_m = high_m.max(middle_m);
  }
  const std::size_t place = nodes_.size();
  nodes_.push_back(node);
  if (end - first <= kLeafPlumes) {
    nodes_[place].first = static_cast<std::uint32_t>(first);
    nodes_[place].end = static_cast<std::uint32_t>(end);
  } else {
    Eigen::Index axis = 0;
    (high_m - low_m).maxCoeff(&axis);
    std::stable_sort(plumes_.begin() + static_cast<std::ptrdiff_t>(first),
                     plumes_.begin() + static_cast<std::ptrdiff_t>(end),
                     [axis](const Plume& a, const Plume& b) { return a.center_m[axis] < b.center_m[axis]; });
    const std::size_t middle = first + (end - first) / 2;
    build(first, middle, reach);
    build(middle, end, reach);
  }
  nodes_[place].next = nodes_.size();
}

}  // namespace berm::sim
