#include "berm/odometry/surface_odometry.hpp"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

#include "berm/core/error.hpp"
#include "scan_points.hpp"
#include "surface_track.hpp"

namespace berm {
namespace {

/// Speeds that a start is tried with: half a metre a second off, and the map pulls the speed right. Faster machines
/// are found by the one that is unsure, for what moves fast on roads is well seen.
constexpr double kStartSpeeds_mps[] = {-1.5, -0.75, 0.0, 0.75, 1.5, 2.25, 3.0, 4.0, 6.0, 8.5, 12.0, 16.0};
/// After so many scans, or parts of long ones, the best few are followed further.
struct Round {
  std::size_t scans;
  std::ptrdiff_t kept;
};
constexpr Round kRounds[] = {{3, 9}, {6, 5}, {11, 3}, {16, 2}, {20, 1}};
/// Of a scan less is taken while there are many tracks: the work on one scan is to stay bounded.
constexpr std::size_t kStartSamples = 900;
constexpr std::size_t kStartMapPoints = 5000;
/// With fewer voxels that hold more than ground, these do not tell one track from the other.
constexpr std::size_t kFewStanding = 100;
/// Lost for so many scans in a row, a new map is begun.
constexpr std::size_t kGiveUp = 20;

}  // namespace

struct SurfaceOdometry::State {
  explicit State(const SurfaceOdometryConfig& settings) : config(settings) { start(Pose()); }

  SurfaceOdometryConfig config;
  ScanThinner scan;
  std::vector<SurfaceTrack> tracks;  ///< one once the start is over
  std::vector<ScanPoint> few;        ///< samples while there are many tracks
  std::vector<ScanPoint> few_for_map;
  std::vector<Pose> revised;
  std::vector<bool> begins_scan;  ///< of the parts since the start
  std::size_t since_start = 0;
  std::size_t session = 0;
  std::optional<Stamp> last_ns;

  void start(const Pose& T_world_base) {
    tracks.clear();
    begins_scan.clear();
    since_start = 0;
    tracks.emplace_back(config, StartGuess{.speed_mps = 0.0, .is_sure = false}, T_world_base);
    if (config.find_start) {
      for (const double speed_mps : kStartSpeeds_mps) {
        tracks.emplace_back(config, StartGuess{.speed_mps = speed_mps, .is_sure = true}, T_world_base);
      }
    }
  }

  /// All of them, or some while there are many tracks.
  std::span<const ScanPoint> choose(const std::vector<ScanPoint>& all, std::size_t count,
                                    std::vector<ScanPoint>& some) const {
    if (tracks.size() <= 2) {
      return all;
    }
    some = all;
    limit_points(some, count);
    return some;
  }

  /// Rings fill the fewest voxels of ground if they are taken not to move: so ground counts only where nothing stands.
  [[nodiscard]] bool nothing_stands() const {
    return std::all_of(tracks.begin(), tracks.end(),
                       [](const SurfaceTrack& track) { return track.map().standing() < kFewStanding; });
  }

  /// The sharpest maps first; those that lost the scan last.
  void sort_tracks(std::vector<OdometryResult>& results) {
    const bool by_all = nothing_stands();
    const auto voxels = [&](std::size_t track) {
      return by_all ? tracks[track].map().size() : tracks[track].map().standing();
    };
    std::vector<std::size_t> order(tracks.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      order[i] = i;
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      const bool a_lost = results[a].health == OdometryHealth::lost;
      const bool b_lost = results[b].health == OdometryHealth::lost;
      return a_lost != b_lost ? b_lost : voxels(a) < voxels(b);
    });
    std::vector<SurfaceTrack> sorted;
    std::vector<OdometryResult> sorted_results;
    for (const std::size_t i : order) {
      sorted.push_back(std::move(tracks[i]));
      sorted_results.push_back(results[i]);
    }
    tracks = std::move(sorted);
    results = std::move(sorted_results);
  }

  OdometryResult add_to_all(Stamp stamp_ns) {
    const auto samples = choose(scan.samples(), kStartSamples, few);
    const auto for_map = choose(scan.for_map(), kStartMapPoints, few_for_map);
    std::vector<OdometryResult> results;
    results.reserve(tracks.size());
    for (SurfaceTrack& track : tracks) {
      results.push_back(track.add(samples, for_map, scan.duration_s(), stamp_ns));
    }
    ++since_start;
    sort_tracks(results);
    OdometryResult result = results.front();
    for (const Round& round : kRounds) {
      if (since_start == round.scans && std::ssize(tracks) > round.kept) {
        tracks.erase(tracks.begin() + round.kept, tracks.end());
      }
    }
    if (tracks.size() > 1 && result.health != OdometryHealth::lost) {
      result.health = OdometryHealth::starting;
    }
    return result;
  }

  OdometryResult add_to_one(Stamp stamp_ns) {
    SurfaceTrack& track = tracks.front();
    OdometryResult result = track.add(scan.samples(), scan.for_map(), scan.duration_s(), stamp_ns);
    track.forget_begins();
    return result;
  }

  OdometryResult add_part(const OdometryInput& input, const ScanPart& part) {
    scan.process(input, config, part);
    const Stamp stamp_ns = input.stamp_ns + from_seconds(static_cast<double>(part.index) * scan.duration_s());
    if (tracks.size() == 1) {
      return add_to_one(stamp_ns);
    }
    begins_scan.push_back(part.index == 0);
    const OdometryResult result = add_to_all(stamp_ns);
    revise();
    return result;
  }

  /// Where the scans since the start began, this one included, as the best track has it now.
  void revise() {
    revised.clear();
    const std::vector<Pose>& begins = tracks.front().begins();
    for (std::size_t i = 0; i < begins.size(); ++i) {
      if (begins_scan[i]) {
        revised.push_back(begins[i]);
      }
    }
  }
};

namespace {

/// Takes the next part of a scan in.
void append_part(OdometryResult& scan, const OdometryResult& part) {
  scan.T_world_end = part.T_world_end;
  scan.covariance = part.covariance;
  scan.duration_s += part.duration_s;
  scan.health = std::max(scan.health, part.health);
  scan.weakest = std::min(scan.weakest, part.weakest);
  scan.samples += part.samples;
  scan.inliers += part.inliers;
  scan.iterations += part.iterations;
}

}  // namespace

SurfaceOdometry::SurfaceOdometry(const SurfaceOdometryConfig& config) {
  config.check();
  state_ = std::make_unique<State>(config);
}

SurfaceOdometry::~SurfaceOdometry() = default;

OdometryResult SurfaceOdometry::process(const OdometryInput& input) {
  State& state = *state_;
  if (input.labels.size() != input.points.size()) {
    throw Error(ErrorCode::invalid_argument, "odometry: expected a label for every point");
  }
  if (state.last_ns && input.stamp_ns <= *state.last_ns) {
    throw Error(ErrorCode::invalid_argument, "odometry: the stamp of a scan is not later than that of the one before");
  }
  state.last_ns = input.stamp_ns;
  const bool is_starting = state.tracks.size() > 1;
  const std::size_t parts = count_parts(input, state.config);
  OdometryResult result = state.add_part(input, {0, parts});
  for (std::size_t i = 1; i < parts; ++i) {
    append_part(result, state.add_part(input, {i, parts}));
  }
  if (is_starting) {
    result.T_world_begin = state.revised.back();
    state.revised.pop_back();
    result.revised = state.revised;
  }
  result.session = state.session;
  if (state.tracks.front().lost_scans() >= kGiveUp) {
    state.start(result.T_world_end);
    ++state.session;
  }
  return result;
}

}  // namespace berm
