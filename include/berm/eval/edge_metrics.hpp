#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "berm/core/edge.hpp"

namespace berm {

/// How edges are judged; distances are horizontal.
struct EdgeJudge {
  double sample_m = 0.25;     ///< lines are judged at places this far apart along them
  double tolerance_m = 0.5;   ///< a place this near to a line of the other set is right
  double near_path_m = 25.0;  ///< truth is asked for this near to the path that was driven
};

/// How well edges agree with the truth. Shares of 0..1; none where the divisor is 0.
struct EdgeScore {
  std::uint64_t found = 0;        ///< places on the edges that were found
  std::uint64_t found_right = 0;  ///< of these, within the tolerance of a true edge, of either side
  std::uint64_t truth = 0;        ///< places on true edges near the path
  std::uint64_t truth_found = 0;  ///< of these, within the tolerance of an edge that was found, of either side
  std::uint64_t wrong_side = 0;   ///< of `found_right`, where the nearest true edge is one of the other side

  std::optional<double> precision;
  std::optional<double> recall;
  std::optional<double> f1;
  /// From the places that are right to the true edge: median, and the distance that 95 % keep within.
  std::optional<double> lateral_median_m;
  std::optional<double> lateral_p95_m;
  std::optional<double> wrong_side_share;
};

/// Judges `found` by `truth`, whole lines from vertex to vertex. `path_m`: where the machine was, in order. An edge
/// that was found far from the path counts as found, and as right if truth has it. Throws Error(invalid_argument) for a
/// coordinate that is not finite or beyond 1e9 m, for lines of more than 5,000 km together, for a `judge` whose lengths
/// are not positive.
[[nodiscard]] EdgeScore judge_edges(std::span<const EdgeLine> found, std::span<const EdgeLine> truth,
                                    std::span<const Eigen::Vector3d> path_m, const EdgeJudge& judge = {});

}  // namespace berm
