#pragma once

#include "berm/sim/random.hpp"

namespace berm::sim {

/// A random oscillation around one frequency, of standard deviation 1: what a sprung mass makes of uneven ground.
/// Second order, sampled evenly.
class Oscillation {
 public:
  /// `damping` is the share of the critical one; the smaller, the purer the tone.
  Oscillation(double frequency_hz, double damping, double step_s, const Random& random);

  /// The value at the next sample.
  [[nodiscard]] double next();

 private:
  Random random_;
  double previous_weight_;
  double second_weight_;
  double noise_;
  double value_ = 0.0;
  double previous_ = 0.0;
};

/// First-order Gauss-Markov process of standard deviation 1: wanders within its correlation time.
class Drift {
 public:
  Drift(double correlation_s, double step_s, const Random& random);

  [[nodiscard]] double next();

 private:
  Random random_;
  double kept_;
  double noise_;
  double value_;
};

}  // namespace berm::sim
