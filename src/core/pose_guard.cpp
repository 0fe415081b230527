#include "berm/core/pose_guard.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>

namespace berm {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// Velocities are taken over this long: RTK noise of 0.03 m makes 0.06 m/s of it.
constexpr double kVelocityWindow_s = 0.5;
/// A road bends less up and down than a machine brakes and turns.
constexpr double kVerticalShare = 0.25;
/// Offsets that round to the same multiple of this share of `max_jump_m` agree.
constexpr double kOffsetCell = 2.0;
/// Forward directions that agree within this, as components of a unit vector, are one attitude.
constexpr double kDirectionCell = 0.2;
/// A cell beyond this holds everything that is as far off.
constexpr double kFarthestCell = 1e9;

/// Unsigned, because stamps at both ends of their range are farther apart than a stamp can tell.
std::uint64_t elapsed_ns(Stamp from_ns, Stamp to_ns) {
  return static_cast<std::uint64_t>(to_ns) - static_cast<std::uint64_t>(from_ns);
}

double elapsed_s(Stamp from_ns, Stamp to_ns) {
  return static_cast<double>(elapsed_ns(from_ns, to_ns)) / kNanosecondsPerSecond;
}

double radians(double deg) {
  return deg * std::numbers::pi / 180.0;
}

/// What a jump adds to position and attitude.
struct Offset {
  Vector3d position_m = Vector3d::Zero();
  Quaterniond rotation = Quaterniond::Identity();
};

/// Poses `first` to `last` without a jump between them, and how far they are off those of the first segment.
struct Segment {
  std::size_t first = 0;
  std::size_t last = 0;
  Offset offset;
  bool agrees = true;
};

struct Velocity {
  Vector3d mps;
  double over_s = 0.0;
};

using Cell = std::array<std::int64_t, 6>;

class Judge {
 public:
  Judge(const std::vector<StampedPose>& poses, const PoseGuardConfig& config) : poses_(poses), config_(config) {}

  /// Segments, with those that deviate from the most marked.
  std::vector<Segment> segments() {
    std::vector<Segment> result(1);
    std::size_t anchor = 0;
    for (std::size_t i = 0; i + 1 < poses_.size(); ++i) {
      result.back().last = i;
      if (jump_between(i, result.back().first, i + 1)) {
        // A single pose tells no velocity: what comes after such poses is compared with what was before them.
        anchor = result.back().first < i ? result.size() - 1 : anchor;
        result.push_back({i + 1, i + 1, offset_after(result[anchor], i + 1)});
      }
    }
    result.back().last = poses_.size() - 1;
    mark_deviating(result);
    return result;
  }

 private:
  [[nodiscard]] Stamp stamp(std::size_t i) const { return poses_[i].stamp_ns; }
  [[nodiscard]] const Vector3d& position_m(std::size_t i) const { return poses_[i].T_world_base.translation_m(); }
  [[nodiscard]] Velocity velocity(std::size_t from, std::size_t to) const {
    const double t_s = elapsed_s(stamp(from), stamp(to));
    return {(position_m(to) - position_m(from)) / t_s, t_s};
  }

  /// The offset of a segment that begins at `begin`, compared with an earlier one.
  [[nodiscard]] Offset offset_after(const Segment& before, std::size_t begin) const {
    const Offset jump = jump_between(before.last, before.first, begin).value_or(Offset{});
    return {before.offset.position_m + jump.position_m, jump.rotation * before.offset.rotation};
  }

  /// The first pose of `begin`..`end` - 1 that is at least so long after `begin`; `end` if there is none.
  [[nodiscard]] std::size_t later_by(std::size_t begin, std::size_t end, double seconds) const {
    const auto first = poses_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = poses_.begin() + static_cast<std::ptrdiff_t>(end);
    const auto found = std::partition_point(
        first, last, [&](const StampedPose& pose) { return elapsed_s(stamp(begin), pose.stamp_ns) < seconds; });
    return static_cast<std::size_t>(found - poses_.begin());
  }

  /// Up to pose `i`, from no earlier than `first`.
  [[nodiscard]] std::optional<Velocity> velocity_before(std::size_t first, std::size_t i) const {
    if (i == first) {
      return std::nullopt;
    }
    const auto begin = poses_.begin() + static_cast<std::ptrdiff_t>(first);
    const auto end = poses_.begin() + static_cast<std::ptrdiff_t>(i);
    const auto near = std::partition_point(
        begin, end, [&](const StampedPose& pose) { return elapsed_s(pose.stamp_ns, stamp(i)) > kVelocityWindow_s; });
    return velocity(std::min(static_cast<std::size_t>(near - poses_.begin()), i - 1), i);
  }

