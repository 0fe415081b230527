#include "road_sightings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace berm {
namespace {

/// A place is looked up by the cell that a point lies in, and from there along the path.
constexpr float kSightingCell_m = 2.0F;
constexpr int kCells = 40;  // 2 kView_m / kSightingCell_m
constexpr std::int32_t kUnknown = -1;
/// Points farther along the path than this from every place belong to none: a cross-section is no longer than a metre
/// where places lie farther apart, and no shorter where bends spread them.
constexpr double kLeastHalfSlice_m = 0.5;
constexpr double kMostHalfSlice_m = 1.0;
/// The height of the road at the path is that of this strip to both sides: between berms the narrowest roads are wider.
constexpr float kNearPath_m = 3.0F;
/// A higher or lower floor is another road, or a fault.
constexpr double kLevels_m = 15.0;

}  // namespace

void EdgeSightings::add(const EdgeSighting& sighting) {
  if (offered_++ % stride_ != 0) {
    return;
  }
  if (count_ == kMost) {
    for (std::size_t i = 0; i < kMost / 2; ++i) {
      kept_[i] = kept_[2 * i];
    }
    count_ = kMost / 2;
    stride_ *= 2;
  }
  kept_[count_++] = sighting;
}

RoadSightings::RoadSightings(std::vector<RoadPlace> places, double spacing_m, double reach_m)
    : places_(std::move(places)),
      half_slice_m_(std::clamp(spacing_m, kLeastHalfSlice_m, kMostHalfSlice_m)),
      part_m_(std::min(spacing_m, 2.0 * kMostHalfSlice_m) / kParts),
      half_width_m_(std::ceil(reach_m / kStrip_m) * kStrip_m),
      strips_(static_cast<std::size_t>(2.0 * half_width_m_ / kStrip_m)),
      edges_(2 * places_.size()),
      ground_(strips_ * places_.size()),
      looks_(kLooks * places_.size()),
      top_strips_(static_cast<std::size_t>(2.0 * half_width_m_ / kTopStrip_m)),
      tops_m_(top_strips_ * kParts * kWideLooks * places_.size(), kNoTop_m) {}

void RoadSightings::add_scan(Stamp stamp_ns, std::span<const SurveyedEdge> edges,
                             std::span<const Eigen::Vector3d> ground_m, std::span<const Eigen::Vector3d> raised_m) {
  if (places_.empty()) {
    return;
  }
  open_window(stamp_ns);
  for (const SurveyedEdge& edge : edges) {
    Spot spot;
    if (find_spot(edge.position_m, spot) && std::isfinite(edge.height_m) && std::isfinite(edge.width_m)) {
      const std::size_t side = spot.left_m > 0.0F ? 0 : 1;
      edges_[2 * spot.place + side].add({.left_m = spot.left_m,
                                         .height_m = edge.height_m,
                                         .width_m = edge.width_m,
                                         .look = static_cast<std::uint8_t>(look_of(spot.place)),
                                         .kind = edge.kind});
    }
  }
  for (const Eigen::Vector3d& point_m : ground_m) {
    add_ground(point_m);
  }
  for (const Eigen::Vector3d& point_m : raised_m) {
    add_raised(point_m);
  }
}

void RoadSightings::open_window(Stamp stamp_ns) {
  const auto after = std::upper_bound(places_.begin(), places_.end(), stamp_ns,
                                      [](Stamp stamp, const RoadPlace& place) { return stamp < place.stamp_ns; });
  machine_ = after == places_.begin() ? 0 : static_cast<std::size_t>(after - places_.begin()) - 1;
  const RoadPlace& machine = places_[machine_];
  const auto is_in_view = [&](const RoadPlace& place) {
    return place.piece == machine.piece && std::abs(place.chainage_m - machine.chainage_m) <= kView_m;
  };
  first_ = machine_;
  while (first_ > 0 && is_in_view(places_[first_ - 1])) {
    --first_;
  }
  machine_m_ = machine.position_m;
  window_.clear();
  for (std::size_t i = first_; i < places_.size() && is_in_view(places_[i]); ++i) {
    const Eigen::Vector2f from_machine = (places_[i].position_m - machine_m_).head<2>().cast<float>();
    const Eigen::Vector2f ahead = places_[i].ahead.cast<float>();
    window_.push_back({from_machine.x(), from_machine.y(), ahead.x(), ahead.y()});
  }
  nearest_.assign(std::size_t{kCells} * kCells, kUnknown);
}

int RoadSightings::nearest_in_cell(int column, int row) {
  std::int32_t& known = nearest_[static_cast<std::size_t>(row * kCells + column)];
  if (known == kUnknown) {
    const float x_m = (static_cast<float>(column) + 0.5F) * kSightingCell_m - static_cast<float>(kView_m);
    const float y_m = (static_cast<float>(row) + 0.5F) * kSightingCell_m - static_cast<float>(kView_m);
    float least = std::numeric_limits<float>::max();
    for (std::size_t i = 0; i < window_.size(); ++i) {
      const float dx = window_[i].x_m - x_m;
      const float dy = window_[i].y_m - y_m;
      const float squared = dx * dx + dy * dy;
      known = squared < least ? static_cast<std::int32_t>(i) : known;
      least = std::min(least, squared);
    }
  }
  return known;
}

