#pragma once

#include <span>
#include <vector>

#include "support/chain_score.hpp"

namespace berm::bench {

/// CPU time per 10,000 points.
struct StageTimes {
  double snow_ms = 0.0;   ///< 0 without a snow method
  double piste_ms = 0.0;  ///< with the repair of the series where the method looks at it; 0 without a piste method
};

/// What the stages take on `scans`, one after the other: medians over rounds in which the methods take turns. Stages
/// that come before are done outside the clock.
[[nodiscard]] std::vector<StageTimes> time_methods(std::span<const test::Method> methods,
                                                   std::span<const test::LabelledScan> scans);

}  // namespace berm::bench
