#pragma once

#include <memory>

#include "berm/core/config.hpp"
#include "berm/edge/edge.hpp"

namespace berm {

/// Settings of the published edge method: METHODS section 4. E names its numbers and gives none; docs/edges.md says
/// where these are from.
struct RingEdgesConfig {
  int sectors = 360;
  double t1_m = 0.15;
  double t2_m = 0.25;
  double t3_m = 0.3;
  double alpha = 0.1;
  double beta = 0.7;
  int guessed_rings = 64;

  static void fields(auto&& field) {
    using C = RingEdgesConfig;
    field("sectors", &C::sectors, Range{16, 3600}, "of the polar grid over a full turn");
    field("t1_m", &C::t1_m, Range{0.0, 10.0}, "cells with less height from lowest to highest may be ground (E: T1)");
    field("t2_m", &C::t2_m, Range{0.0, 10.0},
          "so may those that lie less than this above or below their neighbours on the ring (E: T2); a rise of this "
          "outward is an edge");
    field("t3_m", &C::t3_m, Range{0.0, 10.0},
          "a ring that wanders by less from sector to sector and then turns away marks an edge (E: T3)");
    field("alpha", &C::alpha, Range{0.0, 1.0},
          "rings nearer together than this share of what they are on flat ground lie on something upright");
    field("beta", &C::beta, Range{0.0, 1.0}, "rings farther apart than this share lie on flat ground");
    field(
        "guessed_rings", &C::guessed_rings, Range{2, 256},
        "scans without ring numbers, whose beams do not lie apart by elevation, get this many from lowest to highest");
  }
  void check() const;
};

/// Road edges as document E finds them.
class RingEdges final : public EdgeDetector {
 public:
  /// Throws ConfigError as `RingEdgesConfig::check`.
  explicit RingEdges(const RingEdgesConfig& config);
  ~RingEdges() override;

  /// Throws Error(invalid_argument) unless there is a label for every point.
  [[nodiscard]] EdgeResult process(const EdgeInput& input) override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace berm
