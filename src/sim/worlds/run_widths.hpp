#pragma once

#include <vector>

#include "run_plans.hpp"

namespace berm::sim {

/// Share of the width that one side may have at most.
constexpr double kMostOneSided = 0.58;

/// What is random along a run, for what.
enum class RunRandom : std::uint64_t { width, one_sidedness, cross_fall, bank, heaps, gaps };

/// Generator for one of the above; side 0 or 1.
[[nodiscard]] Random random_of(const RunSeed& seed, RunRandom what, std::uint64_t side = 0);

/// Widths to both sides: their sum goes from `low_m` to `high_m`, both of which are met on the route itself.
void set_widths(std::vector<RoutePoint>& course, double low_m, double high_m, double wave_m, const RunSeed& seed);

/// Cross-fall between the limits, changing along the run.
[[nodiscard]] Profile make_cross_fall(const std::vector<RoutePoint>& course, double limit_deg, const RunSeed& seed);

/// The same value all along.
[[nodiscard]] Profile constant_profile(const std::vector<RoutePoint>& course, double value);

}  // namespace berm::sim
