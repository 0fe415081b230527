#include "ridge_tracer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace berm {
namespace {

/// Evidence of this much edge is weighed together, as a share of the reach, half a metre where much was seen: single
/// voxels of noisy edges are hit once or never.
constexpr double kStretch = 0.25;
/// Once begun, an edge goes on where less was seen: this share of the log-odds that a new one takes.
constexpr double kGoOn = 0.3;
/// Samples this near to an edge that was traced are its scatter.
constexpr double kClaim_m = 0.8;
/// Ends this near to another edge, and pointing to it, meet it there.
constexpr double kMeet_m = 1.5;
constexpr double kMeetCosine = 0.7;
constexpr double kMeetsAlready_m = 0.05;
/// An edge that comes back to itself after fewer steps has only turned.
constexpr std::int32_t kLoopSteps = 24;
constexpr double kSeedRadius_m = 0.5;
/// How far a fit may move a place to the side of where it was expected, and turn it, before it is another edge.
constexpr double kMaxShift_m = 0.2;
constexpr double kMaxTurn_rad = 0.35;
/// The same per metre of a gap.
constexpr double kShiftPerMetre = 0.2;
/// Farther ahead a fit may catch the toe of the end of a row, which turns off the road: see `join_gaps`.
constexpr double kLookAhead_m = 1.0;

double aside_m(const Ridge& frame, const Eigen::Vector3d& place_m) {
  const Eigen::Vector3d to = place_m - frame.position_m;
  return std::abs(to.y() * frame.direction.x() - to.x() * frame.direction.y());
}

/// The place of another trace that an end points to from close by; none if there is none.
const Ridge* find_meeting(const std::vector<Trace>& traces, std::size_t own, const Ridge& end) {
  const Ridge* nearest = nullptr;
  double least_m = kMeet_m;
  for (std::size_t i = 0; i < traces.size(); ++i) {
    if (i == own) {
      continue;
    }
    for (const Trace::Place& place : traces[i].places) {
      const Eigen::Vector3d to = place.ridge.position_m - end.position_m;
      const double distance_m = to.head<2>().norm();
      if (distance_m > kMeetsAlready_m && distance_m < least_m && std::abs(to.z()) < kMeet_m &&
          end.direction.dot(to.head<2>()) >= kMeetCosine * distance_m) {
        least_m = distance_m;
        nearest = &place.ridge;
      }
    }
  }
  return nearest;
}

}  // namespace

Ridge turned_back(Ridge ridge) {
  ridge.direction = -ridge.direction;
  ridge.bend_per_m = -ridge.bend_per_m;
  return ridge;
}

double ridge_log_odds(const Ridge& ridge, const EdgeOdds& odds) {
  return std::clamp(kStretch * ridge.reach_m * (ridge.hits() * odds.hit + ridge.through * odds.miss), odds.min,
                    odds.max);
}

RidgeTracer::RidgeTracer(const EdgeMap& map, const EdgeEvidence& evidence)
    : map_(map),
      evidence_(evidence),
      odds_(edge_odds(map.config())),
      taken_(evidence.samples().size(), 0),
      visit_of_(evidence.samples().size(), 0),
      step_of_(evidence.samples().size(), 0) {}

std::vector<Trace> RidgeTracer::trace_all() {
  std::vector<Trace> traces;
  for (const std::size_t seed : seeds()) {
    if (taken_[seed] != 0) {
      continue;
    }
    const Eigen::Vector3d& place_m = evidence_.samples()[seed].position_m;
    const auto direction = band_direction(evidence_, taken_, place_m);
    if (!direction) {
      continue;
    }
    Ridge start{.position_m = place_m, .direction = *direction};
    for (int round = 0; round < 3; ++round) {
      start = fit_ridge(evidence_, taken_, start).value_or(start);
    }
    if (!is_edge(start, odds_.edge)) {
      continue;
    }
    traces.push_back(trace(start));
    claim(traces.back());
  }
  return traces;
}

void join_ends(std::vector<Trace>& traces) {
  for (std::size_t i = 0; i < traces.size(); ++i) {
    std::vector<Trace::Place>& places = traces[i].places;
    if (traces[i].closed) {
      continue;
    }
    const Trace::Place first = places.front();
    const Trace::Place last = places.back();
    if (const Ridge* meeting = find_meeting(traces, i, last.ridge)) {
      places.push_back(last);
      places.back().ridge.position_m = meeting->position_m;
      places.back().after_gap = false;
    }
    if (const Ridge* meeting = find_meeting(traces, i, turned_back(first.ridge))) {
      places.insert(places.begin(), first);
      places.front().ridge.position_m = meeting->position_m;
      places[1].after_gap = false;
    }
  }
}

