#include "berm/map/edge_lines.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "edge_evidence.hpp"
#include "ridge_fit.hpp"
#include "ridge_tracer.hpp"
#include "rows_behind.hpp"
#include "trace_joints.hpp"

namespace berm {
namespace {

double probability(double log_odds) {
  return 1.0 / (1.0 + std::exp(-log_odds));
}

using Places = std::vector<Trace::Place>;

/// The side of every place: what most scans saw, where a change of side has to pay for itself (Viterbi, two states).
std::vector<EdgeSide> sides_along(const Places& places) {
  // Metres of full contradiction. Shares, not counts: where a road was driven both ways, chance must not cut the line.
  constexpr double kChange_m = 4.0;
  std::vector<std::array<bool, 2>> from_other(places.size());
  std::array<double, 2> cost{};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Ridge& ridge = places[i].ridge;
    const double right = ridge.hits() > 0.0 ? ridge.right / ridge.hits() : 0.5;
    const std::array<double, 2> against{right * kTraceStep_m, (1.0 - right) * kTraceStep_m};
    std::array<double, 2> next{};
    for (std::size_t side = 0; side < 2; ++side) {
      const double stay = cost[side];
      const double change = cost[1 - side] + kChange_m;
      from_other[i][side] = change < stay;
      next[side] = std::min(stay, change) + against[side];
    }
    cost = next;
  }
  std::vector<EdgeSide> sides(places.size());
  std::size_t side = cost[1] < cost[0] ? 1 : 0;
  for (std::size_t i = places.size(); i-- > 0;) {
    sides[i] = side == 0 ? EdgeSide::left : EdgeSide::right;
    side = from_other[i][side] ? 1 - side : side;
  }
  return sides;
}

double horizontal_m(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return (a - b).head<2>().norm();
}

EdgeLine::Vertex vertex_at(const Trace::Place& place, const EdgeOdds& odds) {
  return {place.ridge.position_m, probability(ridge_log_odds(place.ridge, odds))};
}

/// Vertices at equal distances of about `spacing_m`, the first and last place among them.
std::vector<EdgeLine::Vertex> resample(std::span<const Trace::Place> places, const EdgeOdds& odds, double spacing_m) {
  std::vector<double> at_m(places.size(), 0.0);
  for (std::size_t i = 1; i < places.size(); ++i) {
    at_m[i] = at_m[i - 1] + horizontal_m(places[i].ridge.position_m, places[i - 1].ridge.position_m);
  }
  const auto stretches = static_cast<std::size_t>(std::max(1.0, std::round(at_m.back() / spacing_m)));
  std::vector<EdgeLine::Vertex> vertices;
  std::size_t i = 1;
  for (std::size_t k = 0; k <= stretches; ++k) {
    const double target_m = at_m.back() * static_cast<double>(k) / static_cast<double>(stretches);
    while (i + 1 < places.size() && at_m[i] < target_m) {
      ++i;
    }
    const EdgeLine::Vertex from = vertex_at(places[i - 1], odds);
    const EdgeLine::Vertex to = vertex_at(places[i], odds);
    const double stretch_m = at_m[i] - at_m[i - 1];
    const double share = stretch_m > 0.0 ? std::clamp((target_m - at_m[i - 1]) / stretch_m, 0.0, 1.0) : 0.0;
    double confidence = from.confidence + share * (to.confidence - from.confidence);
    if (places[i].after_gap && share > 0.0 && share < 1.0) {
      confidence = 0.5;
    }
    vertices.push_back({from.position_m + share * (to.position_m - from.position_m), confidence});
  }
  return vertices;
}

/// Whether plain road lies to the left of the line, seen along it.
bool road_on_left(const EdgeMap& map, std::span<const Trace::Place> places) {
  constexpr double kOffsets_m[] = {0.8, 1.2, 1.6, 2.0};
  double balance = 0.0;
  for (const Trace::Place& place : places) {
    const Eigen::Vector3d aside(-place.ridge.direction.y(), place.ridge.direction.x(), 0.0);
    for (const double offset_m : kOffsets_m) {
      for (const double sign : {-1.0, 1.0}) {
        const auto key = voxel_key(place.ridge.position_m + sign * offset_m * aside, map.config().voxel_m);
        for (const int up : {-1, 0, 1}) {
          balance += key && map.at({key->x, key->y, key->z + up}).miss != 0 ? sign : 0.0;
        }
      }
    }
  }
  return balance > 0.0;
}

/// A line of which less than this is sure
constexpr double kShortSure_m = 10.0;
/// has to be sure for this share: two sides of trucks that a guess joins are not.
constexpr double kSureShare = 0.5;

/// Length of a line, where 1 m counts as much as its confidence is above chance, in shares of the most there is.
double sure_length_m(const EdgeLine& line, double max_probability) {
  double sum_m = 0.0;
  for (std::size_t i = 1; i < line.vertices.size(); ++i) {
    const EdgeLine::Vertex& from = line.vertices[i - 1];
    const EdgeLine::Vertex& to = line.vertices[i];
    const double above_chance = 0.5 * (from.confidence + to.confidence) - 0.5;
    sum_m += horizontal_m(from.position_m, to.position_m) * above_chance / (max_probability - 0.5);
  }
  return sum_m;
}

bool is_kept(const EdgeLine& line, double max_probability, double min_length_m) {
  const double sure_m = sure_length_m(line, max_probability);
  double length_m = 0.0;
  for (std::size_t i = 1; i < line.vertices.size(); ++i) {
    length_m += horizontal_m(line.vertices[i].position_m, line.vertices[i - 1].position_m);
  }
  return sure_m >= min_length_m && (sure_m >= kShortSure_m || sure_m >= kSureShare * length_m);
}

}  // namespace

std::vector<EdgeLine> extract_lines(const EdgeMap& map, const EdgeLinesConfig& config) {
  config.check();
  const EdgeEvidence evidence(map);
  const EdgeOdds odds = edge_odds(map.config());
  std::vector<EdgeLine> lines;
  std::vector<Trace> traces = RidgeTracer(map, evidence).trace_all();
  join_gaps(traces, map, config.max_gap_m, config.max_hidden_m);
  join_ends(traces);
  for (Trace& trace : traces) {
    if (trace.closed) {
      trace.places.push_back(trace.places.front());
    }
    const std::vector<EdgeSide> sides = sides_along(trace.places);
    for (std::size_t first = 0; first < sides.size();) {
      std::size_t end = first;
      while (end < sides.size() && sides[end] == sides[first]) {
        ++end;
      }
      // Where the side changes, both parts have the place.
      const std::span<const Trace::Place> part(trace.places.data() + first, std::min(end + 1, sides.size()) - first);
      const EdgeSide side = sides[first];
      first = end;
      if (part.size() < 2) {
        continue;
      }
      EdgeLine line{side, resample(part, odds, config.spacing_m)};
      if (!is_kept(line, map.config().max_probability, config.min_length_m)) {
        continue;
      }
      if (road_on_left(map, part) == (side == EdgeSide::left)) {
        std::reverse(line.vertices.begin(), line.vertices.end());
      }
      lines.push_back(std::move(line));
    }
  }
  drop_rows_behind(lines);
  return lines;
}

}  // namespace berm
