#pragma once

#include <nlohmann/json_fwd.hpp>

#include "berm/pipeline/run.hpp"

namespace berm {

/// What run.json says of the poses of a run, and of the edges of the road.
[[nodiscard]] nlohmann::ordered_json to_json(const PoseFigures& poses);
[[nodiscard]] nlohmann::ordered_json to_json(const EdgeCounts& edges);

}  // namespace berm
