#include "road_surface_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "road_median.hpp"

namespace berm {
namespace {

/// The grade is that of this much road.
constexpr double kHalfWindow_m = 5.0;
constexpr std::size_t kLeastPlaces = 4;
constexpr double kLeastWindow_m = 4.0;
/// The toe of a berm is no longer road.
constexpr double kToe_m = 0.5;
/// Where an edge is not known, that of the road nearby stands in for it, and where that is not known either, this much.
constexpr double kNearby_m = 10.0;
constexpr double kBlindSide_m = 5.0;
/// Fewer points in a strip are no road.
constexpr std::uint32_t kLeastPoints = 3;
constexpr std::size_t kLeastStrips = 4;
/// Of the height of a strip: ruts, stones, the ground stage; and neighbours deviate alike.
constexpr double kStripScatter_m = 0.02;
constexpr double kStripsAlike = 3.0;
/// 0.1 degrees: roll and pitch of the poses and of the mount, which all looks share.
constexpr double kSlopeFloor = 0.0017;
/// Height of a place: of one look, and what all looks share within the window.
constexpr double kLeastHeightScatter_m = 0.02;

/// A weighted straight line y = height + slope x.
class SlopeFit {
 public:
  void add(double x, double y, double weight) {
    w_ += weight;
    x_ += weight * x;
    y_ += weight * y;
    xx_ += weight * x * x;
    xy_ += weight * x * y;
  }
  [[nodiscard]] double spread() const { return xx_ - x_ * x_ / w_; }
  [[nodiscard]] double slope() const { return (xy_ - x_ * y_ / w_) / spread(); }
  [[nodiscard]] double height() const { return (y_ - slope() * x_) / w_; }

 private:
  double w_ = 0.0;
  double x_ = 0.0;
  double y_ = 0.0;
  double xx_ = 0.0;
  double xy_ = 0.0;
};

struct Sample {
  double x = 0.0;
  double y = 0.0;
};

struct FittedSlope {
  double slope = 0.0;
  double scatter = 0.0;
  double spread = 0.0;  ///< weighted sum of squares of x about its mean
};

/// The straight line that most samples agree on: what deviates by more than twice the scatter loses its say.
std::optional<FittedSlope> fit_slope(std::span<const Sample> samples, double least_scatter) {
  constexpr int kRounds = 5;
  std::vector<double> weights(samples.size(), 1.0);
  FittedSlope fitted;
  for (int round = 0; round < kRounds; ++round) {
    SlopeFit fit;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      fit.add(samples[i].x, samples[i].y, weights[i]);
    }
    fitted.spread = fit.spread();
    if (!(fitted.spread > 0.0)) {
      return std::nullopt;
    }
    fitted.slope = fit.slope();
    std::vector<double> off(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      off[i] = std::abs(samples[i].y - fit.height() - fitted.slope * samples[i].x);
    }
    fitted.scatter = std::max(1.4826 * median_of(off), least_scatter);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double share = off[i] / (2.0 * fitted.scatter);
      weights[i] = 1.0 / ((1.0 + share * share) * (1.0 + share * share));
    }
  }
  return fitted;
}

/// How far the road reaches to a side of every place.
std::vector<double> road_reach_m(std::span<const RoadPlace> places, std::span<const RoadCrossings> crossings,
                                 std::optional<double> RoadCrossings::*side) {
  std::vector<double> reach_m(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::optional<double> least_m = crossings[i].*side;
    const auto look_at = [&](std::size_t k) {
      if (places[k].piece != places[i].piece || std::abs(places[k].chainage_m - places[i].chainage_m) > kNearby_m) {
        return false;
      }
      if (crossings[k].*side) {
        least_m = std::min(least_m.value_or(*(crossings[k].*side)), *(crossings[k].*side));
      }
      return true;
    };
    if (!least_m) {
      for (std::size_t k = i; k-- > 0 && look_at(k);) {
      }
      for (std::size_t k = i + 1; k < places.size() && look_at(k); ++k) {
      }
    }
    reach_m[i] = least_m.value_or(kBlindSide_m) - kToe_m;
  }
  return reach_m;
}

