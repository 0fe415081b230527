#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base_series.hpp"
#include "berm/piste/envelope_piste.hpp"

namespace berm {

/// The slope ahead as P section 2.2 measures it: a fan in front of the machine is cut into cells, each is represented
/// by the mean of its points, and the slope is the mean over neighbouring representatives (P eq. 2). Keeps its memory.
class SlopeFan {
 public:
  explicit SlopeFan(const EnvelopePisteConfig& config);

  /// Uses the points that are not `interpolated` (one flag per point). A pair with an empty cell is left out; none if
  /// no pair is left. Sigma is the standard error of the mean over the pairs; one pair has no spread, and its sigma is
  /// the largest that a slope can be wrong by, a quarter turn.
  [[nodiscard]] std::optional<SlopeAhead> measure(const BaseSeries& series, std::span<const std::uint8_t> interpolated);

 private:
  struct Cell {
    double x_m = 0.0;
    double y_m = 0.0;
    double z_m = 0.0;
    int points = 0;
  };

  void fill(const BaseSeries& series, std::span<const std::uint8_t> interpolated);

  double min_m_;
  double max_m_;
  double cell_m_;
  double tan_half_angle_;
  std::vector<Cell> cells_;
};

}  // namespace berm
