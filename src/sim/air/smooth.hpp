#pragma once

#include <bit>
#include <cstdint>

namespace berm::sim {

// Written for loops over many numbers: no branch, no call, hence the compiler computes eight at once. They have to be
// inlined for that, whatever it thinks of their length.

/// exp(-x) for x >= 0, to 2e-7 of its value; no less than 1e-17, since what is smaller than a float holds costs the
/// processor a hundred times the time. A power of two, and the series for the rest of at most half a power.
[[nodiscard, gnu::always_inline]] inline float fade(float x) {
  constexpr float kPerPower = 1.44269504F;
  // ln 2 in two parts: the first times a small whole number is exact.
  constexpr float kCoarse = 0.693359375F;
  constexpr float kFine = -2.12194440e-4F;
  const float bounded = x < 39.0F ? x : 39.0F;
  const auto powers = static_cast<std::int32_t>(bounded * kPerPower + 0.5F);
  const auto whole = static_cast<float>(powers);
  const float rest = (bounded - whole * kCoarse) - whole * kFine;
  // In pairs, which do not wait for each other.
  const float square = rest * rest;
  const float low = (1.0F - rest) + square * (1.0F / 2.0F - rest * (1.0F / 6.0F));
  const float high = (1.0F / 24.0F - rest * (1.0F / 120.0F)) + square * (1.0F / 720.0F);
  const float series = low + square * square * high;
  // The exponent of a float is in its bits from the 23rd on, 127 for 1.
  return series * std::bit_cast<float>((127 - powers) << 23);
}

/// Natural logarithm of a positive number that is no less than 1e-37, within 1e-7 and 1e-7 of it: that of the power of
/// two, and a polynomial about 1 for the rest (logf of Moshier's Cephes library).
[[nodiscard, gnu::always_inline]] inline float logarithm(float x) {
  constexpr std::int32_t kRootHalf = 0x3f3504f3;
  const auto bits = std::bit_cast<std::int32_t>(x);
  const std::int32_t power = (bits - kRootHalf) >> 23;
  const float y = std::bit_cast<float>(bits - (power << 23)) - 1.0F;
  const auto powers = static_cast<float>(power);
  const float z = y * y;
  const float series =
      ((((((((7.0376836292e-2F * y - 1.1514610310e-1F) * y + 1.1676998740e-1F) * y - 1.2420140846e-1F) * y +
           1.4249322787e-1F) *
              y -
          1.6668057665e-1F) *
             y +
         2.0000714765e-1F) *
            y -
        2.4999993993e-1F) *
           y +
       3.3333331174e-1F);
  const float rest = y * z * series - powers * 2.12194440e-4F - 0.5F * z;
  return (y + rest) + powers * 0.693359375F;
}

/// The error function, to 5e-7: a ratio of polynomials, as Eigen has it for floats.
[[nodiscard, gnu::always_inline]] inline float error_function(float x) {
  const float above = x > -4.0F ? x : -4.0F;
  const float bounded = above < 4.0F ? above : 4.0F;
  const float square = bounded * bounded;
  const float fourth = square * square;
  const float over =
      (-1.60960333262415e-02F + square * -2.95459980854025e-03F) +
      fourth * ((-7.34990630326855e-04F + square * -5.69250639462346e-05F) +
                fourth * ((-2.10102402082508e-06F + square * 2.77068142495902e-08F) + fourth * -2.72614225801306e-10F));
  const float under =
      (-1.42647390514189e-02F + square * -7.37332916720468e-03F) +
      fourth * ((-1.68282697438203e-03F + square * -2.13374055278905e-04F) + fourth * -1.45660718464996e-05F);
  return bounded * over / under;
}

}  // namespace berm::sim
