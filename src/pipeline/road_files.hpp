#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "berm/core/edge.hpp"
#include "berm/core/road.hpp"
#include "berm/io/datum.hpp"
#include "berm/io/output_folder.hpp"
#include "berm/map/edge_map.hpp"
#include "run_report.hpp"

namespace berm {

/// Writes the map, its lines in every format that nothing stands in the way of, and the survey of the road; adds to
/// `files` what was written and to `notes` what was not, and why. Throws FileError(write_failed) as AtomicFile, and
/// Error as `EdgeMap::to_octomap`, `export_edges`.
void write_road_files(const OutputFolder& output, const EdgeMap& map, std::span<const EdgeLine> lines,
                      std::span<const RoadStation> stations, const std::optional<Geodetic>& datum, RunFiles& files,
                      std::vector<std::string>& notes);

}  // namespace berm