  [[nodiscard]] std::optional<Velocity> velocity_after(std::size_t i) const {
    if (i + 1 == poses_.size()) {
      return std::nullopt;
    }
    const std::size_t far = later_by(i, poses_.size(), kVelocityWindow_s);
    return velocity(i, std::clamp(far, i + 1, poses_.size() - 1));
  }

  /// How far the machine may have come in `t_s` between two velocities.
  [[nodiscard]] static std::vector<Vector3d> guesses_m(const std::optional<Velocity>& before,
                                                       const std::optional<Velocity>& after, double t_s,
                                                       double allowed_m) {
    if (!before || !after) {
      return {(before ? before->mps : after->mps) * t_s};
    }
    const Vector3d mean_m = 0.5 * t_s * (before->mps + after->mps);
    // Half of what is allowed leaves the other half to what they are no guess of.
    if (t_s * (after->mps - before->mps).norm() <= allowed_m) {
      return {mean_m};
    }
    // One of them holds the next jump, nobody knows which.
    return {mean_m, before->mps * t_s, after->mps * t_s};
  }

  /// The part of the step from pose `i`, of a segment that begins at `first`, to pose `k` that no machine drives;
  /// none if the step is plausible.
  [[nodiscard]] std::optional<Offset> jump_between(std::size_t i, std::size_t first, std::size_t k) const {
    const double t_s = elapsed_s(stamp(i), stamp(k));
    const std::optional<Vector3d> moved = position_jump(i, first, k, t_s);
    const Quaterniond turn = poses_[k].T_world_base.rotation() * poses_[i].T_world_base.rotation().conjugate();
    const double angle_rad = 2.0 * std::atan2(turn.vec().norm(), std::abs(turn.w()));
    const bool turned = angle_rad > radians(config_.max_turn_jump_deg + config_.max_turn_deg_per_s * t_s);
    if (!moved && !turned) {
      return std::nullopt;
    }
    return Offset{moved.value_or(Vector3d::Zero()), turned ? turn : Quaterniond::Identity()};
  }

  [[nodiscard]] std::optional<Vector3d> position_jump(std::size_t i, std::size_t first, std::size_t k,
                                                      double t_s) const {
    const Vector3d step_m = position_m(k) - position_m(i);
    const bool too_fast = step_m.norm() > config_.max_jump_m + config_.max_speed_mps * t_s;
    const std::optional<Velocity> before = velocity_before(first, i);
    const std::optional<Velocity> after = velocity_after(k);
    if (!before && !after) {
      return too_fast ? std::optional(step_m) : std::nullopt;
    }
    const double window_s = std::max(before ? before->over_s : 0.0, after ? after->over_s : 0.0);
    // Braking before the middle of the step and accelerating after it, as hard as the machine can.
    const double driven_m = config_.max_acceleration_mps2 * (0.25 * t_s * t_s + 0.5 * t_s * window_s);
    Vector3d deviation_m = Vector3d::Constant(std::numeric_limits<double>::infinity());
    for (const Vector3d& guess_m : guesses_m(before, after, t_s, config_.max_jump_m + driven_m)) {
      const Vector3d other_m = step_m - guess_m;
      deviation_m = other_m.norm() < deviation_m.norm() ? other_m : deviation_m;
    }
    const bool jumps = too_fast || deviation_m.norm() > config_.max_jump_m + driven_m ||
                       std::abs(deviation_m.z()) > config_.max_jump_m + kVerticalShare * driven_m;
    return jumps ? std::optional(deviation_m) : std::nullopt;
  }

  [[nodiscard]] std::uint64_t length_ns(const Segment& segment) const {
    return elapsed_ns(stamp(segment.first), stamp(segment.last)) + 1;
  }

  /// Where `offset` lies relative to `origin`, in cells whose middle one holds what agrees with it.
  [[nodiscard]] Cell cell(const Offset& offset, const Offset& origin) const {
    const Vector3d shift = (offset.position_m - origin.position_m) / (kOffsetCell * config_.max_jump_m);
    const Quaterniond turn = offset.rotation * origin.rotation.conjugate();
    const Vector3d direction = (turn * Vector3d::UnitX() - Vector3d::UnitX()) / kDirectionCell;
    Cell result{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto k = static_cast<Eigen::Index>(axis);
      result[axis] = std::llround(std::clamp(shift[k], -kFarthestCell, kFarthestCell));
      result[axis + 3] = std::llround(direction[k]);
    }
    return result;
  }

