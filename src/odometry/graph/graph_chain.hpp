#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "berm/core/pose.hpp"
#include "berm/odometry/pose_graph.hpp"

namespace berm {

/// What the odometry says of the way from one node to the next.
struct ChainLink {
  Pose T_a_b;
  Matrix6d covariance;     ///< translation along the axes of a, rotation about those of b
  bool is_broken = false;  ///< a new session, or a gap: says next to nothing
};

/// The nodes of a graph, and what links them.
struct GraphChain {
  std::vector<std::size_t> steps;  ///< of every node, rising; the first and the last step are nodes
  std::vector<ChainLink> links;    ///< one less
  std::vector<double> path_m;      ///< to every node, from the first
};

/// Throws Error(invalid_argument) unless stamps strictly increase and poses are finite.
void check_odometry(std::span<const OdometryStep> odometry);

/// A node wherever the machine has moved or turned so far, where a session begins or ends, and at every lost scan.
[[nodiscard]] GraphChain make_chain(std::span<const OdometryStep> odometry, const PoseGraphConfig& config);

/// Where the odometry was at a time; none before the first step, after the last, and in a gap or between sessions.
class OdometryClock {
 public:
  explicit OdometryClock(std::span<const OdometryStep> odometry) : odometry_(odometry) {}

  struct Place {
    Pose T_odom_base;
    std::size_t step = 0;  ///< the last one that is not later
  };
  [[nodiscard]] std::optional<Place> at(Stamp stamp_ns) const;

 private:
  std::span<const OdometryStep> odometry_;
};

}  // namespace berm
