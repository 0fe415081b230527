#pragma once

#include <cstdint>
#include <vector>

#include "berm/sim/route.hpp"
#include "berm/sim/world_config.hpp"

namespace berm::sim {

/// Distance between the points of a route.
constexpr double kRouteStep_m = 0.5;
/// How far a piste or road goes on before the start and behind the end of the route.
constexpr double kLead_m = 120.0;
/// How far the heading may leave the main direction: a route never comes near to itself.
constexpr double kMaxTurn_rad = 1.25;

/// Points every kRouteStep_m from -kLead_m to the length + kLead_m; (0, 0, 0) is where s = 0. Widths are left 0.
/// Procedural: random bends and gradients within the limits, of which the greatest gradient is reached.
[[nodiscard]] std::vector<RoutePoint> lay_course(const RouteConfig& config, std::uint64_t seed);

/// The course of a run that leaves another at `start` to a side (+1 left, -1 right): starts along it, turns away by
/// `turn_rad` with `radius_m`, then winds on. Heights are left 0. `s_m` begins at 0.
[[nodiscard]] std::vector<RoutePoint> lay_fork(const RoutePoint& start, double side, double turn_rad, double radius_m,
                                               double length_m);

/// Gradients (tangents) along the course within the limits of `config`, with rollers; the first and last reached are
/// exactly the limits.
[[nodiscard]] std::vector<double> make_gradients(const RouteConfig& config, std::size_t count, std::uint64_t seed);

/// Places and headings from curvatures, by integration; s = 0 at the origin with `heading_rad`.
[[nodiscard]] std::vector<RoutePoint> follow_curvatures(const std::vector<double>& curvatures_per_m, double first_s_m,
                                                        double heading_rad);

}  // namespace berm::sim
