#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "berm/core/point_cloud.hpp"
#include "berm/edge/edge.hpp"

namespace berm::bench {

/// Edges held against kerbs: the border between road (40) and sidewalk (48) in labels of SemanticKITTI.
struct KerbCounts {
  std::size_t found = 0;       ///< edges within 20 m
  std::size_t found_true = 0;  ///< of these within 0.5 m of a border
  std::size_t kerbs = 0;       ///< places on the border, 0.25 m apart, within 20 m
  std::size_t kerbs_seen = 0;  ///< of these with an edge within 0.5 m
};

void count_kerbs(const PointsView& points, std::span<const std::uint32_t> truth, std::span<const EdgePoint> edges,
                 KerbCounts& counts);

}  // namespace berm::bench
