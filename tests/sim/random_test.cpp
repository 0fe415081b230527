#include "berm/sim/random.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace berm::sim {
namespace {

TEST(Random, NamesASequenceBySeedPurposeAndIndices) {
  const auto first = [](std::uint64_t seed, Purpose purpose, std::uint64_t index, std::uint64_t subindex) {
    return Random(seed, purpose, index, subindex).bits();
  };
  const std::uint64_t here = first(1, Purpose::beam, 2, 3);
  EXPECT_EQ(here, first(1, Purpose::beam, 2, 3));
  EXPECT_NE(here, first(2, Purpose::beam, 2, 3));
  EXPECT_NE(here, first(1, Purpose::weather, 2, 3));
  EXPECT_NE(here, first(1, Purpose::beam, 3, 2));
  EXPECT_NE(here, first(1, Purpose::beam, 2, 4));
}

// Sequences of neighbouring beams must not follow each other: their first numbers are as good as one sequence's.
TEST(Random, FirstNumbersOfNeighbouringBeamsAreUniformAndNormal) {
  constexpr int kCount = 100'000;
  double sum = 0.0;
  double squares = 0.0;
  double products = 0.0;
  double before = 0.0;
  double normal_sum = 0.0;
  double normal_squares = 0.0;
  double exponential_sum = 0.0;
  for (int i = 0; i < kCount; ++i) {
    Random random(7, Purpose::beam, 0, static_cast<std::uint64_t>(i));
    const double u = random.uniform() - 0.5;
    sum += u;
    squares += u * u;
    products += u * before;
    before = u;
    const double n = random.normal();
    normal_sum += n;
    normal_squares += n * n;
    exponential_sum += random.exponential();
  }
  // Five standard errors each.
  const double root = std::sqrt(static_cast<double>(kCount));
  EXPECT_NEAR(sum / kCount, 0.0, 5.0 * std::sqrt(1.0 / 12.0) / root);
  EXPECT_NEAR(squares / kCount, 1.0 / 12.0, 5.0 * 0.075 / root);
  EXPECT_NEAR(products / kCount, 0.0, 5.0 / 12.0 / root);
  EXPECT_NEAR(normal_sum / kCount, 0.0, 5.0 / root);
  EXPECT_NEAR(normal_squares / kCount, 1.0, 5.0 * std::sqrt(2.0) / root);
  EXPECT_NEAR(exponential_sum / kCount, 1.0, 5.0 / root);
}

}  // namespace
}  // namespace berm::sim
