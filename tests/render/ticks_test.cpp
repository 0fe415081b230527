#include "ticks.hpp"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace berm {
namespace {

TEST(NiceStep, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(nice_step(100.0, 10), 10.0);
  EXPECT_DOUBLE_EQ(nice_step(100.0, 9), 20.0);
  EXPECT_DOUBLE_EQ(nice_step(100.0, 3), 50.0);
  EXPECT_DOUBLE_EQ(nice_step(100.0, 1), 100.0);
  EXPECT_DOUBLE_EQ(nice_step(0.07, 10), 0.01);
  EXPECT_DOUBLE_EQ(nice_step(9.0, 1), 10.0);
  EXPECT_DOUBLE_EQ(nice_step(3e7, 4), 1e7);
}

TEST(NiceStep, NeedsASpan) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  for (const double span : {0.0, -1.0, kInf, -kInf, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(nice_step(span, 5), 1.0) << span;
  }
  EXPECT_DOUBLE_EQ(nice_step(10.0, 0), 10.0);
}

TEST(Multiples, HoldBothEnds) {
  EXPECT_EQ(multiples(-10.0, 10.0, 10.0), (std::vector<double>{-10.0, 0.0, 10.0}));
  EXPECT_EQ(multiples(-9.9, 9.9, 10.0), (std::vector<double>{0.0}));
  EXPECT_EQ(multiples(0.1, 0.3, 0.1).size(), 3U) << "0.1 * 3 is a digit above 0.3";
  EXPECT_TRUE(multiples(1.0, 2.0, 10.0).empty());
  EXPECT_TRUE(multiples(2.0, 1.0, 0.1).empty());
}

TEST(Multiples, AreNeverWithoutEnd) {
  EXPECT_EQ(multiples(0.0, 1e9, 1e-3).size(), 1000U);
  EXPECT_TRUE(multiples(std::numeric_limits<double>::quiet_NaN(), 1.0, 0.1).empty());
}

TEST(NumberText, HasAsManyDecimalsAsTheStepNeeds) {
  EXPECT_EQ(number_text(20.0, 10.0), "20");
  EXPECT_EQ(number_text(2.5, 0.5), "2.5");
  EXPECT_EQ(number_text(-0.25, 0.05), "-0.25");
  EXPECT_EQ(number_text(-0.0, 1.0), "0");
  EXPECT_EQ(number_text(-1e-13, 0.1), "0.0");
  EXPECT_EQ(number_text(1e9, 1e9), "1000000000");
}

TEST(CountText, SeparatesThousands) {
  EXPECT_EQ(count_text(0), "0");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(1000), "1,000");
  EXPECT_EQ(count_text(124668), "124,668");
  EXPECT_EQ(count_text(1234567890), "1,234,567,890");
}

}  // namespace
}  // namespace berm
