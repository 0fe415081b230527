#pragma once

namespace berm::bench {

/// Prints what the default ground method reaches in every made world: F1, and the share of the cells seen within 30 m
/// whose height is within three sigmas of the terrain's (99.7 % if sigma were exact).
void print_world_table();

}  // namespace berm::bench
