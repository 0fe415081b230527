#include <cmath>

#include <gtest/gtest.h>

#include "air/smooth.hpp"

namespace berm::sim {
namespace {

TEST(AirSmooth, FadeIsTheExponential) {
  for (double x = 0.0; x < 38.9; x += 1e-3) {
    const auto at = static_cast<float>(x);
    ASSERT_NEAR(static_cast<double>(fade(at)) / std::exp(-static_cast<double>(at)), 1.0, 3e-7) << x;
  }
  EXPECT_EQ(fade(0.0F), 1.0F);
}

TEST(AirSmooth, FadeEndsAboveWhatAFloatHoldsInFull) {
  for (const float x : {39.0F, 100.0F, 1e12F, 1e30F}) {
    EXPECT_GT(fade(x), 1e-18F);
    EXPECT_LT(fade(x), 2e-17F);
  }
}

TEST(AirSmooth, ErrorFunctionIsThatOfTheLibrary) {
  for (double x = -7.0; x < 7.0; x += 2e-4) {
    const auto at = static_cast<float>(x);
    ASSERT_NEAR(static_cast<double>(error_function(at)), std::erf(static_cast<double>(at)), 5e-7) << x;
    ASSERT_EQ(error_function(at), -error_function(-at)) << x;
  }
}

TEST(AirSmooth, LogarithmIsThatOfTheLibrary) {
  for (double power = -120.0; power < 20.0; power += 1e-3) {
    const auto at = static_cast<float>(std::exp2(power));
    const double expected = std::log(static_cast<double>(at));
    ASSERT_NEAR(static_cast<double>(logarithm(at)), expected, 1e-7 + 1e-7 * std::abs(expected)) << at;
  }
  EXPECT_EQ(logarithm(1.0F), 0.0F);
}

}  // namespace
}  // namespace berm::sim
