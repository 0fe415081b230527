#pragma once

#include <memory>

#include "berm/core/config.hpp"
#include "berm/edge/edge.hpp"

namespace berm {

/// Settings of the default edge method. docs/edges.md shows what each step is worth.
struct TraceEdgesConfig {
  double max_range_m = 40.0;
  // The road.
  double min_run_m = 1.5;
  double road_noise_m = 0.05;
  double max_road_slope = 0.15;
  // What bounds it.
  double min_height_m = 0.25;
  double flank_m = 4.0;
  double min_flank_slope = 0.08;
  bool find_drops = true;
  double min_drop_m = 0.6;
  // Which of these are the edge.
  bool sub_cell = true;
  bool across = true;
  bool own_road = true;
  bool face = true;
  bool agree = true;
  bool hide = true;
  bool outline = true;
  double min_radius_m = 40.0;

  static void fields(auto&& field);
  void check() const { check_fields(*this, "edge"); }
};

/// The default edge method: follows the traces that the beams draw on the ground. A road is
/// smooth along them; where a berm begins they turn up, and the toe lies where the line of the road and the line of the
/// flank meet. Works for rings, for a rosette and for lasers that take turns; without any order on the profiles
/// outward from the sensor.
class TraceEdges final : public EdgeDetector {
 public:
  /// Throws ConfigError as `TraceEdgesConfig::check`.
  explicit TraceEdges(const TraceEdgesConfig& config);
  ~TraceEdges() override;

  /// Without `input.surface` the mount is trusted for what is level. Throws Error(invalid_argument) unless there is a
  /// label for every point.
  [[nodiscard]] EdgeResult process(const EdgeInput& input) override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

void TraceEdgesConfig::fields(auto&& field) {
  using C = TraceEdgesConfig;
  field("max_range_m", &C::max_range_m, Range{5.0, 200.0}, "edges are looked for this far from the sensor");
  field("min_run_m", &C::min_run_m, Range{0.2, 2.0}, "smooth road that a trace has to show before an edge");
  field("road_noise_m", &C::road_noise_m, Range{0.001, 0.5}, "of road about its own line along a trace, one sigma");
  field("max_road_slope", &C::max_road_slope, Range{0.01, 1.0}, "of a trace against the surface of the road");
  field("min_height_m", &C::min_height_m, Range{0.03, 5.0}, "what rises less is no edge; 0.08 finds kerbs");
  field("flank_m", &C::flank_m, Range{0.2, 20.0}, "length along the trace within which it has to rise so");
  field("min_flank_slope", &C::min_flank_slope, Range{0.02, 2.0}, "of the flank along the trace, at least");
  field("find_drops", &C::find_drops, "look for edges without a berm, where the ground falls away");
  field("min_drop_m", &C::min_drop_m, Range{0.1, 20.0}, "what falls less is no edge");
  field("sub_cell", &C::sub_cell,
        "put the toe where the lines of road and flank meet; off: on the last return of the road");
  field("across", &C::across, "look from trace to trace, too: beside the machine they run along the berm");
  field("own_road", &C::own_road, "road has to lie on the surface that the machine stands on");
  field("face", &C::face, "an edge faces the road: what rises on the way back to it is the rear of a berm");
  field("agree", &C::agree, "what stands on the road alone, before the line of the other edges, is none");
  field("hide", &C::hide, "what lies behind an edge, or behind anything high, is no edge of this road");
  field("outline", &C::outline, "what lies beyond the line between two edges of one side is none");
  field("min_radius_m", &C::min_radius_m, Range{5.0, 1000.0}, "edges bend no more sharply between two others");
}

}  // namespace berm
