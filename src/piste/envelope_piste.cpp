#include "berm/piste/envelope_piste.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "base_series.hpp"
#include "berm/core/error.hpp"
#include "envelopes.hpp"
#include "petals.hpp"
#include "slope_fan.hpp"
#include "waveform_steps.hpp"

namespace berm {
namespace {

bool is_return(Label label) {
  return label == Label::drivable || label == Label::terrain || label == Label::obstacle;
}

void check_lengths(const PisteInput& input) {
  const std::size_t n = input.points.size();
  const SeriesView& series = input.series;
  if (input.labels.size() != n || series.x.size() != n || series.y.size() != n || series.z.size() != n ||
      series.interpolated.size() != n) {
    throw Error(ErrorCode::invalid_argument, "piste: points, labels and series must have one length");
  }
}

/// Returns are piste unless an envelope covers them.
void label_points(const PisteInput& input, std::span<const Envelope> envelopes, std::vector<Label>& labels) {
  const std::size_t n = input.labels.size();
  labels.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Label ground = input.series.interpolated[i] != 0 ? Label::unlabeled : Label::drivable;
    labels[i] = is_return(input.labels[i]) ? ground : input.labels[i];
  }
  for (const Envelope& envelope : envelopes) {
    for (std::size_t i = envelope.first; i <= envelope.last; ++i) {
      labels[i] = labels[i] == Label::drivable ? Label::obstacle : labels[i];
    }
  }
}

std::optional<double> nearest_obstacle_m(const BaseSeries& series, std::span<const Label> labels, double corridor_m) {
  const auto half_width_m = static_cast<float>(corridor_m / 2.0);
  std::optional<double> nearest_m;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const float x = series.x()[i];
    if (labels[i] == Label::obstacle && x > 0.0F && std::abs(series.y()[i]) <= half_width_m) {
      nearest_m = std::min(static_cast<double>(x), nearest_m.value_or(static_cast<double>(x)));
    }
  }
  return nearest_m;
}

}  // namespace

void EnvelopePisteConfig::check() const {
  check_fields(*this, "piste_reference");
  if (!(fan_min_m < fan_max_m)) {
    throw ConfigError("piste_reference.fan_min_m", "must lie below piste_reference.fan_max_m");
  }
}

struct EnvelopePiste::State {
  explicit State(const EnvelopePisteConfig& config)
      : fan(config), petals(config.petal_rise_deg * std::numbers::pi / 180.0) {}

  BaseSeries base;
  SlopeFan fan;
  WaveformSteps waveform;
  Petals petals;
  std::vector<Envelope> envelopes;
  std::vector<Label> labels;
};

EnvelopePiste::EnvelopePiste(const EnvelopePisteConfig& config) : config_(config) {
  config_.check();
  state_ = std::make_unique<State>(config_);
}

EnvelopePiste::~EnvelopePiste() = default;

PisteResult EnvelopePiste::process(const PisteInput& input) {
  check_lengths(input);
  State& s = *state_;
  s.base.assign(input.series, input.T_base_sensor);
  PisteResult result;
  result.slope = s.fan.measure(s.base, input.series.interpolated);
  result.steps = s.waveform.find(s.base, result.slope ? result.slope->slope_rad : 0.0, config_);
  find_envelopes(s.petals.find(input.series), result.steps, s.envelopes);
  result.envelopes = s.envelopes;
  label_points(input, s.envelopes, s.labels);
  result.labels = s.labels;
  result.obstacle_ahead_m = nearest_obstacle_m(s.base, s.labels, config_.corridor_m);
  return result;
}

}  // namespace berm