  void mark_deviating(std::vector<Segment>& segments) const {
    const auto longest = std::max_element(segments.begin(), segments.end(), [&](const Segment& a, const Segment& b) {
      return length_ns(a) < length_ns(b);
    });
    const Offset origin = longest->offset;
    std::map<Cell, std::uint64_t> length_of;
    for (const Segment& segment : segments) {
      length_of[cell(segment.offset, origin)] += length_ns(segment);
    }
    const auto most = std::max_element(length_of.begin(), length_of.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    for (Segment& segment : segments) {
      segment.agrees = cell(segment.offset, origin) == most->first;
    }
  }

  const std::vector<StampedPose>& poses_;
  const PoseGuardConfig& config_;
};

/// Spans in the order of time; neighbours of one reason become one.
class SpanList {
 public:
  void add(Stamp first_ns, Stamp last_ns, PoseTrust reason) {
    if (first_ns > last_ns) {
      return;
    }
    if (!spans.empty() && spans.back().reason == reason && spans.back().last_ns + 1 == first_ns) {
      spans.back().last_ns = last_ns;
    } else {
      spans.push_back({first_ns, last_ns, reason});
    }
  }

  std::vector<DistrustSpan> spans;
};

void add_gaps(SpanList& list, std::span<const StampedPose> poses, double max_gap_s, std::span<const Stamp> poor_fixes) {
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    const Stamp from = poses[i].stamp_ns;
    const Stamp to = poses[i + 1].stamp_ns;
    if (elapsed_s(from, to) > max_gap_s) {
      const auto poor = std::upper_bound(poor_fixes.begin(), poor_fixes.end(), from);
      list.add(from + 1, to - 1, poor != poor_fixes.end() && *poor < to ? PoseTrust::poor_fix : PoseTrust::gap);
    }
  }
}

std::string seconds_text(Stamp stamp_ns) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.3f", to_seconds(stamp_ns));
  return text.data();
}

}  // namespace

std::string_view trust_name(PoseTrust trust) {
  switch (trust) {
    case PoseTrust::trusted:
      return "trusted";
    case PoseTrust::gap:
      return "gap";
    case PoseTrust::poor_fix:
      return "poor fix";
    case PoseTrust::jump:
      return "jump";
    case PoseTrust::no_pose:
      break;
  }
  return "no pose";
}

PoseGuard::PoseGuard(const Trajectory& trajectory, const PoseGuardConfig& config, std::span<const Stamp> poor_fixes) {
  config.check();
  const std::vector<StampedPose>& poses = trajectory.poses();
  if (poses.empty()) {
    return;
  }
  first_ns_ = poses.front().stamp_ns;
  last_ns_ = poses.back().stamp_ns;
  const std::vector<Segment> segments = Judge(poses, config).segments();
  jumps_ = segments.size() - 1;
  SpanList list;
  for (std::size_t s = 0; s < segments.size(); ++s) {
    const Segment& segment = segments[s];
    if (s > 0) {
      list.add(poses[segment.first - 1].stamp_ns + 1, poses[segment.first].stamp_ns - 1, PoseTrust::jump);
    }
    if (segment.agrees) {
      add_gaps(list, std::span(poses).subspan(segment.first, segment.last - segment.first + 1), config.max_gap_s,
               poor_fixes);
    } else {
      list.add(poses[segment.first].stamp_ns, poses[segment.last].stamp_ns, PoseTrust::jump);
    }
  }
  spans_ = std::move(list.spans);
}

PoseTrust PoseGuard::at(Stamp stamp_ns) const {
  return over(stamp_ns, stamp_ns);
}

PoseTrust PoseGuard::over(Stamp first_ns, Stamp last_ns) const {
  if (first_ns < first_ns_ || last_ns > last_ns_) {
    return PoseTrust::no_pose;
  }
  PoseTrust worst = PoseTrust::trusted;
  auto span =
      std::partition_point(spans_.begin(), spans_.end(), [&](const DistrustSpan& s) { return s.last_ns < first_ns; });
  for (; span != spans_.end() && span->first_ns <= last_ns; ++span) {
    worst = std::max(worst, span->reason);
  }
  return worst;
}

double PoseGuard::seconds(PoseTrust reason) const {
  double sum_s = 0.0;
  for (const DistrustSpan& span : spans_) {
    sum_s += span.reason == reason ? elapsed_s(span.first_ns, span.last_ns) : 0.0;
  }
  return sum_s;
}

std::optional<std::string> find_time_base_problem(const Trajectory& trajectory, Stamp first_scan_ns,
                                                  Stamp last_scan_ns) {
  if (trajectory.empty()) {
    return "there are no poses";
  }
  const Stamp first_ns = trajectory.poses().front().stamp_ns;
  const Stamp last_ns = trajectory.poses().back().stamp_ns;
  if (first_ns <= last_scan_ns && first_scan_ns <= last_ns) {
    return std::nullopt;
  }
  return "poses and scans share no time: poses are from " + seconds_text(first_ns) + " to " + seconds_text(last_ns) +
         " s, scans from " + seconds_text(first_scan_ns) + " to " + seconds_text(last_scan_ns) +
         " s; if they were recorded together, their clocks differ: set poses.time_offset_s, which is added to the "
         "time of poses";
}

}  // namespace berm
