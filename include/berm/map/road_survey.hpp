#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "berm/core/config.hpp"
#include "berm/core/edge.hpp"
#include "berm/core/pose_guard.hpp"
#include "berm/core/road.hpp"
#include "berm/core/stamp.hpp"
#include "berm/core/trajectory.hpp"

namespace berm {

/// Settings of the survey of a haul road, and the rules that it has to keep.
struct RoadConfig {
  double spacing_m = 1.0;
  double reach_m = 30.0;
  double attitude_sigma_deg = 0.03;
  double vehicle_width_m = 0.0;
  double min_width_vehicles = 3.5;
  double tyre_height_m = 0.0;
  double min_berm_tyres = 0.5;
  double max_grade_percent = 10.0;

  static void fields(auto&& field) {
    field("spacing_m", &RoadConfig::spacing_m, Range{0.2, 100.0}, "between stations along the driven path");
    field("reach_m", &RoadConfig::reach_m, Range{2.0, 100.0}, "edges are looked for this far to either side");
    field("attitude_sigma_deg", &RoadConfig::attitude_sigma_deg, Range{0.0, 5.0},
          "of roll and pitch, poses and mount together: what slopes cannot be surer of");
    field("vehicle_width_m", &RoadConfig::vehicle_width_m, Range{0.0, 20.0},
          "of the widest truck on the road; 0: unknown, the width is not judged");
    field("min_width_vehicles", &RoadConfig::min_width_vehicles, Range{1.0, 10.0},
          "least width of the road in widths of that truck: 3.5 for two lanes, 2 for one");
    field("tyre_height_m", &RoadConfig::tyre_height_m, Range{0.0, 6.0},
          "outer diameter of the largest tyre; 0: unknown, berms are not judged");
    field("min_berm_tyres", &RoadConfig::min_berm_tyres, Range{0.1, 3.0},
          "least height of a berm in heights of that tyre");
    field("max_grade_percent", &RoadConfig::max_grade_percent, Range{0.5, 50.0}, "steepest grade that is allowed");
  }
  void check() const { check_fields(*this, "road"); }
};

/// An edge point of one scan in the world frame, with the berm that rises from it.
struct SurveyedEdge {
  Eigen::Vector3d position_m;
  float height_m = 0.0F;           ///< 0: not seen to its top
  float width_m = 0.0F;            ///< 0: unknown
  EdgeKind kind = EdgeKind::rise;  ///< at a drop there is no berm
};

/// Measures a road along the path that was driven: what scans saw of ground and berms is gathered at the stations of
/// the path, in memory that grows with the length of the path and not with time.
///
/// Stations lie every `spacing_m` along the path. Where the path jumps, where it was not known while the machine moved,
/// and where the machine turns to drive back, one piece of the path ends and the next begins; pieces shorter than 2 m
/// have no stations, unless there is nothing else. A road that is driven twice has stations of both passes. A scan
/// counts for the pass that it was taken on, and no other: poses of different passes differ by their drift, so that
/// each pass is a measurement of its own, and a scan costs the same on the hundredth lap.
class RoadSurvey {
 public:
  /// `path`: T_world_base. Poses that `guard` does not trust are left out. Throws ConfigError as `RoadConfig::check`
  /// and `PoseGuardConfig::check`.
  RoadSurvey(const RoadConfig& config, const Trajectory& path, const PoseGuardConfig& guard = {});
  ~RoadSurvey();
  RoadSurvey(RoadSurvey&&) noexcept;
  RoadSurvey& operator=(RoadSurvey&&) noexcept;

  /// `stamp_ns`: of the scan. `ground_m`: points of plain road; `raised_m`: of all else that is solid, flanks of berms
  /// among it, where they are known. World frame; what is not finite or farther than 40 m from the machine is left out.
  /// Berms are measured in `raised_m`, and from the heights of `edges` where nothing of that is seen: what an edge
  /// point has climbed lies up to 10 m from it along the road. Scans in the same order, same result.
  void add_scan(Stamp stamp_ns, std::span<const SurveyedEdge> edges, std::span<const Eigen::Vector3d> ground_m,
                std::span<const Eigen::Vector3d> raised_m = {});

  /// The road as it is known by now, with the edges of the map. Which edge is left and which is right follows from the
  /// path alone.
  [[nodiscard]] std::vector<RoadStation> stations(std::span<const EdgeLine> lines) const;

  /// Memory that the survey holds.
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Gives every vertex of `lines` the height of the berm that stations saw there: the mean of those whose edge lies
/// within a metre, by how sure each is. None where no station saw it, and none on a stretch of line that was not seen.
void set_berm_heights(std::span<const RoadStation> stations, std::span<EdgeLine> lines);

}  // namespace berm
