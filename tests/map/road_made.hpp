#pragma once

#include <random>
#include <span>
#include <vector>

#include "berm/core/edge.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/map/road_survey.hpp"

namespace berm::test {

/// A road of known width, slopes and berms that follows a circle, or a straight line where `curvature` is 0.
struct MadeRoad {
  Eigen::Vector3d start_m = Eigen::Vector3d::Zero();
  double heading_rad = 0.3;
  double curvature = 0.0;  ///< 1/m, positive to the left
  double left_m = 8.0;     ///< from the path to the edges
  double right_m = 6.0;
  double grade = 0.06;
  double cross_fall = 0.02;  ///< falling to the right
  double left_berm_m = 1.2;
  double right_berm_m = 0.8;

  /// On the surface, `left` of the path at chainage `s_m`.
  [[nodiscard]] Eigen::Vector3d at(double s_m, double left) const;
  [[nodiscard]] Pose pose_at(double s_m) const;
  /// Driven at 5 m/s, 10 poses a second, from `from_m` to `to_m`, beginning at `start_s`.
  [[nodiscard]] Trajectory path(double from_m, double to_m, double start_s = 0.0) const;
  [[nodiscard]] std::vector<StampedPose> poses(double from_m, double to_m, double start_s = 0.0) const;
  /// One of an edge, with a vertex every half metre.
  [[nodiscard]] EdgeLine line(EdgeSide side, double from_m, double to_m) const;
  [[nodiscard]] std::vector<EdgeLine> lines(double from_m, double to_m) const;
};

/// How wrong scans are: white noise of each point, and errors that all points of five metres of driving share.
struct ScanNoise {
  double ground_m = 0.0;
  double edge_m = 0.0;
  double berm_m = 0.0;
  double shared_m = 0.0;
  double shared_slope = 0.0;
};

struct MadeScan {
  Stamp stamp_ns = 0;
  std::vector<SurveyedEdge> edges;
  std::vector<Eigen::Vector3d> ground_m;
  std::vector<Eigen::Vector3d> raised_m;  ///< left to the test
};

/// A scan every metre along the path from `from_m` to `to_m`, as `MadeRoad::path` drives it: ground up to 30 m ahead
/// and behind, berms beyond the edges among it, two edge points a side.
[[nodiscard]] std::vector<MadeScan> made_scans(const MadeRoad& road, double from_m, double to_m, const ScanNoise& noise,
                                               unsigned seed);

/// What a survey says of the made road; `lines` as they are in truth.
[[nodiscard]] std::vector<RoadStation> survey(const RoadConfig& config, const Trajectory& path,
                                              std::span<const MadeScan> scans, std::span<const EdgeLine> lines);

}  // namespace berm::test
