#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "berm/edge/trace_edges.hpp"
#include "road_divide.hpp"
#include "road_outline.hpp"
#include "road_toes.hpp"
#include "road_view.hpp"
#include "stand_alone.hpp"

namespace berm {

/// Tells which of the toes in view bound the road that the machine is on, and on which side.
class OwnEdges {
 public:
  explicit OwnEdges(const TraceEdgesConfig& config) : config_(config) {}

  /// Results are valid until the next call.
  void process(const Traces& traces, const RoadToes& found);

  [[nodiscard]] std::span<const Toe> toes() const { return toes_; }
  [[nodiscard]] std::span<const ToePlace> places() const { return places_; }  ///< one per toe
  /// Whether road at a place is of this road.
  [[nodiscard]] bool is_own(float x_m, float y_m) const {
    return !view_.hides(x_m, y_m) && !outline_.is_beyond(x_m, y_m);
  }

 private:
  template <typename Keep>
  void keep(const Keep& keeps);
  void place_toes(const Traces& traces);
  [[nodiscard]] bool faces_road(const Traces& traces, const Toe& toe) const;
  /// Whether a berm on the same side is near: then the row of berms is the edge, and what falls lies behind a gap in
  /// it.
  [[nodiscard]] bool is_in_row(const ToePlace& drop) const;

  TraceEdgesConfig config_;
  RoadView view_;
  RoadDivide divide_;
  RoadOutline outline_;
  std::vector<Toe> toes_;
  std::vector<ToePlace> places_;
  std::vector<std::uint8_t> kept_;
};

}  // namespace berm
