#include "toe_finder.hpp"

#include <algorithm>
#include <cmath>

namespace berm {
namespace {

constexpr float kRoadLine_m = 2.5F;    // of road that its line is drawn through
constexpr float kRoadFloor_m = 0.35F;  // road lies this near to the surface: farther out the surface is known less well
constexpr float kLag_m = 0.7F;         // the line ends this far before a rise shows, so that it is none of the flank
constexpr float kRoadGoesOn = 0.02F;   // a road goes on with no more slope than this against the surface; a line that
                                       // creeps up the foot of a gentle flank has more
constexpr float kShows = 0.4F;         // by this share of the least height
constexpr float kMisfit_m = 0.06F;     // of a flank about its line, at most
constexpr float kLip_m = 0.05F;        // road ends where it lies this far below its line
constexpr float kTryEvery_m = 0.1F;    // where a rise does not turn into an edge
constexpr float kMaxWidth_m = 15.0F;
constexpr float kFallsAgain = 0.3F;    // share of its height, for a flank to be over
constexpr float kFootShare = 0.15F;    // the line of the flank is drawn from this share of its height
constexpr float kSteepShare = 0.5F;    // its upper part begins at this share of that
constexpr float kSteeper = 1.4F;       // and counts alone if it is so much steeper
constexpr float kLowShare = 0.6F;      // the line to the toe is drawn up to this share of that,
constexpr std::size_t kLowFewest = 4;  // through so many points at least
constexpr float kHeadShare = 0.75F;    // to this
constexpr float kHead_m = 0.45F;       // or of this height: higher up a berm bends

}  // namespace

bool ToeFinder::is_road(const TraceProfile& p, std::size_t first, std::size_t last, RoadLine& road) const {
  const TraceProfile::Line line = p.fit(first, last);
  road = {
      .s_m = p.s_m[last], .height_m = line.at(p.s_m[last]), .slope = std::clamp(line.slope, -kRoadGoesOn, kRoadGoesOn)};
  const auto noise_m = static_cast<float>(config_.road_noise_m);
  return line.variance_m2 < noise_m * noise_m && std::abs(line.slope) < static_cast<float>(config_.max_road_slope) &&
         (!config_.own_road || std::abs(line.height_m) < kRoadFloor_m);
}

void ToeFinder::process(const TraceProfile& p, bool end_falls, std::vector<Toe>& toes,
                        std::vector<std::uint8_t>& on_road) const {
  const auto min_run_m = static_cast<float>(config_.min_run_m);
  const float shows_m = kShows * static_cast<float>(config_.min_height_m);
  std::size_t begin = 0;  // nothing before is road of this run
  std::size_t first = 0;  // the window of road that the line is drawn through
  std::size_t last = 0;
  float run_begin_m = 0.0F;
  float next_try_m = 0.0F;
  bool in_run = false;
  for (std::size_t i = 0; i < p.size(); ++i) {
    while (last + 1 < i && p.s_m[i] - p.s_m[last + 1] >= kLag_m) {
      ++last;
    }
    while (p.s_m[last] - p.s_m[first] > kRoadLine_m) {
      ++first;
    }
    RoadLine road;
    if (last < std::max(first, begin) + 3 || p.s_m[last] - p.s_m[first] < min_run_m || !is_road(p, first, last, road)) {
      in_run = false;
      continue;
    }
    if (!in_run) {
      in_run = true;
      run_begin_m = p.s_m[first];
      for (std::size_t k = first; k < last; ++k) {
        on_road[p.index[k]] = 1;
      }
    }
    on_road[p.index[last]] = 1;
    Toe toe;
    std::size_t beyond = 0;
    const float off_m = p.h_m[i] - road.at(p.s_m[i]);
    if (std::abs(off_m) <= shows_m || p.s_m[i] < next_try_m) {
      continue;
    }
    next_try_m = p.s_m[i] + kTryEvery_m;
    if ((off_m > shows_m && find_rise(p, last, i, road, toe, beyond)) ||
        (off_m < -shows_m && find_fall(p, last, i, road, toe, beyond))) {
      toe.run_m = p.s_m[last] - run_begin_m;
      toes.push_back(toe);
      i = beyond;
      begin = first = last = beyond;
      in_run = false;
    }
  }
  if (config_.find_drops && in_run && end_falls) {
    Toe toe;
    toe.kind = EdgeKind::drop;
    toe.before = toe.after = toe.flank = p.index.back();
    toe.road = p.index[last];
    toe.run_m = p.s_m.back() - run_begin_m;
    toes.push_back(toe);
  }
}

bool ToeFinder::find_fall(const TraceProfile& p, std::size_t last, std::size_t shows, const RoadLine& road, Toe& toe,
                          std::size_t& beyond) const {
  if (!config_.find_drops) {
    return false;
  }
  std::size_t k = shows;
  while (k < p.size() && p.h_m[k] - road.at(p.s_m[k]) > -static_cast<float>(config_.min_drop_m)) {
    if (p.s_m[k] - p.s_m[shows] > static_cast<float>(config_.flank_m)) {
      return false;
    }
    ++k;
  }
  if (k == p.size()) {
    return false;
  }
  beyond = k;
  std::size_t lip = shows;
  while (lip > last && p.h_m[lip] - road.at(p.s_m[lip]) < -kLip_m) {
    --lip;
  }
  toe.kind = EdgeKind::drop;
  toe.before = toe.after = p.index[lip];
  toe.road = p.index[last];
  toe.flank = p.index[k];
  return true;
}

bool ToeFinder::find_rise(const TraceProfile& p, std::size_t last, std::size_t shows, const RoadLine& road, Toe& toe,
                          std::size_t& top) const {
  const auto e = [&](std::size_t k) { return p.h_m[k] - road.at(p.s_m[k]); };
  // To the top: until it falls again, the trace breaks off or the berm is as wide as none is.
  top = shows;
  std::size_t k = shows + 1;
  for (; k < p.size() && p.s_m[k] - p.s_m[last] < kMaxWidth_m; ++k) {
    if (e(k) > e(top)) {
      top = k;
    } else if (e(k) < (1.0F - kFallsAgain) * e(top) && e(top) > static_cast<float>(config_.min_height_m)) {
      toe.seen_to_top = true;
      break;
    }
    if (e(top) < static_cast<float>(config_.min_height_m) &&
        p.s_m[k] - p.s_m[shows] > static_cast<float>(config_.flank_m)) {
      return false;
    }
  }
  toe.height_m = e(top);
  if (toe.height_m < static_cast<float>(config_.min_height_m)) {
    return false;
  }
  // The flank, from near the road to below the top.
  const float foot_m = kFootShare * std::min(toe.height_m, kHead_m);
  const float head_m = kHeadShare * std::min(toe.height_m, kHead_m);
  std::size_t to = last + 1;
  while (to < top && e(to) < head_m) {
    ++to;
  }
  std::size_t from = to;
  while (from > last + 1 && e(from - 1) > foot_m) {
    --from;
  }
  if (to < from + 2) {
    return false;
  }
  TraceProfile::Line flank = p.fit(from, to);
  // Ruts and heaps of dirt before the toe: the flank turns up once more.
  std::size_t steep = from;
  while (steep + 2 < to && e(steep) < kSteepShare * head_m) {
    ++steep;
  }
  const TraceProfile::Line upper = p.fit(steep, to);
  if (upper.slope > kSteeper * flank.slope) {
    flank = upper;
    from = steep;
  }
  if (flank.slope - road.slope < static_cast<float>(config_.min_flank_slope) || flank.rms_m() > kMisfit_m) {
    return false;
  }
  // Heaps are cones: a trace climbs them ever less steeply, and a line through all of the flank meets the road too
  // soon.
  TraceProfile::Line foot = flank;
  std::size_t low = from;
  while (low < to && e(low) < kLowShare * head_m) {
    ++low;
  }
  if (low + 1 >= from + kLowFewest) {
    const TraceProfile::Line lower = p.fit(from, low);
    foot = lower.slope > flank.slope ? lower : flank;
  }
  const float meet_m = foot.s0_m - (foot.height_m - road.at(foot.s0_m)) / (foot.slope - road.slope);
  const float toe_m = config_.sub_cell ? meet_m : p.s_m[shows];
  if (meet_m < p.s_m[last] - 1.0F || meet_m > p.s_m[from] + 0.1F) {
    return false;
  }
  const auto behind = std::upper_bound(p.s_m.begin(), p.s_m.end(), toe_m);
  const auto after = std::clamp<std::size_t>(static_cast<std::size_t>(behind - p.s_m.begin()), 1, p.size() - 1);
  toe.before = p.index[after - 1];
  toe.after = p.index[after];
  toe.road = p.index[last];
  toe.flank = p.index[to];
  toe.share = std::clamp((toe_m - p.s_m[after - 1]) / std::max(p.s_m[after] - p.s_m[after - 1], 1e-3F), 0.0F, 1.0F);
  toe.slope = flank.slope;
  toe.misfit_m = flank.rms_m();
  toe.seen_to_top = toe.seen_to_top || k == p.size();
  for (; k < p.size() && p.s_m[k] - toe_m < kMaxWidth_m; ++k) {
    if (e(k) < 0.1F) {
      break;
    }
  }
  toe.width_m = p.s_m[std::min(k, p.size() - 1)] - toe_m;
  return true;
}

}  // namespace berm
