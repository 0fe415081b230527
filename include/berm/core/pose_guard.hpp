#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "berm/core/config.hpp"
#include "berm/core/stamp.hpp"
#include "berm/core/trajectory.hpp"

namespace berm {

/// Settings of what may be believed of given poses.
struct PoseGuardConfig {
  double max_gap_s = 1.0;
  double max_jump_m = 0.4;
  double max_acceleration_mps2 = 2.0;
  double max_speed_mps = 40.0;
  double max_turn_deg_per_s = 60.0;
  double max_turn_jump_deg = 5.0;

  static void fields(auto&& field) {
    field("max_gap_s", &PoseGuardConfig::max_gap_s, Range{0.01, 60.0},
          "longer without a pose, and nothing in between is trusted");
    field("max_jump_m", &PoseGuardConfig::max_jump_m, Range{0.05, 100.0},
          "largest deviation of a step from the motion before and after it; RTK noise is 0.02 to 0.05 m");
    field("max_acceleration_mps2", &PoseGuardConfig::max_acceleration_mps2, Range{0.1, 50.0},
          "of the machine, braking too; allows for more deviation over longer steps");
    field("max_speed_mps", &PoseGuardConfig::max_speed_mps, Range{0.1, 200.0}, "of the machine");
    field("max_turn_deg_per_s", &PoseGuardConfig::max_turn_deg_per_s, Range{1.0, 720.0}, "of the machine, any axis");
    field("max_turn_jump_deg", &PoseGuardConfig::max_turn_jump_deg, Range{0.1, 180.0},
          "largest deviation of a step of the attitude beyond what the machine can turn");
  }
  void check() const { check_fields(*this, "pose_guard"); }
};

/// Whether a pose may be believed, and if not, why. Later ones are worse.
enum class PoseTrust : std::uint8_t {
  trusted,
  gap,       ///< interpolated over more than max_gap_s
  poor_fix,  ///< the same, because the fixes there were too poor to be used
  jump,      ///< within a step that no machine drives, or on the side of one that the rest contradicts
  no_pose,   ///< before the first pose or after the last
};

/// "trusted", "gap", "poor fix", "jump", "no pose".
[[nodiscard]] std::string_view trust_name(PoseTrust trust);

/// Time during which poses are not trusted, both ends included.
struct DistrustSpan {
  Stamp first_ns = 0;
  Stamp last_ns = 0;
  PoseTrust reason = PoseTrust::gap;
};

/// Says for every stamp whether the pose of a trajectory may be written into a map.
///
/// A step of t seconds is a jump where it deviates from the velocity before it, the one after it and the mean of both
/// by more than `max_jump_m` + `max_acceleration_mps2` (t^2 / 4 + t w / 2), which braking and accelerating again within
/// the step would explain; w is the time over which velocities are taken, 0.5 s or one step. In height a quarter of the
/// acceleration counts. Jumps add up, so that what comes back after an excursion is known to agree with what was
/// before. The poses that agree for the longest time are trusted, those that deviate from them are not.
///
/// After a gap small jumps cannot be told from driving: at the default, 1 m sideways is noticed after up to 0.6 s
/// without poses, 1 m in height after 1.5 s, 10 m after 3.5 s.
class PoseGuard {
 public:
  /// Trusts nothing.
  PoseGuard() = default;
  /// `poor_fixes`, rising, are the times of fixes that were left out of the trajectory. Throws ConfigError as
  /// `PoseGuardConfig::check`.
  PoseGuard(const Trajectory& trajectory, const PoseGuardConfig& config, std::span<const Stamp> poor_fixes = {});

  [[nodiscard]] PoseTrust at(Stamp stamp_ns) const;
  /// The worst from `first_ns` to `last_ns`, as for a scan.
  [[nodiscard]] PoseTrust over(Stamp first_ns, Stamp last_ns) const;

  /// Between the first pose and the last; rising, apart from each other.
  [[nodiscard]] const std::vector<DistrustSpan>& spans() const { return spans_; }
  /// Steps that no machine drives.
  [[nodiscard]] std::size_t jumps() const { return jumps_; }
  /// The length of the spans of `reason` in seconds.
  [[nodiscard]] double seconds(PoseTrust reason) const;

 private:
  std::vector<DistrustSpan> spans_;
  std::size_t jumps_ = 0;
  Stamp first_ns_ = 0;
  Stamp last_ns_ = -1;
};

/// What is wrong if poses and scans share no time at all: both spans, and what to do. None where they overlap.
[[nodiscard]] std::optional<std::string> find_time_base_problem(const Trajectory& trajectory, Stamp first_scan_ns,
                                                                Stamp last_scan_ns);

}  // namespace berm
