#include "scan_placing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace berm {
namespace {

/// Earliest and latest time of a scan's points since its stamp; both 0 where they have none.
struct TimeSpan {
  double first_s = 0.0;
  double last_s = 0.0;
};

TimeSpan span_of(std::span<const float> times_s) {
  std::optional<TimeSpan> span;
  for (const float time_s : times_s) {
    if (std::isfinite(time_s)) {
      const auto t = double{time_s};
      span = span ? TimeSpan{std::min(span->first_s, t), std::max(span->last_s, t)} : TimeSpan{t, t};
    }
  }
  return span.value_or(TimeSpan{});
}

/// Scans that end later, or at the end of time, have no pose.
std::optional<Stamp> stamp_at(Stamp stamp_ns, double time_s) {
  constexpr double kLongest_s = 1e6;
  Stamp result = 0;
  if (std::abs(time_s) > kLongest_s || __builtin_add_overflow(stamp_ns, from_seconds(time_s), &result)) {
    return std::nullopt;
  }
  return result;
}

}  // namespace

PoseTrust place_scan(const Scan& scan, const Trajectory& T_world_base, const PoseGuard& guard, ScanMotion& motion,
                     double& first_s) {
  const TimeSpan span = span_of(scan.cloud.view().time);
  const auto first_ns = stamp_at(scan.stamp_ns, span.first_s);
  const auto last_ns = stamp_at(scan.stamp_ns, span.last_s);
  const PoseTrust trust = first_ns && last_ns ? guard.over(*first_ns, *last_ns) : PoseTrust::no_pose;
  if (trust != PoseTrust::trusted) {
    return trust;
  }
  first_s = span.first_s;
  return motion.set(T_world_base, scan.T_base_sensor, *first_ns, *last_ns) ? trust : PoseTrust::no_pose;
}

}  // namespace berm
