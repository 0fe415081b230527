#include "first_alignment.hpp"

#include <algorithm>
#include <cmath>

namespace berm {
namespace {

constexpr std::size_t kMostWindows = 200;
constexpr std::size_t kJudges = 2000;
/// What an odometry and the fit of a window are off after a way, at most; and how much the fixes are.
constexpr double kRingDriftShare = 0.03;
constexpr double kSigmas = 5.0;

}  // namespace

std::optional<Alignment> align_first(std::span<const SeenFix> seen, std::span<const FixWindow> windows,
                                     std::span<const WindowFit> fits, std::span<const double> path_m) {
  if (seen.empty()) {
    return std::nullopt;
  }
  const std::size_t window_stride = std::max<std::size_t>(1, windows.size() / kMostWindows);
  const std::size_t judge_stride = std::max<std::size_t>(1, seen.size() / kJudges);
  std::optional<std::size_t> best;
  double best_votes = -1.0;
  for (std::size_t w = 0; w < windows.size(); w += window_stride) {
    const SeenFix& middle = seen[windows[w].first + windows[w].count / 2];
    double votes = fits[w].has_heading() ? 0.5 : 0.0;  // among equals the one that knows its heading
    for (std::size_t i = 0; i < seen.size(); i += judge_stride) {
      const double way_m = std::abs(path_m[seen[i].step] - path_m[middle.step]);
      const double off_m = (fits[w].T_world_odom * seen[i].antenna_odom_m - seen[i].position_m).norm();
      // The nearer, the less the odometry excuses: otherwise far fixes would vote for anything.
      const double bound_m = kSigmas * seen[i].sigma_m + 0.05 + kRingDriftShare * way_m;
      votes += off_m < bound_m ? 1.0 : 0.0;
    }
    if (votes > best_votes) {
      best_votes = votes;
      best = w;
    }
  }
  return Alignment{fits[*best].T_world_odom, fits[*best].has_heading()};
}

}  // namespace berm
