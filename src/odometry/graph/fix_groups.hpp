#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "berm/odometry/pose_graph.hpp"
#include "graph_chain.hpp"
#include "seen_fixes.hpp"

namespace berm {

/// What fixes say of how a machine is turned: sigmas along the axes of the world.
struct GroupAttitude {
  Eigen::Quaterniond R_world_base = Eigen::Quaterniond::Identity();
  Eigen::Vector3d sigma_rad = Eigen::Vector3d::Zero();  ///< infinite where nothing is said
  std::size_t count = 0;                                ///< fixes that say it; 0: none does
};

/// The fixes around a node as one: the mean of places, which rotations keep.
struct FixGroup {
  std::size_t node = 0;
  Eigen::Vector3d antenna_m = Eigen::Vector3d::Zero();   ///< frame of the base at the node
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< world
  Eigen::Vector3d sigma_m = Eigen::Vector3d::Zero();
  GroupAttitude attitude;
  std::vector<std::size_t> members;  ///< indices of fixes
};

struct FixGroups {
  std::vector<FixGroup> groups;     ///< in the order of nodes
  std::vector<std::size_t> jumped;  ///< fixes on the wrong side of a jump
  std::size_t bad_attitudes = 0;
  std::size_t jumps = 0;  ///< steps that the odometry contradicts
};

/// Gathers fixes at the nodes nearest in time and leaves out those behind jumps. Jumps add up, so that what comes back
/// after an excursion is known to agree with what was before; what agrees for most of the time is kept.
/// `sigma_factor`: by how much sigmas are too small.
[[nodiscard]] FixGroups gather_fixes(std::span<const OdometryStep> odometry, const GraphChain& chain,
                                     std::span<const Fix> fixes, std::span<const SeenFix> seen,
                                     std::span<const FixWindow> windows, std::span<const WindowFit> fits,
                                     double sigma_factor, const PoseGraphConfig& config);

}  // namespace berm
