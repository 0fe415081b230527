#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "across_toes.hpp"
#include "berm/edge/trace_edges.hpp"
#include "berm/geometry/traces.hpp"
#include "road_surface.hpp"
#include "toe_finder.hpp"
#include "trace_profile.hpp"
#include "void_view.hpp"

namespace berm {

/// Walks all traces of a scan in both directions and finds where road ends.
class RoadToes {
 public:
  explicit RoadToes(const TraceEdgesConfig& config) : config_(config), finder_(config), across_(config) {}

  /// Results are valid until the next call.
  void process(const Traces& traces);

  [[nodiscard]] std::span<const Toe> toes() const { return toes_; }
  /// Of the points of the traces, above the surface of the road.
  [[nodiscard]] std::span<const float> height_m() const { return height_m_; }
  /// 1: a point of the traces is smooth road.
  [[nodiscard]] std::span<const std::uint8_t> on_road() const { return on_road_; }

 private:
  /// Walks from one point of a piece to the other; `next` is where the trace goes on behind a break.
  void walk(const Traces& traces, std::size_t from, std::size_t to, std::size_t next);
  void find_toes(const Traces& traces, std::size_t to, std::size_t next);

  TraceEdgesConfig config_;
  ToeFinder finder_;
  AcrossToes across_;
  RoadSurface surface_;
  VoidView void_;
  TraceProfile profile_;
  std::vector<float> height_m_;
  std::vector<std::uint8_t> on_road_;
  std::vector<Toe> toes_;
};

}  // namespace berm
