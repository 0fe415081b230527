#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "berm/odometry/pose_graph.hpp"
#include "graph_chain.hpp"

namespace berm {

struct TimeOffset {
  double offset_s = 0.0;      ///< added to the stamps of fixes; 0 unless the scans clearly ask for another
  bool is_at_border = false;  ///< the fixes would fit better still, farther away than may be corrected
  double residual_m = 0.0;    ///< median distance at `offset_s`
  double as_stamped_m = 0.0;  ///< the same at 0
};

/// The constant offset with which the fixes fit the shape of the path best. `chosen`: fixes to use, rising in time.
[[nodiscard]] TimeOffset find_time_offset(std::span<const OdometryStep> odometry, std::span<const double> path_m,
                                          std::span<const Fix> fixes, std::span<const std::size_t> chosen,
                                          const PoseGraphConfig& config);

}  // namespace berm
