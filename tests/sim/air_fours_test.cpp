#include <cmath>

#include <gtest/gtest.h>

#include "air/fours.hpp"

namespace berm::sim {
namespace {

TEST(DustFours, FadeIsTheExponential) {
  for (double x = 0.0; x < 38.9; x += 1e-3) {
    const auto at = static_cast<float>(x);
    const Four faded = fade({at, 0.5F * at, 0.1F * at, 0.0F});
    ASSERT_NEAR(static_cast<double>(faded[0]) / std::exp(-static_cast<double>(at)), 1.0, 3e-7) << x;
    ASSERT_NEAR(static_cast<double>(faded[1]) / std::exp(-static_cast<double>(0.5F * at)), 1.0, 3e-7) << x;
    ASSERT_NEAR(static_cast<double>(faded[2]) / std::exp(-static_cast<double>(0.1F * at)), 1.0, 3e-7) << x;
    ASSERT_EQ(faded[3], 1.0F);
  }
}

TEST(DustFours, FadeEndsAboveWhatAFloatHoldsInFull) {
  for (const float x : {39.0F, 100.0F, 1e12F, 1e30F}) {
    const float faded = fade(Four::Constant(x))[0];
    EXPECT_GT(faded, 1e-18F);
    EXPECT_LT(faded, 2e-17F);
  }
}

TEST(DustFours, ErrorFunctionIsThatOfTheLibrary) {
  for (double x = -7.0; x < 7.0; x += 1e-3) {
    const auto at = static_cast<float>(x);
    const Four found = error_function({at, -at, 0.5F * at, 0.1F * at});
    ASSERT_NEAR(static_cast<double>(found[0]), std::erf(static_cast<double>(at)), 5e-7) << x;
    ASSERT_EQ(found[0], -found[1]) << x;
    ASSERT_NEAR(static_cast<double>(found[2]), std::erf(static_cast<double>(0.5F * at)), 5e-7) << x;
    ASSERT_NEAR(static_cast<double>(found[3]), std::erf(static_cast<double>(0.1F * at)), 5e-7) << x;
  }
}

}  // namespace
}  // namespace berm::sim
