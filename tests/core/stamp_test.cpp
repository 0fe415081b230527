#include "berm/core/stamp.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace berm {
namespace {

TEST(Stamp, RoundsToTheNearestNanosecond) {
  EXPECT_EQ(from_seconds(0.0), 0);
  EXPECT_EQ(from_seconds(-0.0), 0);
  EXPECT_EQ(from_seconds(1.0), 1'000'000'000);
  EXPECT_EQ(from_seconds(0.1), 100'000'000);
  EXPECT_EQ(from_seconds(-0.1), -100'000'000);
  EXPECT_EQ(from_seconds(0.4e-9), 0);
  EXPECT_EQ(from_seconds(0.6e-9), 1);
  EXPECT_EQ(from_seconds(-0.6e-9), -1);
  EXPECT_EQ(from_seconds(1.5e-9), 2);
  EXPECT_EQ(from_seconds(-1.5e-9), -2);
  EXPECT_EQ(from_seconds(1635236489.25), 1'635'236'489'250'000'000);
}

TEST(Stamp, DoesNotRoundUpWhatIsJustBelowAHalf) {
  // The largest double below 0.5 plus 0.5 is 1 in doubles.
  const double nearly_half_s = std::nextafter(0.5e-9, 0.0);
  ASSERT_LT(nearly_half_s * kNanosecondsPerSecond, 0.5);
  EXPECT_EQ(from_seconds(nearly_half_s), 0);
  EXPECT_EQ(from_seconds(-nearly_half_s), 0);
}

TEST(Stamp, TakesBothEndsOfWhatItPromises) {
  EXPECT_EQ(from_seconds(9.2e9), 9'200'000'000'000'000'000);
  EXPECT_EQ(from_seconds(-9.2e9), -9'200'000'000'000'000'000);
}

TEST(Stamp, WorksAtCompileTime) {
  static_assert(from_seconds(0.25) == 250'000'000);
  static_assert(to_seconds(250'000'000) == 0.25);
}

TEST(Stamp, ComesBackFromSecondsWithinTheirPrecision) {
  EXPECT_TRUE(rc::check("below 2^51 ns (26 days) the way to seconds and back is exact", [] {
    const auto stamp_ns = *rc::gen::inRange<Stamp>(-(Stamp{1} << 51), Stamp{1} << 51);
    RC_ASSERT(from_seconds(to_seconds(stamp_ns)) == stamp_ns);
  }));
  EXPECT_TRUE(rc::check("beyond, it is off by no more than a step of the double", [] {
    const auto stamp_ns = *rc::gen::inRange<Stamp>(1'000'000'000'000'000'000, 2'000'000'000'000'000'000);
    RC_ASSERT(std::abs(from_seconds(to_seconds(stamp_ns)) - stamp_ns) <= 512);
  }));
}

}  // namespace
}  // namespace berm