std::optional<Measure> fit_cross_fall(const RoadSightings& seen, std::size_t place, double left_m, double right_m,
                                      double grade) {
  std::vector<Sample> samples;
  for (std::size_t i = 0; i < seen.ground(place).size(); ++i) {
    const GroundStrip& strip = seen.ground(place)[i];
    const double x = seen.strip_left_m(i);
    const double half = 0.5 * RoadSightings::kStrip_m;
    if (strip.count >= kLeastPoints && x + half <= left_m && x - half >= -right_m) {
      samples.push_back({x, (strip.sum_z_m - grade * strip.sum_along_m) / strip.count});
    }
  }
  if (samples.size() < kLeastStrips) {
    return std::nullopt;
  }
  const auto fit = fit_slope(samples, kStripScatter_m);
  if (!fit) {
    return std::nullopt;
  }
  const double random = fit->scatter * std::sqrt(kStripsAlike / fit->spread);
  // What rises to the left falls to the right.
  return Measure{fit->slope, std::hypot(random, kSlopeFloor)};
}

std::optional<double> path_height_m(const RoadSightings& seen, std::size_t place) {
  double sum_m = 0.0;
  std::size_t looks = 0;
  for (const GroundStrip& look : seen.looks(place)) {
    if (look.count >= kLeastPoints) {
      sum_m += look.sum_z_m / look.count;
      ++looks;
    }
  }
  return looks > 0 ? std::optional(sum_m / static_cast<double>(looks)) : std::nullopt;
}

std::optional<Measure> fit_grade(std::span<const RoadPlace> places, std::span<const std::optional<double>> heights_m,
                                 std::size_t place) {
  std::vector<Sample> samples;
  const auto visit = [&](std::size_t i) {
    const double along_m = places[i].chainage_m - places[place].chainage_m;
    if (places[i].piece != places[place].piece || std::abs(along_m) > kHalfWindow_m + 1e-6) {
      return false;
    }
    if (heights_m[i]) {
      const double rise_m = places[i].position_m.z() - places[place].position_m.z();
      samples.push_back({along_m, *heights_m[i] + rise_m});
    }
    return true;
  };
  for (std::size_t i = place + 1; i-- > 0 && visit(i);) {
  }
  for (std::size_t i = place + 1; i < places.size() && visit(i); ++i) {
  }
  const auto [least, most] =
      std::minmax_element(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.x < b.x; });
  if (samples.size() < kLeastPlaces || most->x - least->x < kLeastWindow_m) {
    return std::nullopt;
  }
  const auto fit = fit_slope(samples, kLeastHeightScatter_m);
  if (!fit) {
    return std::nullopt;
  }
  const double random = fit->scatter * std::sqrt(kStripsAlike / fit->spread);
  return Measure{fit->slope, std::hypot(random, kSlopeFloor)};
}

}  // namespace

std::vector<RoadSlopes> measure_slopes(const RoadSightings& seen, std::span<const RoadCrossings> crossings) {
  const std::vector<RoadPlace>& places = seen.places();
  std::vector<std::optional<double>> heights_m(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    heights_m[i] = path_height_m(seen, i);
  }
  const std::vector<double> left_m = road_reach_m(places, crossings, &RoadCrossings::left_m);
  const std::vector<double> right_m = road_reach_m(places, crossings, &RoadCrossings::right_m);
  std::vector<RoadSlopes> slopes(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    slopes[i].grade = fit_grade(places, heights_m, i);
    const double grade = slopes[i].grade ? slopes[i].grade->value : 0.0;
    slopes[i].cross_fall = fit_cross_fall(seen, i, left_m[i], right_m[i], grade);
  }
  return slopes;
}

}  // namespace berm
