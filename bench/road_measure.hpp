#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "berm/eval/edge_metrics.hpp"
#include "road_methods.hpp"
#include "road_runs.hpp"

namespace berm::bench {

/// What a method makes of a road.
struct RoadScore {
  berm::EdgeScore lines;
  /// Median error of the height of the berm that the lines say, over places a metre apart on the true edge; the first
  /// method's alone.
  std::optional<double> height_error_m;
  std::size_t heights = 0;
  double detect_ms = 0.0;  ///< CPU time per scan, median
  double map_ms = 0.0;     ///< the same: moving what was found by the poses, and adding it
  double lines_ms = 0.0;   ///< once, for the road
};

struct RoadResult {
  std::string name;
  std::uint64_t seed = 0;
  double length_m = 0.0;  ///< that was driven
  std::size_t scans = 0;
  double points_a_scan = 0.0;
  std::vector<RoadScore> scores;  ///< one per method
};

/// Takes a simulated recording through the methods: ground stage, edges, poses of gnss.tum, map, lines. With a folder,
/// writes there what the first method found.
[[nodiscard]] RoadResult measure_recording(const std::filesystem::path& recording,
                                           const std::vector<RoadMethod>& methods,
                                           const std::filesystem::path& dump_folder);

/// Simulates the runs and takes them through the methods, `threads` runs at a time. A seed that gives no road that can
/// be driven is replaced by one 100 above. Recordings are kept in the folder `kept`, and used again if they are there;
/// empty: they are not.
[[nodiscard]] std::vector<RoadResult> measure_roads(const std::vector<test::RunPlan>& runs,
                                                    const std::vector<RoadMethod>& methods, std::size_t threads,
                                                    const std::filesystem::path& kept);

}  // namespace berm::bench
