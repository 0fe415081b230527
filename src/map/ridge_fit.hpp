#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <Eigen/Core>

#include "edge_evidence.hpp"

namespace berm {

/// A place on the middle of a band of samples, and how the band runs there.
struct Ridge {
  Eigen::Vector3d position_m;
  Eigen::Vector2d direction;  ///< of length 1, horizontal
  double bend_per_m = 0.0;    ///< curvature, positive to the left
  double reach_m = 0.0;       ///< along the edge, in both directions: samples within had a say
  double left = 0.0;          ///< hits per metre of edge, near this place
  double right = 0.0;
  double ahead_m = 0.0;  ///< to the farthest sample in this direction along the edge; negative: all lie behind
  double here = 0.0;     ///< hits right beside this place
  double through = 0.0;  ///< see `seen_through`

  [[nodiscard]] double hits() const { return left + right; }
};

/// Which way the samples around a place lie; none where they form no band.
[[nodiscard]] std::optional<Eigen::Vector2d> band_direction(const EdgeEvidence& evidence,
                                                            std::span<const std::uint8_t> taken,
                                                            const Eigen::Vector3d& place_m);

/// Moves a guess sideways onto the middle of the samples around it: a parabola along `guess`, by least squares with
/// weights that fall to 0 at the sides of the band, as short as there are samples enough. Samples with a non-zero
/// `taken` do not count. None without samples.
[[nodiscard]] std::optional<Ridge> fit_ridge(const EdgeEvidence& evidence, std::span<const std::uint8_t> taken,
                                             const Ridge& guess);

/// How often per metre of edge, as hits are counted, plain road was seen on both sides of it, up to a metre away: the
/// least. An edge has road on one side only. Misses on the line itself would not do: toes scatter, and each of a noisy
/// edge lies where another scan saw the last of the road.
[[nodiscard]] double seen_through(const EdgeMap& map, const Ridge& ridge);

/// The guess for a place `step_m` further along the edge.
[[nodiscard]] Ridge advance(const Ridge& ridge, double step_m);

}  // namespace berm
