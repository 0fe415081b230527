#include "plume_tree.hpp"

#include <algorithm>
#include <bit>

namespace berm::sim {
namespace {

constexpr std::size_t kLanes = 4;
/// Where no beam gets to.
constexpr float kFar_m = 1e12F;
/// Thinner plumes are as thick as this.
constexpr double kLeastSigma_m = 0.01;

using Iterator = std::vector<Plume>::iterator;

/// Halves along the longest side until four are left. The first half is a power of two, so that fours of fours, and
/// fours of those, lie together.
void sort_by_place(Iterator first, Iterator end) {
  const auto count = static_cast<std::size_t>(end - first);
  if (count <= kLanes) {
    return;
  }
  Eigen::Array3d low_m = first->center_m;
  Eigen::Array3d high_m = low_m;
  for (auto plume = first; plume != end; ++plume) {
    low_m = low_m.min(plume->center_m.array());
    high_m = high_m.max(plume->center_m.array());
  }
  Eigen::Index axis = 0;
  (high_m - low_m).maxCoeff(&axis);
  std::stable_sort(first, end, [axis](const Plume& a, const Plume& b) { return a.center_m[axis] < b.center_m[axis]; });
  const auto middle = first + static_cast<std::ptrdiff_t>(std::bit_floor(count - 1));
  sort_by_place(first, middle);
  sort_by_place(middle, end);
}

template <std::size_t kSize>
void fill(std::array<Four, kSize>& lanes, float value) {
  lanes.fill(Four::Constant(value));
}

}  // namespace

PlumeTree::PlumeTree(std::vector<Plume> plumes, double reach) {
  sort_by_place(plumes.begin(), plumes.end());
  std::vector<Box> level;
  for (std::size_t first = 0; first < plumes.size(); first += kLanes) {
    level.push_back(add_group({plumes.data() + first, std::min(kLanes, plumes.size() - first)}, reach));
  }
  while (level.size() > 1) {
    std::vector<Box> above;
    for (std::size_t first = 0; first < level.size(); first += kLanes) {
      above.push_back(add_node({level.data() + first, std::min(kLanes, level.size() - first)}));
    }
    level = std::move(above);
  }
  // A group that is alone has a node too: its box says which beams pass it.
  if (nodes_.empty() && !level.empty()) {
    add_node(level);
  }
}

PlumeTree::Box PlumeTree::add_group(std::span<const Plume> plumes, double reach) {
  PlumeGroup group;
  fill(group.center_m, kFar_m);
  fill(group.per_sigma, 1.0F);
  group.extinction_per_m = Four::Zero();
  Box box;
  for (std::size_t i = 0; i < plumes.size(); ++i) {
    const auto lane = static_cast<Eigen::Index>(i);
    const Plume& plume = plumes[i];
    const Eigen::Array3d sigma_m = plume.sigma_m.array().max(kLeastSigma_m);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto at = static_cast<Eigen::Index>(axis);
      group.center_m[axis][lane] = static_cast<float>(plume.center_m[at]);
      group.per_sigma[axis][lane] = static_cast<float>(1.0 / sigma_m[at]);
    }
    group.extinction_per_m[lane] = static_cast<float>(plume.extinction_per_m);
    box.low_m = box.low_m.min((plume.center_m.array() - reach * sigma_m).cast<float>());
    box.high_m = box.high_m.max((plume.center_m.array() + reach * sigma_m).cast<float>());
  }
  box.child = {static_cast<std::uint32_t>(groups_.size()), true};
  groups_.push_back(group);
  return box;
}

PlumeTree::Box PlumeTree::add_node(std::span<const Box> boxes) {
  Node node{};
  fill(node.low_m, kFar_m);
  fill(node.high_m, kFar_m);
  Box around;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.low_m[axis][static_cast<Eigen::Index>(i)] = boxes[i].low_m[static_cast<Eigen::Index>(axis)];
      node.high_m[axis][static_cast<Eigen::Index>(i)] = boxes[i].high_m[static_cast<Eigen::Index>(axis)];
    }
    node.children[i] = boxes[i].child;
    around.low_m = around.low_m.min(boxes[i].low_m);
    around.high_m = around.high_m.max(boxes[i].high_m);
  }
  around.child = {static_cast<std::uint32_t>(nodes_.size()), false};
  nodes_.push_back(node);
  return around;
}

}  // namespace berm::sim
