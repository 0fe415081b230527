#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "berm/sim/weather.hpp"

namespace berm::sim {

/// Plumes in boxes within boxes, so that a beam need not be held against each of hundreds.
class PlumeTree {
 public:
  /// A plume ends `reach` sigmas from its middle.
  PlumeTree(std::vector<Plume> plumes, double reach);

  [[nodiscard]] const std::vector<Plume>& plumes() const { return plumes_; }

  /// Calls `visit(index)` for every plume whose box the beam passes, in a fixed order.
  template <typename Visit>
  void visit(const AirBeam& beam, Visit&& visit) const {
    constexpr double kParallel = 1e-12;
    const Eigen::Array3d direction = beam.direction.array();
    const Eigen::Array3d inverse = (direction.abs() < kParallel).select(1.0 / kParallel, direction.inverse());
    std::size_t i = 0;
    while (i < nodes_.size()) {
      const Node& node = nodes_[i];
      if (!passes(node, beam, inverse)) {
        i = node.next;
        continue;
      }
      for (std::uint32_t plume = node.first; plume < node.end; ++plume) {
        visit(plume);
      }
      ++i;
    }
  }

 private:
  /// Plumes first..end are its own if it is a leaf. `next` is the node to go on with where the beam passes by.
  struct Node {
    Eigen::Array3d low_m;
    Eigen::Array3d high_m;
    std::uint32_t first;
    std::uint32_t end;
    std::size_t next;
  };

  static bool passes(const Node& node, const AirBeam& beam, const Eigen::Array3d& inverse) {
    const Eigen::Array3d low = (node.low_m - beam.origin_m.array()) * inverse;
    const Eigen::Array3d high = (node.high_m - beam.origin_m.array()) * inverse;
    const double enters_m = low.min(high).maxCoeff();
    const double leaves_m = low.max(high).minCoeff();
    return enters_m <= leaves_m && leaves_m >= 0.0 && enters_m <= beam.end_m;
  }

  void build(std::size_t first, std::size_t end, double reach);

  std::vector<Plume> plumes_;  ///< in the order of the leaves
  std::vector<Node> nodes_;    ///< a node before what lies in it
};

}  // namespace berm::sim
