#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"

namespace berm {

enum class MountVerdict : std::uint8_t {
  plausible,
  implausible,
  unknown,  ///< no ground that could tell: too few points, or none of the planes in view could be it
};
[[nodiscard]] std::string_view to_string(MountVerdict verdict);

/// The plane that the machine stands on, as the scan shows it, against the mount.
struct MountEstimate {
  double tilt_rad = 0.0;   ///< between the plane's normal and up of the mount: 0..pi
  double pitch_rad = 0.0;  ///< by how much more the nose looks down than the mount says
  double roll_rad = 0.0;   ///< by how much more the right side hangs than the mount says
  double height_m = 0.0;   ///< of the sensor above the plane
};

struct MountCheckResult {
  MountVerdict verdict = MountVerdict::unknown;
  std::optional<MountEstimate> estimate;  ///< none if the verdict is unknown
};

/// Whether a mount can be right. A machine stands on the ground, so the ground around it is about parallel to its base:
/// the plane that most of the scan's surroundings agree on is looked for in all directions, without believing the
/// mount, and compared with it. Hills ahead and walls are no reason to doubt; upside down and 30 degrees off are.
/// Keeps its memory between scans and nothing else.
class MountCheck {
 public:
  /// Ground tilted by more than this against the mount speaks against it.
  static constexpr double kMaxTilt_rad = 0.35;

  /// `points` in the frame of the sensor; those with 1 in `falling` (one per point, or empty) are left out.
  [[nodiscard]] MountCheckResult process(const PointsView& points, std::span<const std::uint8_t> falling,
                                         const Pose& T_base_sensor);

 private:
  struct Plane {
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< unit length, towards the sensor
    float height_m = 0.0F;                             ///< of the sensor above it
    float score = 0.0F;
  };

  void collect(const PointsView& points, std::span<const std::uint8_t> falling, float max_range_m);
  void score(Plane& plane) const;
  void consider(Plane plane, const Eigen::Vector3f& up, Plane& best, Plane& best_upright) const;
  void refine(Plane& plane) const;

  // Points spread evenly over what is near, axes of the sensor.
  std::vector<float> x_;
  std::vector<float> y_;
  std::vector<float> z_;
  std::vector<float> tolerance_m_;
  std::vector<std::uint64_t> taken_;  ///< a bit per cube of space
};

/// What many scans say together.
struct MountSummary {
  MountVerdict verdict = MountVerdict::unknown;
  std::size_t scans = 0;                  ///< that could tell
  std::optional<MountEstimate> estimate;  ///< medians over these
};

/// Gathers the results of a run.
class MountStatistics {
 public:
  void add(const MountCheckResult& result);
  /// Implausible if most of the scans that could tell say so; unknown if fewer than a tenth could.
  [[nodiscard]] MountSummary summarize() const;

 private:
  std::size_t scans_ = 0;
  std::size_t implausible_ = 0;
  std::vector<MountEstimate> estimates_;
};

}  // namespace berm
