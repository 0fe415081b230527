#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include <Eigen/Core>

namespace berm::sim {

/// Four numbers that the processor computes with at once.
using Four = Eigen::Array4f;
using Four3 = std::array<Four, 3>;

[[nodiscard]] inline Four dot(const Four3& a, const Four3& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// exp(-x) for x >= 0, to 2e-7 of its value; no less than 1e-17, since what is smaller than a float holds costs the
/// processor a hundred times the time. A power of two, and the series for the rest of at most half a power.
[[nodiscard]] inline Four fade(const Four& x) {
  using Whole = Eigen::Array4i;
  constexpr float kPerPower = 1.44269504F;
  // ln 2 in two parts: the first times a small whole number is exact.
  constexpr float kCoarse = 0.693359375F;
  constexpr float kFine = -2.12194440e-4F;
  const Four bounded = x.min(39.0F);
  const Whole powers = (bounded * kPerPower + 0.5F).cast<std::int32_t>();
  const Four whole = powers.cast<float>();
  const Four rest = (bounded - whole * kCoarse) - whole * kFine;
  const Four series =
      1.0F - rest * (1.0F - rest * (1.0F / 2.0F -
                                    rest * (1.0F / 6.0F -
                                            rest * (1.0F / 24.0F - rest * (1.0F / 120.0F - rest * (1.0F / 720.0F))))));
  // The exponent of a float is in its bits from the 23rd on, 127 for 1.
  const Whole bits = (127 - powers).shiftLeft<23>();
  Four scale;
  std::memcpy(scale.data(), bits.data(), sizeof(scale));
  return series * scale;
}

/// The error function, to 5e-7: a ratio of polynomials, as Eigen has it for floats.
[[nodiscard]] inline Four error_function(const Four& x) {
  const Four bounded = x.max(-4.0F).min(4.0F);
  const Four square = bounded * bounded;
  const Four over =
      ((((((square * -2.72614225801306e-10F + 2.77068142495902e-08F) * square - 2.10102402082508e-06F) * square -
          5.69250639462346e-05F) *
             square -
         7.34990630326855e-04F) *
            square -
        2.95459980854025e-03F) *
           square -
       1.60960333262415e-02F);
  const Four under =
      (((square * -1.45660718464996e-05F - 2.13374055278905e-04F) * square - 1.68282697438203e-03F) * square -
       7.37332916720468e-03F) *
          square -
      1.42647390514189e-02F;
  return bounded * over / under;
}

}  // namespace berm::sim
