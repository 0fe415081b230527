#include "motion_noise.hpp"

#include <cmath>
#include <numbers>

namespace berm::sim {
namespace {

/// Time constants after which an oscillation has forgotten that it began at rest.
constexpr double kSettledAfter = 8.0;

}  // namespace

Oscillation::Oscillation(double frequency_hz, double damping, double step_s, const Random& random) : random_(random) {
  const double omega = 2.0 * std::numbers::pi * frequency_hz;
  const double radius = std::exp(-damping * omega * step_s);
  const double angle = omega * std::sqrt(1.0 - damping * damping) * step_s;
  previous_weight_ = 2.0 * radius * std::cos(angle);
  second_weight_ = -radius * radius;
  // Variance of an autoregressive process of second order (Box, Jenkins: Time Series Analysis, 3.2.4), made 1.
  const double rest = 1.0 - second_weight_;
  noise_ = std::sqrt((1.0 + second_weight_) * (rest * rest - previous_weight_ * previous_weight_) / rest);
  const auto steps = static_cast<int>(kSettledAfter / (damping * omega * step_s));
  for (int i = 0; i < steps; ++i) {
    static_cast<void>(next());
  }
}

double Oscillation::next() {
  const double value = previous_weight_ * value_ + second_weight_ * previous_ + noise_ * random_.normal();
  previous_ = value_;
  value_ = value;
  return value;
}

Drift::Drift(double correlation_s, double step_s, const Random& random)
    : random_(random), kept_(std::exp(-step_s / correlation_s)), noise_(std::sqrt(1.0 - kept_ * kept_)) {
  value_ = random_.normal();
}

double Drift::next() {
  const double value = value_;
  value_ = kept_ * value_ + noise_ * random_.normal();
  return value;
}

}  // namespace berm::sim