bool RoadSightings::find_spot(const Eigen::Vector3d& point_m, Spot& spot) {
  const auto x_m = static_cast<float>(point_m.x() - machine_m_.x());
  const auto y_m = static_cast<float>(point_m.y() - machine_m_.y());
  constexpr auto kReach_m = static_cast<float>(kView_m);
  const double above_m = point_m.z() - machine_m_.z();
  if (!(std::abs(x_m) < kReach_m && std::abs(y_m) < kReach_m && std::abs(above_m) < kLevels_m)) {
    return false;
  }
  // The last place before the reach, added to it, rounds to twice the reach.
  const auto cell_of = [](float m) { return std::min(static_cast<int>((m + kReach_m) / kSightingCell_m), kCells - 1); };
  int nearest = nearest_in_cell(cell_of(x_m), cell_of(y_m));
  const auto squared_to = [&](int place) {
    const WindowPlace& w = window_[static_cast<std::size_t>(place)];
    return (w.x_m - x_m) * (w.x_m - x_m) + (w.y_m - y_m) * (w.y_m - y_m);
  };
  float least = squared_to(nearest);
  for (const int step : {1, -1}) {
    for (int next = nearest + step; next >= 0 && next < static_cast<int>(window_.size()); next += step) {
      const float squared = squared_to(next);
      if (!(squared < least)) {
        break;
      }
      nearest = next;
      least = squared;
    }
  }
  const WindowPlace& w = window_[static_cast<std::size_t>(nearest)];
  spot.place = first_ + static_cast<std::size_t>(nearest);
  spot.along_m = (x_m - w.x_m) * w.ahead_x + (y_m - w.y_m) * w.ahead_y;
  spot.left_m = (y_m - w.y_m) * w.ahead_x - (x_m - w.x_m) * w.ahead_y;
  return std::abs(spot.along_m) <= static_cast<float>(half_slice_m_) &&
         std::abs(spot.left_m) < static_cast<float>(half_width_m_);
}

std::size_t RoadSightings::look_of(std::size_t place) const {
  const double ahead_m = places_[machine_].chainage_m - places_[place].chainage_m;
  const auto look = static_cast<int>((ahead_m + kView_m) / kLook_m);
  return static_cast<std::size_t>(std::clamp(look, 0, static_cast<int>(kLooks) - 1));
}

void RoadSightings::add_ground(const Eigen::Vector3d& point_m) {
  Spot spot;
  if (!find_spot(point_m, spot)) {
    return;
  }
  const double z_m = point_m.z() - places_[spot.place].position_m.z();
  const auto strip = static_cast<std::size_t>((double{spot.left_m} + half_width_m_) / kStrip_m);
  const auto add = [&](GroundStrip& to) {
    to.sum_z_m += z_m;
    to.sum_along_m += double{spot.along_m};
    to.sum_left_m += double{spot.left_m};
    ++to.count;
  };
  add(ground_[spot.place * strips_ + std::min(strip, strips_ - 1)]);
  if (std::abs(spot.left_m) <= kNearPath_m) {
    add(looks_[spot.place * kLooks + look_of(spot.place)]);
  }
}

void RoadSightings::add_raised(const Eigen::Vector3d& point_m) {
  Spot spot;
  if (!find_spot(point_m, spot)) {
    return;
  }
  const double z_m = point_m.z() - places_[spot.place].position_m.z();
  if (const std::optional<std::size_t> strip = top_strip(double{spot.left_m})) {
    const double part = std::floor(double{spot.along_m} / part_m_) + 0.5 * kParts;
    const auto in_part = static_cast<std::size_t>(std::clamp(part, 0.0, kParts - 1.0));
    const std::size_t look = look_of(spot.place) * kWideLooks / kLooks;
    float& top_m = tops_m_[((spot.place * top_strips_ + *strip) * kParts + in_part) * kWideLooks + look];
    top_m = std::max(top_m, static_cast<float>(z_m));
  }
}

std::optional<std::size_t> RoadSightings::top_strip(double left_m) const {
  const double strip = std::floor((left_m + half_width_m_) / kTopStrip_m);
  return strip >= 0.0 && strip < static_cast<double>(top_strips_) ? std::optional(static_cast<std::size_t>(strip))
                                                                  : std::nullopt;
}

std::size_t RoadSightings::memory_bytes() const {
  return places_.capacity() * sizeof(RoadPlace) + edges_.capacity() * sizeof(EdgeSightings) +
         (ground_.capacity() + looks_.capacity()) * sizeof(GroundStrip) + tops_m_.capacity() * sizeof(float) +
         window_.capacity() * sizeof(WindowPlace) + nearest_.capacity() * sizeof(std::int32_t);
}

}  // namespace berm
