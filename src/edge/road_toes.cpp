#include "road_toes.hpp"

#include <cmath>

namespace berm {
namespace {

constexpr std::size_t kFewestOfPiece = 8;  // points of a piece of a trace that is looked at
constexpr float kOnward_rad = 0.06F;       // a trace that breaks off goes on within this angle

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
  float s = 0.0F;
  std::size_t before = from;
  for (std::size_t i = from;; i = from < to ? i + 1 : i - 1) {
    const float dx = traces.x[i] - traces.x[before];
    const float dy = traces.y[i] - traces.y[before];
    s += std::sqrt(dx * dx + dy * dy);  // std::hypot heeds what cannot be here, and takes five times as long
    profile_.add(static_cast<std::uint32_t>(i), s, height_m_[i]);
    before = i;
    if (i == to) {
      break;
    }
  }
  finder_.process(profile_, falls(traces, height_m_, to, next, static_cast<float>(config_.min_drop_m)), toes_,
                  on_road_);
}

}  // namespace berm
