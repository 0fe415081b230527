#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base_series.hpp"
#include "berm/piste/envelope_piste.hpp"

namespace berm {

/// Finds the steps of the waveform (P eqs. 3-8). Neighbours are those of the firing order; one beyond an end of the
/// scan casts no vote. Keeps its memory.
class WaveformSteps {
 public:
  /// One flag per point, valid until the next call: 1 for a z step or an x step. `slope_rad` is theta.
  [[nodiscard]] std::span<const std::uint8_t> find(const BaseSeries& series, double slope_rad,
                                                   const EnvelopePisteConfig& config);

 private:
  void mark_z_steps(const BaseSeries& series, float threshold_m, const EnvelopePisteConfig& config);
  void mark_x_steps(const BaseSeries& series, float threshold_m, const EnvelopePisteConfig& config);

  std::vector<std::uint8_t> steps_;
  std::vector<std::uint8_t> votes_;
};

}  // namespace berm
