#pragma once

#include <vector>

#include "berm/core/edge.hpp"
#include "berm/io/datum.hpp"

namespace berm::test {

inline Geodetic made_datum() {
  return {48.0, 11.5, 592.3};
}

/// A left edge of three vertices and a right one of two, metres with three decimals; the heights of two berms are
/// known.
inline std::vector<EdgeLine> made_edges() {
  EdgeLine left;
  left.side = EdgeSide::left;
  left.vertices = {{{0.0, 5.125, 0.25}, 1.0, 1.25}, {{10.5, 5.25, 0.5}, 0.75, 0.5}, {{-1200.001, 830.5, -40.0}, 0.125}};
  EdgeLine right;
  right.side = EdgeSide::right;
  right.vertices = {{{0.0, -5.0, 0.0}, 0.5}, {{11.0, -5.0, 0.0}, 0.0}};
  return {left, right};
}

}  // namespace berm::test
