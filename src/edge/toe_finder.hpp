#pragma once

#include <cstdint>
#include <vector>

#include "berm/core/edge.hpp"
#include "berm/edge/trace_edges.hpp"
#include "trace_profile.hpp"

namespace berm {

/// A place on a trace where the road ends.
struct Toe {
  EdgeKind kind = EdgeKind::rise;
  std::uint32_t before = 0;  ///< points of the traces that it lies between
  std::uint32_t after = 0;
  std::uint32_t road = 0;     ///< a point of the road before it
  std::uint32_t flank = 0;    ///< a point of the flank behind it
  float share = 0.0F;         ///< how far from `before` to `after`
  float below_m = 0.0F;       ///< the line between these
  float height_m = 0.0F;      ///< how far it rises within what is seen
  bool seen_to_top = false;   ///< whether it falls again, or hides what follows
  float width_m = 0.0F;       ///< along the trace, to where it is back on the level of the road; 0: unknown
  float slope = 0.0F;         ///< of the flank along the trace
  float run_m = 0.0F;         ///< of road before it
  float misfit_m = 0.0F;      ///< of the flank about its line
  bool across = false;        ///< found from trace to trace, not along one
  bool into_nothing = false;  ///< of a drop: nothing at all was seen behind
};

/// Finds where road ends along a profile.
class ToeFinder {
 public:
  explicit ToeFinder(const TraceEdgesConfig& config) : config_(config) {}

  /// Appends to `toes`. Marks in `on_road` the points of the traces that are road: 1. `end_falls`: behind the profile
  /// the trace goes on far below, or there is nothing.
  void process(const TraceProfile& profile, bool end_falls, std::vector<Toe>& toes,
               std::vector<std::uint8_t>& on_road) const;

 private:
  /// The road behind a place on the profile.
  struct RoadLine {
    static constexpr float kReach_m = 1.5F;  // farther on it is level

    float s_m = 0.0F;
    float height_m = 0.0F;
    float slope = 0.0F;

    [[nodiscard]] float at(float s) const { return height_m + slope * (s < s_m + kReach_m ? s - s_m : kReach_m); }
  };

  [[nodiscard]] bool is_road(const TraceProfile& p, std::size_t first, std::size_t last, RoadLine& road) const;
  [[nodiscard]] bool find_rise(const TraceProfile& p, std::size_t last, std::size_t shows, const RoadLine& road,
                               Toe& toe, std::size_t& top) const;
  [[nodiscard]] bool find_fall(const TraceProfile& p, std::size_t last, std::size_t shows, const RoadLine& road,
                               Toe& toe, std::size_t& beyond) const;

  TraceEdgesConfig config_;
};

}  // namespace berm
