#include "waveform_steps.hpp"

#include <cmath>

namespace berm {
namespace {

/// D_z of P eq. 3 (`side` -1) or U_z of P eq. 4 (`side` +1): neighbours on that side whose height differs.
void count_z_votes(const BaseSeries& series, float threshold_m, int neighbours, int side,
                   std::vector<std::uint8_t>& votes) {
  votes.assign(series.size(), 0);
  const std::span<const float> z = series.z();
  for (int k = 1; k <= neighbours; ++k) {
    const std::span<const float> other = series.z_later(side * k);
    for (std::size_t i = 0; i < z.size(); ++i) {
      votes[i] = static_cast<std::uint8_t>(votes[i] + (std::abs(z[i] - other[i]) > threshold_m ? 1 : 0));
    }
  }
}

/// S_x of P eq. 6: neighbours on both sides that this point lies ahead of.
void count_x_votes(const BaseSeries& series, float threshold_m, int neighbours, std::vector<std::uint8_t>& votes) {
  votes.assign(series.size(), 0);
  const std::span<const float> x = series.x();
  for (int j = 0; j < neighbours; ++j) {
    for (const int side : {-1, 1}) {
      const std::span<const float> other = series.x_later(side * (1 << j));
      for (std::size_t i = 0; i < x.size(); ++i) {
        votes[i] = static_cast<std::uint8_t>(votes[i] + (x[i] - other[i] > threshold_m ? 1 : 0));
      }
    }
  }
}

}  // namespace

void WaveformSteps::mark_z_steps(const BaseSeries& series, float threshold_m, const EnvelopePisteConfig& config) {
  for (const int side : {-1, 1}) {
    count_z_votes(series, threshold_m, config.z_neighbours, side, votes_);
    for (std::size_t i = 0; i < votes_.size(); ++i) {
      steps_[i] = static_cast<std::uint8_t>(steps_[i] | (votes_[i] > config.z_votes ? 1 : 0));
    }
  }
}

void WaveformSteps::mark_x_steps(const BaseSeries& series, float threshold_m, const EnvelopePisteConfig& config) {
  count_x_votes(series, threshold_m, config.x_neighbours, votes_);
  const std::span<const float> x = series.x();
  const std::span<const float> before = series.x_later(-1);
  const std::span<const float> after = series.x_later(1);
  for (std::size_t i = 0; i < votes_.size(); ++i) {
    const bool turns = x[i] >= before[i] && x[i] >= after[i];  // Inf of P eq. 7
    steps_[i] = static_cast<std::uint8_t>(steps_[i] | (turns && votes_[i] > config.x_votes ? 1 : 0));
  }
}

std::span<const std::uint8_t> WaveformSteps::find(const BaseSeries& series, double slope_rad,
                                                  const EnvelopePisteConfig& config) {
  steps_.assign(series.size(), 0);
  mark_z_steps(series, static_cast<float>(config.z_step_m / std::cos(slope_rad)), config);
  mark_x_steps(series, static_cast<float>(config.x_step_m * std::cos(slope_rad)), config);
  return steps_;
}

}  // namespace berm
