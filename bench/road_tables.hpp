#pragma once

#include <span>

#include "road_measure.hpp"
#include "road_methods.hpp"

namespace berm::bench {

/// The first two methods, road by road.
void print_roads(std::span<const RoadMethod> methods, std::span<const RoadResult> results);

/// Whether the bars hold for the first method; returns that.
[[nodiscard]] bool print_bars(std::span<const RoadResult> results);

/// Means of all methods over the roads.
void print_methods(std::span<const RoadMethod> methods, std::span<const RoadResult> results);

}  // namespace berm::bench
