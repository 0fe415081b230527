#include "map_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berm {
namespace {

/// The matcher finds a place from half of this off.
constexpr double kStartStep_m = 1.0;
constexpr double kStartStep_rad = 0.087;
constexpr std::size_t kStartsPerScan = 10;
constexpr std::size_t kMostPlaces = 6;
/// Places nearer to each other than this are one.
constexpr double kSame_m = 0.3;
constexpr double kSame_rad = 0.03;
/// A place must have fitted for so many scans,
constexpr std::size_t kEnoughScans = 10;
/// and all others be left out: those that fit so much worse in sum than the best, in fits of one scan.
constexpr double kMostDoubt = 0.8;
/// A place that did not fit for so many scans in a row is given up.
constexpr std::size_t kGiveUpPlace = 3;

double yaw_of(const Pose& T_map_base) {
  const Eigen::Vector3d forward = T_map_base.rotation() * Eigen::Vector3d::UnitX();
  return std::atan2(forward.y(), forward.x());
}

/// Standing on the ground, heading `yaw_rad`.
Pose pose_on(const MapGround& ground, const Eigen::Vector2d& place_m, double yaw_rad) {
  const Eigen::Vector3d ahead(std::cos(yaw_rad), std::sin(yaw_rad), 0.0);
  Eigen::Matrix3d axes;
  axes.col(2) = ground.normal;
  axes.col(1) = ground.normal.cross(ahead).normalized();
  axes.col(0) = axes.col(1).cross(axes.col(2));
  return {Eigen::Quaterniond(axes), {place_m.x(), place_m.y(), ground.height_m}};
}

bool is_same_place(const Pose& a, const Pose& b) {
  const Vector6d between = (a.inverse() * b).log();
  return between.head<3>().norm() < kSame_m && between.tail<3>().norm() < kSame_rad;
}

}  // namespace

void MapSearch::start(double radius_m, double turn_rad) {
  starts_.clear();
  places_.clear();
  next_ = 0;
  // Half a step beyond the last start is found from it.
  const auto steps = [](double reach, double step) {
    return static_cast<int>(std::ceil(std::max(0.0, reach / step - 0.5)));
  };
  const int across = steps(radius_m, kStartStep_m);
  const int turns = steps(turn_rad, kStartStep_rad);
  for (int y = -across; y <= across; ++y) {
    for (int x = -across; x <= across; ++x) {
      const Eigen::Vector2d offset_m(x * kStartStep_m, y * kStartStep_m);
      if (offset_m.norm() > radius_m + 0.5 * kStartStep_m) {
        continue;
      }
      for (int turn = -turns; turn <= turns; ++turn) {
        starts_.push_back({offset_m, turn * kStartStep_rad});
      }
    }
  }
  std::stable_sort(starts_.begin(), starts_.end(), [](const Start& a, const Start& b) {
    const auto off = [](const Start& start) {
      return start.offset_m.norm() / kStartStep_m + std::abs(start.turn_rad) / kStartStep_rad;
    };
    return off(a) < off(b);
  });
}

void MapSearch::follow_places(std::span<const ScanPoint> samples, const MapTiles& map, const MapMotion& motion) {
  for (Place& place : places_) {
    place.last = place.track.follow(samples, map, motion);
    ++place.scans;
    if (place.last.is_sound && place.last.fit.is_at_home(config_)) {
      place.track.accept(place.last, motion);
      place.misfits = 0;
    } else {
      place.track.drift(motion);
      ++place.misfits;
    }
  }
  std::erase_if(places_, [](const Place& place) { return place.misfits >= kGiveUpPlace; });
}

void MapSearch::try_start(const Start& start, std::span<const ScanPoint> samples, const MapTiles& map,
                          const MapMotion& motion, const Pose& T_map_base) {
  const Eigen::Vector2d place_m = T_map_base.translation_m().head<2>() + start.offset_m;
  const auto ground = map.ground_at(place_m);
  if (!ground) {
    return;
  }
  MapTrack track(matching_, pose_on(*ground, place_m, yaw_of(T_map_base) + start.turn_rad));
  const MapSighting sighting = track.begin(samples, map, motion);
  if (sighting.is_sound && sighting.fit.is_at_home(config_)) {
    track.accept(sighting, motion);
    // It would have fitted as well as the best before, until it is shown not to.
    const double doubt = places_.empty() ? 0.0 : places_.front().doubt;
    places_.push_back({std::move(track), sighting, 1, 0, doubt});
  }
}

void MapSearch::judge() {
  if (places_.empty()) {
    return;
  }
  double best_fit = 0.0;
  for (const Place& place : places_) {
    best_fit = std::max(best_fit, place.last.fit.fit());
  }
  for (Place& place : places_) {
    place.doubt += best_fit - place.last.fit.fit();
  }
  std::stable_sort(places_.begin(), places_.end(), [](const Place& a, const Place& b) { return a.doubt < b.doubt; });
  std::vector<Place> kept;
  for (Place& place : places_) {
    const auto same = std::find_if(kept.begin(), kept.end(), [&place](const Place& other) {
      return is_same_place(place.track.poses().T_world_end, other.track.poses().T_world_end);
    });
    if (same != kept.end()) {
      same->scans = std::max(same->scans, place.scans);
    } else if (kept.size() < kMostPlaces && place.doubt < places_.front().doubt + kMostDoubt) {
      kept.push_back(place);
    }
  }
  places_ = std::move(kept);
}

bool MapSearch::is_decided() const {
  return is_swept() && places_.size() == 1 && places_.front().scans >= kEnoughScans && places_.front().misfits == 0;
}

std::optional<MapTrack> MapSearch::process(std::span<const ScanPoint> samples, const MapTiles& map,
                                           const MapMotion& motion, const Pose& T_map_base) {
  follow_places(samples, map, motion);
  // The likeliest with every scan, but not for ever: a new rival that was not yet told apart would hold up the
  // decision.
  if (next_ > 0 && !is_swept()) {
    try_start({Eigen::Vector2d::Zero(), 0.0}, samples, map, motion, T_map_base);
  }
  for (std::size_t i = 0; i < kStartsPerScan && next_ < starts_.size(); ++i) {
    try_start(starts_[next_++], samples, map, motion, T_map_base);
  }
  judge();
  return is_decided() ? std::optional<MapTrack>(places_.front().track) : std::nullopt;
}

std::optional<MapSighting> MapSearch::best() const {
  return places_.empty() ? std::nullopt : std::optional<MapSighting>(places_.front().last);
}

}  // namespace berm
