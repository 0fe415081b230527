#pragma once

#include <cmath>
#include <numbers>

#include "berm/sim/random.hpp"

namespace berm::sim {

struct NormalPair {
  float first;
  float second;
};

/// Two independent numbers of mean 0 and standard deviation 1 (Box and Muller), for the price of one.
inline NormalPair normal_pair(Random& random) {
  const auto share = static_cast<float>(1.0 - random.uniform());
  const auto turn = static_cast<float>(random.uniform());
  const float radius = std::sqrt(-2.0F * std::log(share));
  const float angle_rad = 2.0F * std::numbers::pi_v<float> * turn;
  return {radius * std::cos(angle_rad), radius * std::sin(angle_rad)};
}

}  // namespace berm::sim
