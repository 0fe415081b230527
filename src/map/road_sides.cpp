#include "road_sides.hpp"

#include <cmath>
#include <cstddef>
#include <optional>

#include "road_berm.hpp"
#include "road_median.hpp"

namespace berm {
namespace {

/// Rings are metres apart at the edge: what was seen so far along the path counts for a place.
constexpr double kAlong_m = 1.0;
/// Edge points farther from the line are of something else: the wall behind the berm, a stone on the road.
constexpr double kNearLine_m = 0.75;
/// Of an edge: how ragged the toe is and how well lines follow it, from simulated roads; and the drift of RTK.
constexpr double kEdgeFloor_m = 0.08;
constexpr double kEdgeScatter_m = 0.10;
/// Where no sighting tells: twice the scatter of single sightings.
constexpr double kUnseenEdge_m = 0.30;
/// Of what edge points have climbed: some lies along the road, and rings miss the top, the more the higher it is.
constexpr double kClimbScatter_m = 0.12;
constexpr double kClimbFloor_m = 0.15;
constexpr double kClimbShare = 0.2;
/// Of there being no berm.
constexpr double kDropSigma_m = 0.08;
constexpr double kWidthFloor_m = 0.20;
constexpr double kWidthScatter_m = 0.40;

std::optional<double> crossing(const RoadCrossings& crossings, EdgeSide side) {
  return side == EdgeSide::left ? crossings.left_m : crossings.right_m;
}

struct SideValues {
  LookedValues from_line_m;
  LookedValues heights_m;
  LookedValues widths_m;
  std::size_t rises = 0;
  std::size_t drops = 0;
};

void add(const EdgeSighting& sighting, double line_m, SideValues& values) {
  const double from_line_m = std::abs(double{sighting.left_m}) - line_m;
  if (std::abs(from_line_m) > kNearLine_m) {
    return;
  }
  values.from_line_m.add(from_line_m, sighting.look);
  ++(sighting.kind == EdgeKind::drop ? values.drops : values.rises);
  if (sighting.kind == EdgeKind::rise && sighting.height_m > 0.0F) {
    values.heights_m.add(double{sighting.height_m}, sighting.look);
  }
  if (sighting.kind == EdgeKind::rise && sighting.width_m > 0.0F) {
    values.widths_m.add(double{sighting.width_m}, sighting.look);
  }
}

/// What was seen of the line along a place.
SideValues gather(const RoadSightings& seen, std::span<const RoadCrossings> crossings, std::size_t place,
                  EdgeSide side) {
  SideValues values;
  const auto visit = [&](std::size_t i) {
    const RoadPlace& here = seen.places()[place];
    const RoadPlace& other = seen.places()[i];
    if (other.piece != here.piece || std::abs(other.chainage_m - here.chainage_m) > kAlong_m + 1e-6) {
      return false;
    }
    if (const std::optional<double> line_m = crossing(crossings[i], side)) {
      for (const EdgeSighting& sighting : seen.edges(i, side).all()) {
        add(sighting, *line_m, values);
      }
    }
    return true;
  };
  for (std::size_t i = place + 1; i-- > 0 && visit(i);) {
  }
  for (std::size_t i = place + 1; i < seen.places().size() && visit(i); ++i) {
  }
  return values;
}

std::optional<Measure> climbed_height(const LookedValues& heights_m) {
  std::optional<Measure> height = heights_m.median(kClimbScatter_m, kClimbFloor_m);
  if (height) {
    height->sigma = std::hypot(height->sigma, kClimbShare * height->value);
  }
  return height;
}

}  // namespace

RoadSide measure_side(const RoadSightings& seen, std::span<const RoadCrossings> crossings, std::size_t place,
                      EdgeSide side, const RoadSlopes& slopes) {
  RoadSide result;
  const std::optional<double> line_m = crossing(crossings[place], side);
  if (!line_m) {
    return result;
  }
  const SideValues values = gather(seen, crossings, place, side);
  const std::optional<Measure> off = values.from_line_m.median(kEdgeScatter_m, kEdgeFloor_m);
  // That sightings and line disagree is part of the uncertainty.
  result.edge_m = Measure{*line_m, off ? std::hypot(off->sigma, off->value) : kUnseenEdge_m};
  if (values.drops > values.rises) {
    result.berm_height_m = Measure{0.0, kDropSigma_m};
  } else {
    result.berm_height_m = measure_berm_height(seen, place, side == EdgeSide::left ? *line_m : -*line_m, slopes);
    if (!result.berm_height_m) {
      result.berm_height_m = climbed_height(values.heights_m);
    }
    result.berm_width_m = values.widths_m.median(kWidthScatter_m, kWidthFloor_m);
  }
  return result;
}

}  // namespace berm
