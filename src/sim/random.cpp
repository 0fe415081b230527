#include "berm/sim/random.hpp"

#include <cmath>
#include <numbers>

namespace berm::sim {

double Random::normal() {
  // Box and Muller; 1 - u keeps the logarithm finite.
  const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
  return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

double Random::exponential() {
  return -std::log(1.0 - uniform());
}

}  // namespace berm::sim
