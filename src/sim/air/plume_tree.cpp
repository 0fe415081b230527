#include "plume_tree.hpp"

#include <algorithm>
#include <bit>

namespace berm::sim {
namespace {

constexpr std::size_t kChildren = 4;
/// Where no beam gets to.
constexpr float kEmptyBox_m = 1e12F;
/// Thinner plumes are as thick as this.
constexpr double kLeastSigma_m = 0.01;

using Iterator = std::vector<Plume>::iterator;

/// Halves along the longest side until four are left. The first half is a power of two, so that fours of fours, and
/// fours of those, lie together.
void sort_by_place(Iterator first, Iterator end) {
  const auto count = static_cast<std::size_t>(end - first);
  if (count <= kChildren) {
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

}  // namespace

PlumeTree::PlumeTree(std::vector<Plume> plumes, double reach) {
  sort_by_place(plumes.begin(), plumes.end());
  std::vector<Boxed> level;
  level.reserve(plumes.size());
  for (const Plume& plume : plumes) {
    level.push_back(add_plume(plume, reach));
  }
  // A plume that is alone has a node too: its box says which beams pass it.
  while (level.size() > 1 || (nodes_.empty() && !level.empty())) {
    std::vector<Boxed> above;
    for (std::size_t first = 0; first < level.size(); first += kChildren) {
      above.push_back(add_node({level.data() + first, std::min(kChildren, level.size() - first)}));
    }
    level = std::move(above);
  }
}

PlumeTree::Boxed PlumeTree::add_plume(const Plume& plume, double reach) {
  const Eigen::Array3d sigma_m = plume.sigma_m.array().max(kLeastSigma_m);
  PlumeShape shape{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto at = static_cast<Eigen::Index>(axis);
    shape.center_m[axis] = static_cast<float>(plume.center_m[at]);
    shape.per_sigma[axis] = static_cast<float>(1.0 / sigma_m[at]);
  }
  shape.extinction_per_m = static_cast<float>(plume.extinction_per_m);
  Boxed boxed;
  boxed.box.low_m = (plume.center_m.array() - reach * sigma_m).cast<float>();
  boxed.box.high_m = (plume.center_m.array() + reach * sigma_m).cast<float>();
  boxed.child = {static_cast<std::uint32_t>(plumes_.size()), true};
  plumes_.push_back(shape);
  return boxed;
}

PlumeTree::Boxed PlumeTree::add_node(std::span<const Boxed> boxes) {
  Node node{};
  node.low_m.fill(Four::Constant(kEmptyBox_m));
  node.high_m.fill(Four::Constant(kEmptyBox_m));
  Boxed around;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const PlumeBox& box = boxes[i].box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      node.low_m[axis][static_cast<Eigen::Index>(i)] = box.low_m[static_cast<Eigen::Index>(axis)];
      node.high_m[axis][static_cast<Eigen::Index>(i)] = box.high_m[static_cast<Eigen::Index>(axis)];
    }
    node.children[i] = boxes[i].child;
    around.box.low_m = around.box.low_m.min(box.low_m);
    around.box.high_m = around.box.high_m.max(box.high_m);
  }
  around.child = {static_cast<std::uint32_t>(nodes_.size()), false};
  nodes_.push_back(node);
  return around;
}

}  // namespace berm::sim
