#include "own_edges.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "road_exits.hpp"

namespace berm {
namespace {

constexpr float kRow_m = 25.0F;  // along a row of berms: a drop so near to one is seen through a gap of the row
/// Share of the greatest range: farther out few berms are seen, so that none in view does not say that there is none.
constexpr float kDropShare = 0.6F;
constexpr float kBeside = 0.6F;   // difference of two cosines, below which a place is neither ahead nor behind
constexpr float kOutward = 0.3F;  // sine, below which a trace runs neither way around

}  // namespace

void OwnEdges::process(const Traces& traces, const RoadToes& found) {
  toes_.assign(found.toes().begin(), found.toes().end());
  const auto min_radius_m = static_cast<float>(config_.min_radius_m);
  const auto max_range_m = static_cast<float>(config_.max_range_m);
  view_.clear();
  view_.add_high(traces, found.height_m());
  divide_ = find_exits(traces, found.on_road(), view_);
  place_toes(traces);
  keep([&](std::size_t i) {
    return std::hypot(places_[i].x_m, places_[i].y_m) < max_range_m && (!config_.face || faces_road(traces, toes_[i]));
  });
  if (config_.hide) {
    for (const ToePlace& place : places_) {
      view_.add(place.x_m, place.y_m);
    }
    keep([&](std::size_t i) { return !view_.hides(places_[i].x_m, places_[i].y_m); });
  }
  find_supporters(places_);
  outline_.clear();
  if (config_.outline) {
    for (std::size_t i = 0; i < toes_.size(); ++i) {
      if (toes_[i].kind == EdgeKind::rise) {
        outline_.add(places_[i].x_m, places_[i].y_m);
      }
    }
    outline_.close(divide_, min_radius_m);
    keep([&](std::size_t i) { return !outline_.is_beyond(places_[i].x_m, places_[i].y_m); });
  }
  if (config_.agree) {
    keep([&](std::size_t i) { return !stands_alone(places_[i], places_, min_radius_m); });
  }
  keep([&](std::size_t i) {
    return toes_[i].kind == EdgeKind::rise ||
           (std::hypot(places_[i].x_m, places_[i].y_m) < kDropShare * max_range_m && !is_in_row(places_[i]) &&
            (!toes_[i].into_nothing || places_[i].supporters > 0));
  });
}

bool OwnEdges::is_in_row(const ToePlace& drop) const {
  for (std::size_t i = 0; i < toes_.size(); ++i) {
    if (toes_[i].kind == EdgeKind::rise && places_[i].left == drop.left &&
        std::hypot(places_[i].x_m - drop.x_m, places_[i].y_m - drop.y_m) < kRow_m) {
      return true;
    }
  }
  return false;
}

void OwnEdges::place_toes(const Traces& traces) {
  places_.clear();
  for (const Toe& toe : toes_) {
    const float x = traces.x[toe.before];
    const float y = traces.y[toe.before];
    places_.push_back({.x_m = x, .y_m = y, .left = divide_.is_left(x, y)});
  }
}

template <typename Keep>
void OwnEdges::keep(const Keep& keeps) {
  // Decided for all before any is gone.
  std::size_t kept = 0;
  kept_.resize(toes_.size());
  for (std::size_t i = 0; i < toes_.size(); ++i) {
    kept_[i] = keeps(i) ? 1 : 0;
  }
  for (std::size_t i = 0; i < toes_.size(); ++i) {
    if (kept_[i] != 0) {
      toes_[kept] = toes_[i];
      places_[kept++] = places_[i];
    }
  }
  toes_.resize(kept);
  places_.resize(kept);
}

/// Who walks along a trace from the road to its left edge ahead walks counterclockwise around the sensor; to the left
/// edge behind, clockwise.
bool OwnEdges::faces_road(const Traces& traces, const Toe& toe) const {
  const float x = traces.x[toe.before];
  const float y = traces.y[toe.before];
  const float dx = traces.x[toe.flank] - traces.x[toe.road];
  const float dy = traces.y[toe.flank] - traces.y[toe.road];
  const float range_m = std::hypot(x, y);
  const float step_m = std::hypot(dx, dy);
  const float around = (x * dy - y * dx) / std::max(range_m * step_m, 1e-3F);
  const float ahead = x * std::cos(divide_.ahead_rad) + y * std::sin(divide_.ahead_rad);
  const float behind = x * std::cos(divide_.behind_rad) + y * std::sin(divide_.behind_rad);
  if (std::abs(ahead - behind) < kBeside * range_m || std::abs(around) < kOutward) {
    return true;
  }
  return divide_.is_left(x, y) == ((around > 0.0F) == (ahead > behind));
}

}  // namespace berm
