#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "edge_evidence.hpp"
#include "ridge_fit.hpp"

namespace berm {

/// An edge as it was followed, in steps of `kTraceStep_m` where samples are.
struct Trace {
  struct Place {
    Ridge ridge;
    bool after_gap = false;  ///< nothing was seen between the place before and this one
  };
  std::vector<Place> places;
  bool closed = false;  ///< the last place is followed by the first
};

inline constexpr double kTraceStep_m = 0.25;

/// Follows bands of samples, the strongest first, each from its strongest place in both directions.
class RidgeTracer {
 public:
  /// `evidence` is that of `map`; both must outlive the tracer.
  RidgeTracer(const EdgeMap& map, const EdgeEvidence& evidence);

  [[nodiscard]] std::vector<Trace> trace_all();

 private:
  [[nodiscard]] std::vector<std::size_t> seeds() const;
  [[nodiscard]] Trace trace(const Ridge& start);
  enum class End { faded, closed };
  /// Appends places from `start` on, which is itself left out.
  End walk(const Ridge& start, std::int32_t step_sign, std::vector<Trace::Place>& places);
  [[nodiscard]] bool find_next(const Ridge& head, Trace::Place& next) const;
  /// Whether what was seen at a place is enough for an edge; completes what is known of it.
  [[nodiscard]] bool is_edge(Ridge& ridge, double least_log_odds) const;
  void visit(const Ridge& ridge, std::int32_t step);
  [[nodiscard]] bool was_here(const Ridge& ridge, std::int32_t step) const;
  void claim(const Trace& trace);

  const EdgeMap& map_;
  const EdgeEvidence& evidence_;
  EdgeOdds odds_;
  std::vector<std::uint8_t> taken_;      // per sample: part of an edge that was traced, or near it
  std::vector<std::uint32_t> visit_of_;  // per sample: the edge that passed it last,
  std::vector<std::int32_t> step_of_;    // and its step there
  std::uint32_t edge_ = 0;
};

/// The same place, followed the other way.
[[nodiscard]] Ridge turned_back(Ridge ridge);

/// Lengthens ends that stop short of another edge, where the scatter of that one begins, up to it.
void join_ends(std::vector<Trace>& traces);

/// Log-odds of an edge from what was seen in the stretch that a vertex stands for, clamped as in the map.
[[nodiscard]] double ridge_log_odds(const Ridge& ridge, const EdgeOdds& odds);

}  // namespace berm
