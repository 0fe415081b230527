#include "trace_joints.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include <Eigen/Geometry>

namespace berm {
namespace {

/// This much of an end may be given up: the foot of a heap of 2 m height, from where it leaves the line of the row.
constexpr double kMostCut_m = 4.0;
constexpr double kCutStep_m = 0.5;
/// The direction of an end is that of the chord of so much of it, and a trace is at least that long.
constexpr double kChord_m = 3.0;
/// A joint turns by no more at either end: scatter of the chords, and a bend of 30 m radius.
constexpr double kTurn_rad = 0.2;
constexpr double kTurnRadPerMetre = 1.0 / 60.0;
/// What a metre of an end is worth, in squared turns.
constexpr double kCutCost = 0.01;
constexpr double kGapCost = 0.004;
/// A joint is no longer than this share of the shorter trace, unless both can see each other past a gap of the row.
constexpr double kShareOfTrace = 2.0;
constexpr double kMostRise = 0.25;  // of a road along a joint
constexpr double kUpperSide = 0.6;  // share of the hits, from which on a trace has a side

/// An end of a trace, looked at from outside.
struct End {
  std::size_t trace = 0;
  bool at_back = false;
  double right = 0.5;  ///< share of the hits of the trace
};

/// An end after some of it was given up.
struct Stub {
  std::size_t given_up = 0;  ///< places
  Eigen::Vector3d position_m;
  Eigen::Vector2d outward;
};

struct Joint {
  std::size_t first = 0;  ///< ends
  std::size_t second = 0;
  Stub from;
  Stub to;
  double cost = 0.0;
};

double length_m(const Trace& trace) {
  return static_cast<double>(trace.places.size()) * kTraceStep_m;
}

const Trace::Place& place(const Trace& trace, const End& end, std::size_t from_end) {
  return end.at_back ? trace.places[trace.places.size() - 1 - from_end] : trace.places[from_end];
}

std::vector<Stub> stubs_of(const Trace& trace, const End& end) {
  const auto chord = static_cast<std::size_t>(kChord_m / kTraceStep_m);
  const auto step = static_cast<std::size_t>(kCutStep_m / kTraceStep_m);
  const auto most = static_cast<std::size_t>(std::min(kMostCut_m, 0.5 * length_m(trace)) / kTraceStep_m);
  std::vector<Stub> stubs;
  for (std::size_t cut = 0; cut <= most && cut + chord < trace.places.size(); cut += step) {
    const Eigen::Vector3d& head_m = place(trace, end, cut).ridge.position_m;
    const Eigen::Vector3d& tail_m = place(trace, end, cut + chord).ridge.position_m;
    stubs.push_back({cut, head_m, (head_m - tail_m).head<2>().normalized()});
  }
  return stubs;
}

double angle(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return std::atan2(from.x() * to.y() - from.y() * to.x(), from.dot(to));
}

/// Places from one stub to the other, both left out: a curve that leaves and meets them in line.
std::vector<Trace::Place> bridge(const Stub& from, const Stub& to) {
  const Eigen::Vector3d across_m = to.position_m - from.position_m;
  const double gap_m = across_m.head<2>().norm();
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::round(gap_m / kTraceStep_m)));
  std::vector<Trace::Place> places;
  for (std::size_t i = 1; i < steps; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(steps);
    const double leave = s * (1.0 - s) * (1.0 - s);
    const double meet = s * s * (1.0 - s);
    Ridge ridge{.position_m = from.position_m + s * s * (3.0 - 2.0 * s) * across_m, .direction = from.outward};
    ridge.position_m.head<2>() += gap_m * (leave * from.outward + meet * to.outward);
    ridge.position_m.z() = from.position_m.z() + s * across_m.z();
    places.push_back({ridge, true});
  }
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Eigen::Vector3d& before_m = i == 0 ? from.position_m : places[i - 1].ridge.position_m;
    const Eigen::Vector3d& after_m = i + 1 == places.size() ? to.position_m : places[i + 1].ridge.position_m;
    places[i].ridge.direction = (after_m - before_m).head<2>().normalized();
  }
  return places;
}

/// Length of a joint on which plain road was seen.
double open_m(const EdgeMap& map, const std::vector<Trace::Place>& places) {
  double sum_m = 0.0;
  for (const Trace::Place& at : places) {
    const auto key = voxel_key(at.ridge.position_m, map.config().voxel_m);
    bool is_open = false;
    for (std::int32_t i = 0; key && i < 27 && !is_open; ++i) {
      is_open = map.at({key->x + i % 3 - 1, key->y + i / 3 % 3 - 1, key->z + i / 9 - 1}).miss != 0;
    }
    sum_m += is_open ? kTraceStep_m : 0.0;
  }
  return sum_m;
}

std::vector<End> ends_of(const std::vector<Trace>& traces) {
  std::vector<End> ends;
  for (std::size_t i = 0; i < traces.size(); ++i) {
    if (traces[i].closed || length_m(traces[i]) < kChord_m) {
      continue;
    }
    double right = 0.0;
    double hits = 0.0;
    for (const Trace::Place& at : traces[i].places) {
      right += at.ridge.right;
      hits += at.ridge.hits();
    }
    ends.push_back({i, false, right / hits});
    ends.push_back({i, true, right / hits});
  }
  return ends;
}