std::vector<std::size_t> RidgeTracer::seeds() const {
  const std::vector<EdgeSample>& samples = evidence_.samples();
  std::vector<float> strength(samples.size(), 0.0F);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    evidence_.around(samples[i].position_m, kSeedRadius_m, [&](std::size_t k) {
      if ((samples[k].position_m - samples[i].position_m).squaredNorm() <= kSeedRadius_m * kSeedRadius_m) {
        strength[i] += samples[k].hits();
      }
    });
  }
  std::vector<std::size_t> order(samples.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return strength[a] > strength[b]; });
  return order;
}

Trace RidgeTracer::trace(const Ridge& start) {
  ++edge_;
  visit(start, 0);
  Trace trace;
  std::vector<Trace::Place> ahead;
  std::vector<Trace::Place> behind;
  trace.closed = walk(start, 1, ahead) == End::closed;
  if (!trace.closed) {
    walk(turned_back(start), -1, behind);
  }
  // Read from the other end, the gap lies on the other side of a place.
  for (std::size_t i = behind.size(); i-- > 0;) {
    trace.places.push_back({turned_back(behind[i].ridge), i + 1 < behind.size() && behind[i + 1].after_gap});
  }
  trace.places.push_back({start, !behind.empty() && behind.front().after_gap});
  trace.places.insert(trace.places.end(), ahead.begin(), ahead.end());
  return trace;
}

RidgeTracer::End RidgeTracer::walk(const Ridge& start, std::int32_t step_sign, std::vector<Trace::Place>& places) {
  Ridge head = start;
  Trace::Place next;
  for (std::int32_t step = step_sign; find_next(head, next); step += step_sign) {
    if (was_here(next.ridge, step)) {
      return (next.ridge.position_m - start.position_m).norm() < kClaim_m ? End::closed : End::faded;
    }
    visit(next.ridge, step);
    places.push_back(next);
    head = next.ridge;
  }
  // The last fits stood on samples behind them alone: the edge ends where these do.
  while (!places.empty() && places.back().ridge.ahead_m < -0.5 * kTraceStep_m) {
    places.pop_back();
  }
  if (!places.empty() && places.back().ridge.ahead_m < 0.0) {
    places.back().ridge = advance(places.back().ridge, places.back().ridge.ahead_m);
  }
  return End::faded;
}

bool RidgeTracer::find_next(const Ridge& head, Trace::Place& next) const {
  for (double ahead_m = kTraceStep_m; ahead_m <= kLookAhead_m; ahead_m += kTraceStep_m) {
    const bool gap = ahead_m > kTraceStep_m;
    Ridge from = head;
    if (gap) {
      from.bend_per_m = 0.0;
    }
    const Ridge guess = advance(from, ahead_m);
    auto fit = fit_ridge(evidence_, taken_, guess);
    const double room_m = kMaxShift_m + kShiftPerMetre * (ahead_m - kTraceStep_m);
    if (fit && aside_m(guess, fit->position_m) <= room_m &&
        fit->direction.dot(guess.direction) >= std::cos(kMaxTurn_rad) && is_edge(*fit, kGoOn * odds_.edge)) {
      next = {*fit, gap};
      return true;
    }
  }
  return false;
}

bool RidgeTracer::is_edge(Ridge& ridge, double least_log_odds) const {
  ridge.through = 0.0;
  if (ridge.here <= 0.0 || ridge_log_odds(ridge, odds_) < least_log_odds) {
    return false;
  }
  ridge.through = seen_through(map_, ridge);
  return ridge_log_odds(ridge, odds_) >= least_log_odds;
}

void RidgeTracer::visit(const Ridge& ridge, std::int32_t step) {
  evidence_.around(ridge.position_m, kSeedRadius_m, [&](std::size_t i) {
    if ((evidence_.samples()[i].position_m - ridge.position_m).norm() <= kSeedRadius_m && visit_of_[i] != edge_) {
      visit_of_[i] = edge_;
      step_of_[i] = step;
    }
  });
}

bool RidgeTracer::was_here(const Ridge& ridge, std::int32_t step) const {
  bool found = false;
  evidence_.around(ridge.position_m, kSeedRadius_m, [&](std::size_t i) {
    found = found || (visit_of_[i] == edge_ && std::abs(step_of_[i] - step) > kLoopSteps &&
                      (evidence_.samples()[i].position_m - ridge.position_m).norm() <= 0.5 * kSeedRadius_m);
  });
  return found;
}

void RidgeTracer::claim(const Trace& trace) {
  for (const Trace::Place& place : trace.places) {
    evidence_.around(place.ridge.position_m, kClaim_m, [&](std::size_t i) {
      if ((evidence_.samples()[i].position_m - place.ridge.position_m).norm() <= kClaim_m) {
        taken_[i] = 1;
      }
    });
  }
}

}  // namespace berm
