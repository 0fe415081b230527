#pragma once

#include <vector>

#include "berm/core/edge.hpp"

namespace berm {

/// Leaves out lines that lie behind a longer one: who looks from there to the road meets the rear of an edge first.
/// Beams that pass over a berm show what stands behind it. Lines run as `extract_lines` says.
void drop_rows_behind(std::vector<EdgeLine>& lines);

}  // namespace berm
