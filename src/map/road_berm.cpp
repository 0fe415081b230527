#include "road_berm.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "road_median.hpp"

namespace berm {
namespace {

/// The road next to the toe, which heights are taken from.
constexpr double kRoadFrom_m = 0.5;
constexpr double kRoadTo_m = 4.0;
constexpr std::uint32_t kLeastPoints = 3;
/// What still rises this far from its toe is a wall.
constexpr double kMostReach_m = 5.0;
/// A crest is over where what follows lies lower by this much, and by this share of its height.
constexpr double kFall_m = 0.15;
constexpr double kFallShare = 0.3;
/// Nothing seen over this many strips: the crest hides what lies behind.
constexpr int kHiddenStrips = 2;
/// Lower is no berm.
constexpr double kLeastHeight_m = 0.15;
/// Of the crest from part to part, and what all parts share: the road at the toe, the pose, the spacing of rings.
constexpr double kLeastScatter_m = 0.06;
constexpr double kFloor_m = 0.07;

std::optional<double> road_at_toe_m(const RoadSightings& seen, std::size_t place, double left_m,
                                    const RoadSlopes& slopes) {
  const double grade = slopes.grade ? slopes.grade->value : 0.0;
  const double cross_fall = slopes.cross_fall ? slopes.cross_fall->value : 0.0;
  double sum_m = 0.0;
  int strips = 0;
  for (const GroundStrip& strip : seen.ground(place)) {
    if (strip.count < kLeastPoints) {
      continue;
    }
    // Positive towards the path.
    const double inside_m = left_m > 0.0 ? left_m - strip.left_m() : strip.left_m() - left_m;
    if (inside_m >= kRoadFrom_m && inside_m <= kRoadTo_m) {
      sum_m += strip.z_m() - grade * strip.along_m() + cross_fall * (left_m - strip.left_m());
      ++strips;
    }
  }
  return strips > 0 ? std::optional(sum_m / strips) : std::nullopt;
}

/// How high at least two of the looks say it is, more of four: a truck that stood there for a while, or dust, is in
/// fewer. None where nothing was seen.
std::optional<double> top_of(std::span<const float> tops_m) {
  std::array<float, kWideLooks> sorted_m{};
  std::copy(tops_m.begin(), tops_m.end(), sorted_m.begin());
  std::sort(sorted_m.begin(), sorted_m.end());
  // What saw nothing comes first.
  const auto first = std::upper_bound(sorted_m.begin(), sorted_m.end(), RoadSightings::kNoTop_m);
  const auto count = sorted_m.end() - first;
  if (count == 0) {
    return std::nullopt;
  }
  return double{first[count > 2 ? count / 2 : 0]};
}

/// Height of the crest over `road_m` in one part of a place: outward from the toe until it falls, or hides the rest.
std::optional<double> crest_height_m(const RoadSightings& seen, std::size_t place, std::size_t part, double left_m,
                                     double road_m) {
  std::optional<double> crest_m;
  int hidden = 0;
  for (double beyond_m = 0.0; beyond_m <= kMostReach_m; beyond_m += RoadSightings::kTopStrip_m) {
    const auto strip = seen.top_strip(left_m > 0.0 ? left_m + beyond_m : left_m - beyond_m);
    if (!strip) {
      break;
    }
    const std::optional<double> top_m = top_of(seen.tops_m(place, *strip, part));
    const bool is_known = crest_m && *crest_m >= kLeastHeight_m;
    if (!top_m) {
      if (++hidden >= kHiddenStrips && is_known) {
        return crest_m;
      }
      continue;
    }
    hidden = 0;
    const double height_m = *top_m - road_m;
    if (is_known && height_m < *crest_m - std::max(kFall_m, kFallShare * *crest_m)) {
      return crest_m;
    }
    crest_m = std::max(crest_m.value_or(height_m), height_m);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Measure> measure_berm_height(const RoadSightings& seen, std::size_t place, double left_m,
                                           const RoadSlopes& slopes) {
  const std::optional<double> road_m = road_at_toe_m(seen, place, left_m, slopes);
  if (!road_m) {
    return std::nullopt;
  }
  LookedValues heights_m;
  for (std::size_t part = 0; part < kParts; ++part) {
    const double here_m = *road_m + (slopes.grade ? slopes.grade->value * seen.part_along_m(part) : 0.0);
    if (const auto height_m = crest_height_m(seen, place, part, left_m, here_m)) {
      heights_m.add(*height_m, static_cast<unsigned>(part));
    }
  }
  return heights_m.median(kLeastScatter_m, kFloor_m);
}

}  // namespace berm
