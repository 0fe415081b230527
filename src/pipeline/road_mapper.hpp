#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "berm/core/edge.hpp"
#include "berm/core/label.hpp"
#include "berm/core/pose_guard.hpp"
#include "berm/core/road.hpp"
#include "berm/core/scan.hpp"
#include "berm/edge/edge.hpp"
#include "berm/map/edge_map.hpp"
#include "berm/map/road_survey.hpp"
#include "berm/pipeline/machine.hpp"
#include "berm/pipeline/run.hpp"
#include "run_poses.hpp"
#include "scan_motion.hpp"

namespace berm {

/// What one scan adds to the map, in the world frame. Keeps its memory.
struct PlacedScan {
  Stamp stamp_ns = 0;
  PoseTrust trust = PoseTrust::no_pose;  ///< over the time of the scan; nothing below unless trusted
  std::size_t left_out = 0;              ///< points whose time is not known
  std::vector<MappedEdge> edges;
  std::vector<SurveyedEdge> surveyed;  ///< the same edges
  std::vector<Eigen::Vector3d> plain_m;
  std::vector<Eigen::Vector3d> raised_m;  ///< all else that is solid: flanks of berms
  // Scratch.
  ScanMotion motion;
  std::vector<std::uint8_t> is_plain;
};

/// Takes the edges of scan after scan to the world and gathers them: each point with the pose at its own time, and no
/// scan whose poses are not trusted from its first point to its last. The map does not depend on the order of scans.
class RoadMapper {
 public:
  /// Scans are added to `map`. `first_ns` to `last_ns`: the time of the run, whose path is surveyed.
  RoadMapper(const Machine& machine, const RunPoses& poses, EdgeMap map, Stamp first_ns, Stamp last_ns);

  /// `labels`: one per point of the scan. For any thread: writes to `placed` alone.
  void place(const Scan& scan, std::span<const Label> labels, const EdgeResult& found, PlacedScan& placed) const;
  /// For one thread, in the order of scans.
  void add(const PlacedScan& placed);

  [[nodiscard]] const EdgeMap& map() const { return map_; }
  [[nodiscard]] const PoseGuard& guard() const { return guard_; }
  [[nodiscard]] std::vector<RoadStation> stations(std::span<const EdgeLine> lines) const {
    return survey_.stations(lines);
  }
  /// Of scans and points; nothing of the map and its lines.
  [[nodiscard]] const EdgeCounts& counts() const { return counts_; }

 private:
  const Trajectory& trajectory_;
  PoseGuard guard_;
  EdgeMap map_;
  RoadSurvey survey_;
  EdgeCounts counts_;
};

}  // namespace berm
