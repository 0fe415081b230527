#pragma once

#include <nlohmann/json_fwd.hpp>

#include "berm/pipeline/run.hpp"

namespace berm {

/// What run.json says of the poses of a run, of the edges of the road, and of the map of the surface.
[[nodiscard]] nlohmann::ordered_json to_json(const PoseFigures& poses);
[[nodiscard]] nlohmann::ordered_json to_json(const EdgeCounts& edges);
[[nodiscard]] nlohmann::ordered_json to_json(const SurfaceCounts& surface);

}  // namespace berm
