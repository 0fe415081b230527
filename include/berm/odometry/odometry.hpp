#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include <Eigen/Core>

#include "berm/core/label.hpp"
#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/core/stamp.hpp"

namespace berm {

/// How far a pose may be believed. Later ones are worse.
enum class OdometryHealth : std::uint8_t {
  good,
  starting,  ///< the speed at the start is not known yet: poses of this scan and those before may be revised
  weak,      ///< in at least one direction the scan says next to nothing, and the motion before it decides
  lost,      ///< the scan does not fit the map, or says too little: the pose is that of the motion before it
};
inline constexpr std::size_t kOdometryHealths = 4;
/// "good", "starting", "weak", "lost".
[[nodiscard]] std::string_view health_name(OdometryHealth health);

/// What earlier stages know of a scan.
struct OdometryInput {
  PointsView points;              ///< frame of the sensor
  std::span<const Label> labels;  ///< one per point: falling snow, no return and unlabeled points are not used
  Stamp stamp_ns = 0;             ///< start of the scan
  Pose T_base_sensor;
};

/// Translation (m) before rotation (rad).
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Spans are valid until the next call of `process`.
struct OdometryResult {
  Pose T_world_begin;  ///< T_world_base at the stamp of the scan
  Pose T_world_end;    ///< T_world_base at its last point; without times all are taken at the stamp
  double duration_s = 0.0;
  OdometryHealth health = OdometryHealth::good;
  Matrix6d covariance = Matrix6d::Zero();  ///< of T_world_end, along the axes of the world, about the base
  double weakest = 1.0;                    ///< share of what is known in the weakest direction that the scan says, 0..1
  std::size_t samples = 0;                 ///< points that were compared with the map
  std::size_t inliers = 0;                 ///< of these, near a surface of the map
  std::size_t iterations = 0;              ///< steps of the solver
  std::size_t session = 0;  ///< rises where a new map was begun because the machine was lost: poses jump there
  /// New T_world_begin of the scans before this one, the last of them right before it; empty where none is revised.
  std::span<const Pose> revised;
};

/// Where the machine is, scan by scan. The first scan is at the origin of the world.
class Odometry {
 public:
  Odometry() = default;
  Odometry(const Odometry&) = delete;
  Odometry& operator=(const Odometry&) = delete;
  virtual ~Odometry() = default;

  /// Scans come in the order of their stamps. Throws Error(invalid_argument) unless there is a label for every point
  /// and the stamp is later than that of the scan before.
  [[nodiscard]] virtual OdometryResult process(const OdometryInput& input) = 0;
};

}  // namespace berm
