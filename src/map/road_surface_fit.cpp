#include "road_surface_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

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
constexpr std::uint32_t kLeastFitPoints = 3;
constexpr std::size_t kLeastStrips = 4;
/// Of the height of a strip: ruts, stones, the ground stage; and neighbours deviate alike.
constexpr double kStripScatter_m = 0.005;
constexpr double kAlike = 2.5;
constexpr double kFitSigmaOverMad = 1.4826;  // of normal errors
/// Of the height of a place, and of that in one look.
constexpr double kLeastHeightScatter_m = 0.010;
constexpr double kLeastLookScatter_m = 0.020;

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

/// The slope that most samples agree on: what deviates by more than twice the scatter loses its say. Its sigma is that
/// of the scatter, of which neighbours share some, and the floor.
std::optional<Measure> measure_slope(std::span<const Sample> samples, double least_scatter, double floor) {
  constexpr int kRounds = 5;
  std::vector<double> weights(samples.size(), 1.0);
  std::vector<double> off(samples.size());
  double slope = 0.0;
  double sigma = 0.0;
  for (int round = 0; round < kRounds; ++round) {
    SlopeFit fit;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      fit.add(samples[i].x, samples[i].y, weights[i]);
    }
    if (!(fit.spread() > 0.0)) {
      return std::nullopt;
    }
    slope = fit.slope();
    for (std::size_t i = 0; i < samples.size(); ++i) {
      off[i] = std::abs(samples[i].y - fit.height() - slope * samples[i].x);
    }
    const double scatter = std::max(kFitSigmaOverMad * median_of(off), least_scatter);
    sigma = scatter * std::sqrt(kAlike / fit.spread());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double share = off[i] / (2.0 * scatter);
      weights[i] = 1.0 / ((1.0 + share * share) * (1.0 + share * share));
    }
  }
  return Measure{slope, std::hypot(sigma, floor)};
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
                                      double grade, double floor) {
  std::vector<Sample> samples;
  for (const GroundStrip& strip : seen.ground(place)) {
    if (strip.count >= kLeastFitPoints && strip.left_m() <= left_m && strip.left_m() >= -right_m) {
      samples.push_back({strip.left_m(), strip.z_m() - grade * strip.along_m()});
    }
  }
  if (samples.size() < kLeastStrips) {
    return std::nullopt;
  }
  // What rises to the left falls to the right.
  return measure_slope(samples, kStripScatter_m, floor);
}

/// Height of the road where the path lies, of all looks alike, over the place along the path where it was seen.
struct PathHeight {
  double along_m = 0.0;
  double above_m = 0.0;
  double scatter_m = 0.0;  ///< of the looks
  int looks = 0;
};

std::optional<PathHeight> path_height(const RoadSightings& seen, std::size_t place, double grade, double cross_fall) {
  PathHeight height;
  std::vector<double> level_m;
  for (const GroundStrip& look : seen.looks(place)) {
    if (look.count >= kLeastFitPoints) {
      const double above_m = look.z_m() - cross_fall * look.left_m();
      height.along_m += look.along_m();
      height.above_m += above_m;
      level_m.push_back(above_m - grade * look.along_m());
    }
  }
  height.looks = static_cast<int>(level_m.size());
  if (height.looks == 0) {
    return std::nullopt;
  }
  height.along_m /= height.looks;
  height.above_m /= height.looks;
  const double middle_m = median_of(level_m);
  for (double& off_m : level_m) {
    off_m = std::abs(off_m - middle_m);
  }
  height.scatter_m = std::max(kFitSigmaOverMad * median_of(std::move(level_m)), kLeastLookScatter_m);
  return height;
}

/// Along the window some looks are replaced by others, with other errors: the rise that this feigns.
double feigned_slope(const PathHeight& height) {
  const double replaced = 2.0 * kHalfWindow_m / kLook_m;
  return height.scatter_m * std::sqrt(2.0 * replaced) / (height.looks * 2.0 * kHalfWindow_m);
}

using PathHeights = std::vector<std::optional<PathHeight>>;

std::optional<Measure> fit_grade(std::span<const RoadPlace> places, const PathHeights& heights, std::size_t place,
                                 double floor) {
  std::vector<Sample> samples;
  const auto visit = [&](std::size_t i) {
    const double along_m = places[i].chainage_m - places[place].chainage_m;
    if (places[i].piece != places[place].piece || std::abs(along_m) > kHalfWindow_m + 1e-6) {
      return false;
    }
    if (heights[i]) {
      const double rise_m = places[i].position_m.z() - places[place].position_m.z();
      samples.push_back({along_m + heights[i]->along_m, rise_m + heights[i]->above_m});
    }
    return true;
  };
  for (std::size_t i = place + 1; i-- > 0 && visit(i);) {
  }
  for (std::size_t i = place + 1; i < places.size() && visit(i); ++i) {
  }
  const auto [least, most] =
      std::minmax_element(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.x < b.x; });
  if (!heights[place] || samples.size() < kLeastPlaces || most->x - least->x < kLeastWindow_m) {
    return std::nullopt;
  }
  return measure_slope(samples, kLeastHeightScatter_m, std::hypot(floor, feigned_slope(*heights[place])));
}

double value_or_level(const std::optional<Measure>& slope) {
  return slope ? slope->value : 0.0;
}

std::vector<std::optional<Measure>> fit_grades(const RoadSightings& seen, std::span<const RoadSlopes> slopes,
                                               double floor) {
  PathHeights heights;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    heights.push_back(path_height(seen, i, value_or_level(slopes[i].grade), value_or_level(slopes[i].cross_fall)));
  }
  std::vector<std::optional<Measure>> grades;
  for (std::size_t i = 0; i < slopes.size(); ++i) {
    grades.push_back(fit_grade(seen.places(), heights, i, floor));
  }
  return grades;
}

}  // namespace

std::vector<RoadSlopes> measure_slopes(const RoadSightings& seen, std::span<const RoadCrossings> crossings,
                                       double slope_floor) {
  const std::vector<RoadPlace>& places = seen.places();
  const std::vector<double> left_m = road_reach_m(places, crossings, &RoadCrossings::left_m);
  const std::vector<double> right_m = road_reach_m(places, crossings, &RoadCrossings::right_m);
  std::vector<RoadSlopes> slopes(places.size());
  // Each slope takes the other out of its heights.
  constexpr int kRounds = 2;
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<std::optional<Measure>> grades = fit_grades(seen, slopes, slope_floor);
    for (std::size_t i = 0; i < places.size(); ++i) {
      slopes[i].grade = grades[i];
      slopes[i].cross_fall =
          fit_cross_fall(seen, i, left_m[i], right_m[i], value_or_level(slopes[i].grade), slope_floor);
    }
  }
  return slopes;
}

}  // namespace berm
