#include "waveform_steps.hpp"

#include <cmath>
#include <cstddef>

namespace berm {
namespace {

/// Adds 1 to the votes of every point for which `votes_for(own, other)`. A loop of its own, so that it is vectorised.
template <typename VotesFor>
void add_votes(std::span<const float> own, std::span<const float> other, std::span<std::uint8_t> votes,
               VotesFor votes_for) {
  for (std::size_t i = 0; i < own.size(); ++i) {
    votes[i] = static_cast<std::uint8_t>(votes[i] + (votes_for(own[i], other[i]) ? 1 : 0));
  }
}

/// D_z of P eq. 3 (`side` -1) or U_z of P eq. 4 (`side` +1): neighbours on that side whose height differs.
void count_z_votes(const BaseSeries& series, float threshold_m, int neighbours, std::ptrdiff_t side,
                   std::vector<std::uint8_t>& votes) {
  votes.assign(series.size(), 0);
  for (int k = 1; k <= neighbours; ++k) {
    add_votes(series.z(), series.z_later(side * k), votes,
              [threshold_m](float own, float other) { return std::abs(own - other) > threshold_m; });
  }
}

/// S_x of P eq. 6: neighbours on both sides that this point lies ahead of.
void count_x_votes(const BaseSeries& series, float threshold_m, int neighbours, std::vector<std::uint8_t>& votes) {
  votes.assign(series.size(), 0);
  for (int j = 0; j < neighbours; ++j) {
    for (const std::ptrdiff_t side : {-1, 1}) {
      add_votes(series.x(), series.x_later(side * (1 << j)), votes,
                [threshold_m](float own, float other) { return own - other > threshold_m; });
    }
  }
}

}  // namespace

void WaveformSteps::mark_z_steps(const BaseSeries& series, float threshold_m, const EnvelopePisteConfig& config) {
  const std::span<std::uint8_t> steps = steps_;
  for (const std::ptrdiff_t side : {-1, 1}) {
    count_z_votes(series, threshold_m, config.z_neighbours, side, votes_);
    const std::span<const std::uint8_t> votes = votes_;
    for (std::size_t i = 0; i < votes.size(); ++i) {
      steps[i] = votes[i] > config.z_votes ? 1 : steps[i];
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
    steps_[i] = turns && votes_[i] > config.x_votes ? 1 : steps_[i];
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