bool may_be_one_side(const End& a, const End& b) {
  return !((a.right > kUpperSide && b.right < 1.0 - kUpperSide) ||
           (b.right > kUpperSide && a.right < 1.0 - kUpperSide));
}

/// The joint that turns least, without a look at the map.
std::optional<Joint> best_joint(const std::vector<Stub>& from, const std::vector<Stub>& to, double max_gap_m) {
  std::optional<Joint> best;
  for (const Stub& a : from) {
    for (const Stub& b : to) {
      const Eigen::Vector3d across_m = b.position_m - a.position_m;
      const double gap_m = across_m.head<2>().norm();
      if (gap_m > max_gap_m || std::abs(across_m.z()) > kMostRise * std::max(gap_m, 1.0)) {
        continue;
      }
      const double leave_rad = angle(a.outward, across_m.head<2>());
      const double meet_rad = angle(across_m.head<2>(), -b.outward);
      const double room_rad = kTurn_rad + kTurnRadPerMetre * gap_m;
      const double cut_m = static_cast<double>(a.given_up + b.given_up) * kTraceStep_m;
      const double cost = leave_rad * leave_rad + meet_rad * meet_rad + kCutCost * cut_m + kGapCost * gap_m;
      if (std::abs(leave_rad) <= room_rad && std::abs(meet_rad) <= room_rad && (!best || cost < best->cost)) {
        best = Joint{.from = a, .to = b, .cost = cost};
      }
    }
  }
  return best;
}

std::vector<Joint> find_joints(const std::vector<Trace>& traces, const std::vector<End>& ends, const EdgeMap& map,
                               double max_open_m, double max_hidden_m) {
  std::vector<std::vector<Stub>> stubs;
  stubs.reserve(ends.size());
  for (const End& end : ends) {
    stubs.push_back(stubs_of(traces[end.trace], end));
  }
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    for (std::size_t k = i + 1; k < ends.size(); ++k) {
      if (ends[i].trace == ends[k].trace || stubs[i].empty() || stubs[k].empty() ||
          !may_be_one_side(ends[i], ends[k]) ||
          (stubs[i].front().position_m - stubs[k].front().position_m).head<2>().norm() >
              max_hidden_m + 2.0 * kMostCut_m) {
        continue;
      }
      const double shorter_m = std::min(length_m(traces[ends[i].trace]), length_m(traces[ends[k].trace]));
      auto joint =
          best_joint(stubs[i], stubs[k], std::min(max_hidden_m, std::max(max_open_m, kShareOfTrace * shorter_m)));
      if (joint && open_m(map, bridge(joint->from, Stub{0, joint->to.position_m, -joint->to.outward})) <= max_open_m) {
        joint->first = i;
        joint->second = k;
        joints.push_back(*joint);
      }
    }
  }
  std::stable_sort(joints.begin(), joints.end(), [](const Joint& a, const Joint& b) { return a.cost < b.cost; });
  return joints;
}

/// Read from its other end, the gap lies on the other side of a place.
void reverse(Trace& trace) {
  std::vector<Trace::Place>& places = trace.places;
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    places[i].after_gap = places[i + 1].after_gap;
  }
  places.back().after_gap = false;
  std::reverse(places.begin(), places.end());
  for (Trace::Place& at : places) {
    at.ridge = turned_back(at.ridge);
  }
}

}  // namespace

void join_gaps(std::vector<Trace>& traces, const EdgeMap& map, double max_open_m, double max_hidden_m) {
  std::vector<End> ends = ends_of(traces);
  std::vector<bool> is_joined(ends.size(), false);
  for (const Joint& joint : find_joints(traces, ends, map, max_open_m, max_hidden_m)) {
    End& first = ends[joint.first];
    End& second = ends[joint.second];
    if (is_joined[joint.first] || is_joined[joint.second] || first.trace == second.trace) {
      continue;
    }
    is_joined[joint.first] = is_joined[joint.second] = true;
    Trace& head = traces[first.trace];
    Trace& tail = traces[second.trace];
    const std::size_t gone = second.trace;
    const std::size_t kept = first.trace;
    const auto turn = [&](std::size_t trace) {
      reverse(traces[trace]);
      for (End& end : ends) {
        end.at_back = end.trace == trace ? !end.at_back : end.at_back;
      }
    };
    if (!first.at_back) {
      turn(kept);
    }
    if (second.at_back) {
      turn(gone);
    }
    head.places.resize(head.places.size() - joint.from.given_up);
    const auto between = bridge(joint.from, Stub{0, joint.to.position_m, -joint.to.outward});
    head.places.insert(head.places.end(), between.begin(), between.end());
    const auto from = tail.places.begin() + static_cast<std::ptrdiff_t>(joint.to.given_up);
    from->after_gap = true;
    head.places.insert(head.places.end(), from, tail.places.end());
    tail.places.clear();
    for (End& end : ends) {
      end.trace = end.trace == gone ? kept : end.trace;
    }
  }
  std::erase_if(traces, [](const Trace& trace) { return trace.places.empty(); });
}

}  // namespace berm
