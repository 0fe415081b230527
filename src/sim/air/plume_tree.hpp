#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "berm/sim/weather.hpp"

namespace berm::sim {

/// A plume as beams are held against it.
struct PlumeShape {
  std::array<float, 3> center_m;
  std::array<float, 3> per_sigma;  ///< one over the sigmas
  float extinction_per_m;
};

/// From the least to the greatest coordinates of what is in it.
struct PlumeBox {
  Eigen::Array3f low_m = Eigen::Array3f::Constant(std::numeric_limits<float>::max());
  Eigen::Array3f high_m = Eigen::Array3f::Constant(std::numeric_limits<float>::lowest());
};

/// Plumes in boxes within boxes, so that beams need not be held against each of hundreds.
class PlumeTree {
 public:
  /// A plume ends `reach` sigmas from its middle.
  PlumeTree(std::vector<Plume> plumes, double reach);

  [[nodiscard]] bool is_empty() const { return plumes_.empty(); }

  /// Calls `visit(plume)` for every plume whose box has something in common with `box`, in a fixed order.
  template <typename Visit>
  void visit(const PlumeBox& box, Visit&& visit) const {
    if (is_empty()) {
      return;
    }
    // A node leaves three more than it takes, on no more levels than 4^20 plumes have.
    std::array<std::uint32_t, 64> waiting;  // NOLINT(cppcoreguidelines-pro-type-member-init): written before it is read
    std::size_t count = 0;
    waiting[count++] = static_cast<std::uint32_t>(nodes_.size() - 1);
    while (count > 0) {
      const Node& node = nodes_[waiting[--count]];
      const Four apart_m = node.apart_m(box);
      for (std::size_t i = 0; i < node.children.size(); ++i) {
        if (apart_m[static_cast<Eigen::Index>(i)] > 0.0F) {
          continue;
        }
        if (node.children[i].is_plume) {
          visit(plumes_[node.children[i].index]);
        } else {
          waiting[count++] = node.children[i].index;
        }
      }
    }
  }

 private:
  /// Four numbers that the processor computes with at once.
  using Four = Eigen::Array4f;

  struct Child {
    std::uint32_t index = 0;
    bool is_plume = false;  ///< else a node
  };

  /// The boxes of up to four children. What is no child lies far away.
  struct Node {
    std::array<Four, 3> low_m;
    std::array<Four, 3> high_m;
    std::array<Child, 4> children;

    /// How far the boxes are from `box` along the axis where they are farthest; positive if they have nothing in
    /// common.
    [[nodiscard]] Four apart_m(const PlumeBox& box) const {
      const auto along = [&](std::size_t axis) {
        const auto at = static_cast<Eigen::Index>(axis);
        return Four((low_m[axis] - box.high_m[at]).max(box.low_m[at] - high_m[axis]));
      };
      return along(0).max(along(1)).max(along(2));
    }
  };

  struct Boxed {
    PlumeBox box;
    Child child;
  };

  Boxed add_plume(const Plume& plume, double reach);
  Boxed add_node(std::span<const Boxed> boxes);

  std::vector<PlumeShape> plumes_;
  std::vector<Node> nodes_;  ///< the last is around all
};

}  // namespace berm::sim
