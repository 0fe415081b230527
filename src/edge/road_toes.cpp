#include "road_toes.hpp"

#include <algorithm>
#include <cmath>

namespace berm {
namespace {

constexpr std::size_t kFewestOfPiece = 8;  // points of a piece of a trace that is looked at
/// A way is measured in straight stretches of this length: from point to point the noise of ranges would lengthen it.
constexpr float kStretch_m = 0.5F;
constexpr float kOnward_rad = 0.06F;  // a trace that breaks off goes on within this angle

/// Whether the trace breaks off at point `a` and goes on at `b`, farther away and far below the road.
bool falls(const Traces& t, std::span<const float> height_m, std::size_t a, std::size_t b, float min_drop_m) {
  const float range_a = std::hypot(t.x[a], t.y[a]);
  const float range_b = std::hypot(t.x[b], t.y[b]);
  const float sine = (t.x[a] * t.y[b] - t.y[a] * t.x[b]) / std::max(range_a * range_b, 0.01F);
  return std::abs(sine) < kOnward_rad && range_b > range_a && t.x[a] * t.x[b] + t.y[a] * t.y[b] > 0.0F &&
         height_m[b] < height_m[a] - min_drop_m;
}

}  // namespace

void RoadToes::process(const Traces& traces) {
  const std::size_t size = traces.x.size();
  surface_.fit(traces.x, traces.y, traces.z);
  height_m_.resize(size);
  for (std::size_t i = 0; i < size; ++i) {
    height_m_[i] = traces.z[i] - surface_.height_m(traces.x[i], traces.y[i]);
  }
  void_.process(traces, height_m_, static_cast<float>(config_.min_drop_m));
  on_road_.assign(size, 0);
  toes_.clear();
  for (std::size_t begin = 0; begin < size;) {
    std::size_t end = begin + 1;
    while (end < size && traces.is_broken[end] == 0) {
      ++end;
    }
    if (end - begin >= kFewestOfPiece) {
      walk(traces, begin, end - 1, end < size ? end : begin);
      if (traces.kind != TraceKind::radial) {
        walk(traces, end - 1, begin, begin > 0 ? begin - 1 : end - 1);
      }
    }
    begin = end;
  }
  if (config_.across) {
    across_.process(traces, height_m_, on_road_, toes_);
  }
}

void RoadToes::walk(const Traces& traces, std::size_t from, std::size_t to, std::size_t next) {
  profile_.clear();
  const auto along = [&](std::size_t i) { return from < to ? i + 1 : i - 1; };
  float begin_m = 0.0F;  // way to where the stretch begins
  float s = 0.0F;
  for (std::size_t begin = from;;) {
    float dx = 0.0F;
    float dy = 0.0F;
    std::size_t end = begin;
    while (end != to && dx * dx + dy * dy < kStretch_m * kStretch_m) {
      end = along(end);
      dx = traces.x[end] - traces.x[begin];
      dy = traces.y[end] - traces.y[begin];
    }
    const float length_m = std::sqrt(dx * dx + dy * dy);
    const float per_m = length_m > 0.0F ? 1.0F / length_m : 0.0F;
    for (std::size_t i = begin; i != end; i = along(i)) {
      const float x = traces.x[i] - traces.x[begin];
      const float y = traces.y[i] - traces.y[begin];
      s = std::max(s, begin_m + (x * dx + y * dy) * per_m);
      profile_.add(static_cast<std::uint32_t>(i), s, height_m_[i]);
    }
    begin_m += length_m;
    if (end == to) {
      profile_.add(static_cast<std::uint32_t>(to), std::max(s, begin_m), height_m_[to]);
      break;
    }
    begin = end;
  }
  find_toes(traces, to, next);
}

void RoadToes::find_toes(const Traces& traces, std::size_t to, std::size_t next) {
  const bool goes_on_below = falls(traces, height_m_, to, next, static_cast<float>(config_.min_drop_m));
  const std::size_t before = profile_.index[profile_.size() - kFewestOfPiece];
  const bool goes_nowhere = !goes_on_below && config_.find_drops && void_.ends_at(traces, before, to);
  const std::size_t found = toes_.size();
  finder_.process(profile_, goes_on_below || goes_nowhere, toes_, on_road_);
  if (goes_nowhere && toes_.size() > found && toes_.back().kind == EdgeKind::drop && toes_.back().before == to) {
    toes_.back().into_nothing = true;
  }
}

}  // namespace berm
