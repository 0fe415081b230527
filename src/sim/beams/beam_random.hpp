#pragma once

#include <cmath>
#include <cstdint>

#include "air/smooth.hpp"
#include "berm/sim/random.hpp"

namespace berm::sim {

// What follows is written for loops over many numbers, which have to inline it: no branch, no call.

/// cos(2 pi x) for |x| <= 1/2 within 2e-7: the series of the cosine about a quarter of a turn, where it is odd.
[[gnu::always_inline]] inline float cos_turn(float x) {
  const float y = 0.25F - std::abs(x);  // cos(2 pi x) = sin(2 pi y), |y| <= 1/4
  const float z = y * y;
  return y * (6.2831853F +
              z * (-41.341702F +
                   z * (81.605249F + z * (-76.705860F + z * (42.058694F + z * (-15.094643F + z * 3.8199526F))))));
}

/// sin(2 pi x) for |x| <= 1/2, likewise.
[[gnu::always_inline]] inline float sin_turn(float x) {
  return cos_turn(x > -0.25F ? x - 0.25F : x + 0.75F);
}

/// Nearest whole number; for |x| < 2^31. std::round is a call of the library unless built for newer processors.
template <typename Real>
[[gnu::always_inline]] inline Real rounded(Real x) {
  constexpr auto kHalf = static_cast<Real>(0.5);
  return static_cast<Real>(static_cast<std::int32_t>(x + (x < 0 ? -kHalf : kHalf)));
}

/// What `normal_pair` makes of two uniform numbers.
struct UniformPair {
  float share;  ///< in (0, 1]
  float turn;   ///< in [-1/2, 1/2)
};

inline UniformPair uniform_pair(Random& random) {
  const auto share = static_cast<float>(1.0 - random.uniform());
  return {share, static_cast<float>(random.uniform() - 0.5)};
}

struct NormalPair {
  float first;
  float second;
};

/// Two independent numbers of mean 0 and standard deviation 1 (Box and Muller), for the price of one.
[[gnu::always_inline]] inline NormalPair normal_pair(UniformPair uniform) {
  const float radius = std::sqrt(-2.0F * logarithm(uniform.share));
  return {radius * cos_turn(uniform.turn), radius * sin_turn(uniform.turn)};
}

}  // namespace berm::sim
