#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "berm/sim/weather.hpp"
#include "fours.hpp"

namespace berm::sim {

/// Four plumes side by side. Places without a plume have no extinction and lie far away.
struct PlumeGroup {
  Four3 center_m;
  Four3 per_sigma;  ///< one over the sigmas
  Four extinction_per_m;
};

/// Plumes in boxes within boxes, so that a beam need not be held against each of hundreds.
class PlumeTree {
 public:
  /// A plume ends `reach` sigmas from its middle.
  PlumeTree(std::vector<Plume> plumes, double reach);

  [[nodiscard]] bool is_empty() const { return groups_.empty(); }

  /// Calls `visit(group)` for every group of plumes whose box the beam passes, in a fixed order.
  template <typename Visit>
  void visit(const AirBeam& beam, Visit&& visit) const {
    if (is_empty()) {
      return;
    }
    const Line line(beam);
    // A node leaves three more than it takes, on no more levels than 4^20 plumes have.
    std::array<std::uint32_t, 64> waiting;  // NOLINT(cppcoreguidelines-pro-type-member-init): written before it is read
    std::size_t count = 0;
    waiting[count++] = static_cast<std::uint32_t>(nodes_.size() - 1);
    while (count > 0) {
      const Node& node = nodes_[waiting[--count]];
      const std::array<bool, 4> passed = line.passes(node);
      for (std::size_t i = 0; i < 4; ++i) {
        if (!passed[i]) {
          continue;
        }
        if (node.children[i].is_group) {
          visit(groups_[node.children[i].index]);
        } else {
          waiting[count++] = node.children[i].index;
        }
      }
    }
  }

 private:
  struct Child {
    std::uint32_t index = 0;
    bool is_group = false;  ///< else a node
  };

  /// The boxes of up to four children. What is no child lies far away.
  struct Node {
    Four3 low_m;
    Four3 high_m;
    std::array<Child, 4> children;
  };

  struct Box {
    Eigen::Array3f low_m = Eigen::Array3f::Constant(1e30F);
    Eigen::Array3f high_m = Eigen::Array3f::Constant(-1e30F);
    Child child;
  };

  /// A beam, ready to be held against boxes.
  class Line {
   public:
    explicit Line(const AirBeam& beam)
        : origin_m_(beam.origin_m.cast<float>()), end_m_(static_cast<float>(beam.end_m)) {
      constexpr float kParallel = 1e-12F;
      const Eigen::Array3f direction = beam.direction.cast<float>();
      inverse_ = (direction.abs() < kParallel).select(1.0F / kParallel, direction.inverse());
    }

    [[nodiscard]] std::array<bool, 4> passes(const Node& node) const {
      Four enters_m = Four::Zero();
      Four leaves_m = Four::Constant(end_m_);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<Eigen::Index>(axis);
        const Four low_m = (node.low_m[axis] - origin_m_[at]) * inverse_[at];
        const Four high_m = (node.high_m[axis] - origin_m_[at]) * inverse_[at];
        enters_m = enters_m.max(low_m.min(high_m));
        leaves_m = leaves_m.min(low_m.max(high_m));
      }
      return {enters_m[0] <= leaves_m[0], enters_m[1] <= leaves_m[1], enters_m[2] <= leaves_m[2],
              enters_m[3] <= leaves_m[3]};
    }

   private:
    Eigen::Array3f origin_m_;
    Eigen::Array3f inverse_;
    float end_m_;
  };

  Box add_group(std::span<const Plume> plumes, double reach);
  Box add_node(std::span<const Box> boxes);

  std::vector<PlumeGroup> groups_;
  std::vector<Node> nodes_;  ///< the last is around all
};

}  // namespace berm::sim
