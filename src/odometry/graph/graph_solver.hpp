#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "berm/odometry/pose_graph.hpp"
#include "fix_groups.hpp"
#include "graph_chain.hpp"

namespace berm {

/// A closure between nodes.
struct NodeClosure {
  std::size_t first = 0;
  std::size_t second = 0;
  Pose T_first_second;
  Matrix6d covariance;
};

/// What is to be solved. Poses of the world are near its origin: the caller takes the first fix away.
struct GraphTask {
  const GraphChain& chain;
  std::span<const FixGroup> groups;
  std::span<const NodeClosure> closures;
  std::span<const Pose> start;  ///< of every node
};

struct GraphSolution {
  std::vector<Pose> nodes;
  std::vector<Matrix6d> covariances;   ///< of every node, as GraphNode::covariance
  std::vector<bool> is_used;           ///< of every group: its position
  std::vector<bool> is_attitude_used;  ///< of every group; false also without one
  std::vector<bool> is_closure_used;   ///< of every closure
};

/// Without groups the first node stays where it starts.
[[nodiscard]] GraphSolution solve_graph(const GraphTask& task, const PoseGraphConfig& config);

}  // namespace berm
