#include "across_toes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <tuple>

namespace berm {
namespace {

constexpr std::size_t kFewest = 3;       // points of a trace in a sector
constexpr float kFloor_m = 0.08F;        // the first trace on the road lies this near to its surface
constexpr float kLevel_m = 0.06F;        // and a trace on it by no more above the one before,
constexpr float kLevelPerMetre = 0.04F;  // with what the surface may be wrong per metre
constexpr float kRoadGap_m = 3.0F;       // from the last trace on the road to the first on the flank
constexpr float kFlankGap_m = 1.5F;      // between two on the flank
/// A first trace alone may run along the flank of a berm that stands in the blind spot.
constexpr std::size_t kRoadTraces = 2;
constexpr float kRoadShare = 0.5F;
constexpr float kLeastSlope = 0.3F;  // of a flank outward: dumped rock lies at 0.6 to 0.85
constexpr float kMostSlope = 1.7F;   // the side of a truck stands more upright than dumped rock
constexpr float kGoesOn = 0.05F;     // a road goes on with no more slope than this
constexpr float kBack_m = 0.2F;      // the toe may lie this far before the last trace on the road

}  // namespace

void AcrossToes::process(const Traces& traces, std::span<const float> height_m, std::span<const std::uint8_t> on_road,
                         std::vector<Toe>& toes) {
  gather(traces, height_m, on_road);
  std::sort(nodes_.begin(), nodes_.end(), [](const Node& a, const Node& b) {
    return std::tie(a.sector, a.range_m, a.point) < std::tie(b.sector, b.range_m, b.point);
  });
  for (std::size_t begin = 0; begin < nodes_.size();) {
    std::size_t end = begin + 1;
    while (end < nodes_.size() && nodes_[end].sector == nodes_[begin].sector) {
      ++end;
    }
    find_toe(std::span(nodes_).subspan(begin, end - begin), toes);
    begin = end;
  }
}

void AcrossToes::gather(const Traces& traces, std::span<const float> height_m, std::span<const std::uint8_t> on_road) {
  nodes_.clear();
  nodes_.reserve(traces.x.size() / kFewest);
  const auto max_range2 = static_cast<float>(config_.max_range_m * config_.max_range_m);
  const std::size_t size = traces.x.size();
  for (std::size_t begin = 0; begin < size;) {
    const auto sector = sectors_.of(traces.x[begin], traces.y[begin]);
    Node sum;
    std::size_t end = begin;
    do {
      sum.range_m += std::sqrt(traces.x[end] * traces.x[end] + traces.y[end] * traces.y[end]);
      sum.height_m += height_m[end];
      sum.road += static_cast<float>(on_road[end]);
      ++end;
    } while (end < size && traces.is_broken[end] == 0 && sectors_.of(traces.x[end], traces.y[end]) == sector);
    if (end - begin >= kFewest) {
      const auto count = static_cast<float>(end - begin);
      const Node node{.sector = sector,
                      .range_m = sum.range_m / count,
                      .height_m = sum.height_m / count,
                      .road = sum.road / count,
                      .point = static_cast<std::uint32_t>((begin + end) / 2)};
      // Not for NaN.
      if (node.range_m * node.range_m < max_range2) {
        nodes_.push_back(node);
      }
    }
    begin = end;
  }
}

void AcrossToes::find_toe(Nodes nodes, std::vector<Toe>& toes) const {
  std::size_t i = 0;
  while (i < nodes.size() && !(nodes[i].road >= kRoadShare && std::abs(nodes[i].height_m) < kFloor_m)) {
    ++i;
  }
  float slope = 0.0F;
  const std::size_t first = i;
  for (++i; i < nodes.size(); ++i) {
    const Node& road = nodes[i - 1];
    const float step_m = nodes[i].range_m - road.range_m;
    const float rise_m = nodes[i].height_m - road.height_m;
    if (std::abs(rise_m) > kLevel_m + kLevelPerMetre * step_m) {
      if (rise_m > 0.0F && step_m < kRoadGap_m && i - first >= kRoadTraces) {
        add_toe(nodes, i, slope, toes);
      }
      return;
    }
    slope = step_m > 0.5F ? std::clamp(rise_m / step_m, -kGoesOn, kGoesOn) : slope;
  }
}

void AcrossToes::add_toe(Nodes nodes, std::size_t i, float road_slope, std::vector<Toe>& toes) const {
  const Node& road = nodes[i - 1];
  const auto above_m = [&](const Node& node) {
    return node.height_m - road.height_m - road_slope * (node.range_m - road.range_m);
  };
  if (i + 1 >= nodes.size() || nodes[i + 1].range_m - nodes[i].range_m > kFlankGap_m) {
    return;
  }
  const float foot_m = above_m(nodes[i]);
  const float slope = (above_m(nodes[i + 1]) - foot_m) / std::max(nodes[i + 1].range_m - nodes[i].range_m, 0.05F);
  float top_m = foot_m;
  for (std::size_t k = i + 1; k < nodes.size() && above_m(nodes[k]) > top_m; ++k) {
    top_m = above_m(nodes[k]);
  }
  if (slope < kLeastSlope || slope > kMostSlope || top_m < static_cast<float>(config_.min_height_m)) {
    return;
  }
  const float range_m = nodes[i].range_m - foot_m / slope;
  if (range_m < road.range_m - kBack_m || range_m > nodes[i].range_m) {
    return;
  }
  const float share =
      std::clamp((range_m - road.range_m) / std::max(nodes[i].range_m - road.range_m, 0.05F), 0.0F, 1.0F);
  toes.push_back({.before = road.point,
                  .after = nodes[i].point,
                  .road = road.point,
                  .flank = nodes[i].point,
                  .share = share,
                  .below_m = share * foot_m,
                  .height_m = top_m,
                  .slope = slope,
                  .across = true});
}

}  // namespace berm
