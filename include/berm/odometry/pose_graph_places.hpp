#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "berm/odometry/odometry.hpp"
#include "berm/odometry/pose_graph.hpp"

namespace berm {

/// Pairs of places that are the same, and what became of those that were looked at but are not among them.
struct FoundClosures {
  std::vector<Closure> closures;
  std::array<std::size_t, kClosureFates> rejected{};  ///< by ClosureFate
};

/// What a machine saw along its way, thinned, so that places which it passes again are known: in either direction, and
/// by the shapes of their surfaces. Bounded memory: on a long way fewer scans are kept.
class PlaceMemory {
 public:
  PlaceMemory();
  PlaceMemory(const PlaceMemory&) = delete;
  PlaceMemory& operator=(const PlaceMemory&) = delete;
  ~PlaceMemory();

  /// `step`: index of the OdometryStep that comes of `result`, higher every time.
  void add(std::size_t step, const OdometryInput& input, const OdometryResult& result);

  /// `estimate`: what the pose graph says without closures. Where it is sure of both places nothing is looked for.
  [[nodiscard]] FoundClosures find(std::span<const OdometryStep> odometry, const PoseGraphResult& estimate,
                                   const PoseGraphConfig& config) const;

  /// Scans that are kept.
  [[nodiscard]] std::size_t size() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace berm
