#pragma once

#include <vector>

#include "berm/map/edge_map.hpp"
#include "ridge_tracer.hpp"

namespace berm {

/// Joins ends of traces that go on in line, one behind the other, in place. Where a row of berms begins and ends its
/// toe turns off the road: up to a few metres of an end are given up if what is left is in line. A joint is as long as
/// `max_hidden_m`, and holds as much as `max_open_m` that was seen to be plain road. The places on it have no hits.
void join_gaps(std::vector<Trace>& traces, const EdgeMap& map, double max_open_m, double max_hidden_m);

}  // namespace berm
