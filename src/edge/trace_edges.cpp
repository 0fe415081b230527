#include "berm/edge/trace_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "berm/core/error.hpp"
#include "berm/geometry/bearing_grid.hpp"
#include "berm/geometry/level_points.hpp"
#include "berm/geometry/traces.hpp"
#include "own_edges.hpp"
#include "ring_numbers.hpp"
#include "road_toes.hpp"

namespace berm {
namespace {

constexpr float kLookShare = 1.5F;    // of the greatest range: berms are seen to their end
constexpr float kPlainStep_m = 0.2F;  // along a trace, between places that are said to be plain
constexpr float kPlain_m = 0.12F;     // they lie this near to the surface of the road
constexpr float kSureRun_m = 4.0F;    // road before an edge that leaves no doubt
constexpr float kSureHeight_m = 0.6F;
constexpr float kSureSupporters = 3.0F;

/// 1 for a high flank behind a long run of road that neighbouring traces confirm; what is missing makes it less.
float confidence_of(const Toe& toe, const ToePlace& place) {
  const float run = std::min(toe.run_m / kSureRun_m, 1.0F);
  const float height = toe.kind == EdgeKind::drop ? 0.5F : std::min(toe.height_m / kSureHeight_m, 1.0F);
  const float support = std::min(static_cast<float>(place.supporters) / kSureSupporters, 1.0F);
  return 0.1F + 0.2F * run + 0.3F * height + 0.4F * support;
}

/// Across the berm rather than along the trace.
float width_across_m(const Traces& t, const Toe& toe, const ToePlace& place) {
  const float dx = t.x[toe.flank] - t.x[toe.road];
  const float dy = t.y[toe.flank] - t.y[toe.road];
  const float step_m = std::hypot(dx, dy);
  if (place.supporters == 0 || step_m < 1e-3F) {
    return toe.width_m;
  }
  return toe.width_m * std::abs(place.along_x * dy - place.along_y * dx) / step_m;
}

}  // namespace

struct TraceEdges::State {
  explicit State(const TraceEdgesConfig& settings) : config(settings), road_toes(settings), own(settings) {}

  const Traces& find_traces(const EdgeInput& input);
  void collect_edges(const PointsView& points, const Traces& traces);
  void collect_plain(const Traces& traces);

  TraceEdgesConfig config;
  bearing_grid::SectorTable sectors;
  LevelPoints level;
  std::vector<Label> solid;
  TraceFinder trace_finder;
  RoadToes road_toes;
  OwnEdges own;
  std::vector<EdgePoint> edges;
  std::vector<std::uint32_t> plain;
};

TraceEdges::TraceEdges(const TraceEdgesConfig& config) {
  config.check();
  state_ = std::make_unique<State>(config);
}

TraceEdges::~TraceEdges() = default;

EdgeResult TraceEdges::process(const EdgeInput& input) {
  if (input.labels.size() != input.points.size()) {
    throw Error(ErrorCode::invalid_argument, "edge: points and labels must have one length");
  }
  State& s = *state_;
  const Traces& traces = s.find_traces(input);
  s.road_toes.process(traces);
  s.own.process(traces, s.road_toes);
  s.collect_edges(input.points, traces);
  s.collect_plain(traces);
  return {.edges = s.edges, .plain = s.plain};
}

/// A berm may be ground or obstacle: all that is solid is followed.
const Traces& TraceEdges::State::find_traces(const EdgeInput& input) {
  level.fill(input.points, input.surface != nullptr ? input.surface->T_level_sensor() : input.T_base_sensor);
  const auto reach_m = kLookShare * static_cast<float>(config.max_range_m);
  solid.resize(input.labels.size());
  for (std::size_t i = 0; i < solid.size(); ++i) {
    // False for NaN too, whatever its label says.
    const bool in_reach = level.range2[i] + level.z[i] * level.z[i] < reach_m * reach_m;
    solid[i] = is_solid(input.labels[i]) && in_reach ? Label::drivable : Label::no_return;
  }
  return trace_finder.process(input.points, solid, level, sectors);
}

void TraceEdges::State::collect_edges(const PointsView& points, const Traces& traces) {
  edges.clear();
  for (std::size_t i = 0; i < own.toes().size(); ++i) {
    const Toe& toe = own.toes()[i];
    const ToePlace& place = own.places()[i];
    const auto between = [&](std::span<const float> values) {
      const float before = values[traces.index[toe.before]];
      return before + toe.share * (values[traces.index[toe.after]] - before);
    };
    edges.push_back({.x_m = between(points.x),
                     .y_m = between(points.y),
                     .z_m = between(points.z) - toe.below_m,
                     .time_s = points.time.empty() ? 0.0F : between(points.time),
                     .side = place.left ? EdgeSide::left : EdgeSide::right,
                     .kind = toe.kind,
                     .confidence = confidence_of(toe, place),
                     .height_m = toe.seen_to_top ? toe.height_m : 0.0F,
                     .width_m = width_across_m(traces, toe, place)});
  }
}

void TraceEdges::State::collect_plain(const Traces& traces) {
  plain.clear();
  float x = 1e6F;
  float y = 1e6F;
  for (std::size_t i = 0; i < traces.index.size(); ++i) {
    if (road_toes.on_road()[i] == 0 || std::abs(road_toes.height_m()[i]) > kPlain_m) {
      continue;
    }
    const float dx = traces.x[i] - x;
    const float dy = traces.y[i] - y;
    if (dx * dx + dy * dy > kPlainStep_m * kPlainStep_m && own.is_own(traces.x[i], traces.y[i])) {
      x = traces.x[i];
      y = traces.y[i];
      plain.push_back(traces.index[i]);
    }
  }
}

}  // namespace berm
