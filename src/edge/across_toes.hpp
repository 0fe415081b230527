#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "berm/edge/trace_edges.hpp"
#include "berm/geometry/bearing_grid.hpp"
#include "berm/geometry/traces.hpp"
#include "toe_finder.hpp"

namespace berm {

/// Finds where road ends across traces, outward from the sensor: beside the machine a ring runs along the berm and
/// never climbs it, but the next ring out lies higher on the flank.
class AcrossToes {
 public:
  explicit AcrossToes(const TraceEdgesConfig& config) : config_(config) {}

  /// `height_m` and `on_road`: of the points of the traces. Appends to `toes`.
  void process(const Traces& traces, std::span<const float> height_m, std::span<const std::uint8_t> on_road,
               std::vector<Toe>& toes);

 private:
  /// What a trace shows while it passes a sector.
  struct Node {
    std::uint8_t sector = 0;
    float range_m = 0.0F;
    float height_m = 0.0F;
    float road = 0.0F;  ///< share of it that is road
    std::uint32_t point = 0;
  };
  using Nodes = std::span<const Node>;  ///< of a sector, outward

  void gather(const Traces& traces, std::span<const float> height_m, std::span<const std::uint8_t> on_road);
  void find_toe(Nodes nodes, std::vector<Toe>& toes) const;
  /// The flank begins at `nodes[i]`, the road ends at the node before, with a slope of its own.
  void add_toe(Nodes nodes, std::size_t i, float road_slope, std::vector<Toe>& toes) const;

  TraceEdgesConfig config_;
  bearing_grid::SectorTable sectors_;
  std::vector<Node> nodes_;
};

}  // namespace berm
