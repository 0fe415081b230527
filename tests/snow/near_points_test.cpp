#include "near_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "snow/snow_cases.hpp"

namespace berm {
namespace {

struct Expected {
  std::uint32_t all = 0;
  std::uint32_t like = 0;
};

/// The slow way: every point against every other.
Expected count_slowly(const DirectionCells& directions, const std::vector<std::uint32_t>& cells,
                      const std::vector<float>& ranges_m, std::size_t point, float tolerance_m, float max_range_m) {
  Expected expected;
  const std::array<std::uint32_t, 9> block = directions.block(cells[point]);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const bool around = std::find(block.begin(), block.end(), cells[k]) != block.end();
    if (k == point || ranges_m[k] == 0.0F || !around) {
      continue;
    }
    ++expected.all;
    expected.like += ranges_m[k] < max_range_m && std::fabs(ranges_m[k] - ranges_m[point]) <= tolerance_m ? 1U : 0U;
  }
  return expected;
}

TEST(NearPoints, CountsNeighboursAsTheSlowWayDoes) {
  constexpr float kMaxRange_m = 15.0F;
  NearPoints near;
  for (const test::Lookout& lookout : test::lookouts()) {
    const auto scan = test::let_it_snow(lookout.look(test::made_street(2)), {.share = 0.1}, 3);
    near.build(scan.view(), kMaxRange_m);
    ASSERT_GT(near.size(), 1000U);
    const DirectionCells cells(DirectionCells::kUsualBits);
    std::vector<std::uint32_t> cell(scan.is_flake.size());
    std::vector<float> range_m(scan.is_flake.size());
    cells.locate(scan.view(), cell, range_m);
    for (std::size_t i = 0; i < near.size(); i += 97) {
      const float tolerance_m = 0.05F * near.range_m(i);
      const NearPoints::Around around = near.count_around(i, tolerance_m);
      const Expected expected = count_slowly(cells, cell, range_m, near.index(i), tolerance_m, kMaxRange_m);
      ASSERT_EQ(around.all, expected.all) << lookout.name << ", " << i;
      // Ranges are kept in steps of a quarter of a millimetre.
      EXPECT_NEAR(around.like, expected.like, 2.0) << lookout.name << ", " << i;
    }
  }
}

TEST(NearPoints, CellsGrowAndShrinkWithTheDensity) {
  NearPoints near;
  for (const int count : {300, 3000, 30000, 300000}) {
    const test::Lookout lookout{"rosette", test::rosette_beams(70.4, count), 2.3, 11.0};
    const auto scan = test::let_it_snow(lookout.look(test::made_street(2)), {}, 4);
    near.build(scan.view(), 15.0F);
    ASSERT_GT(near.size(), 10U);
    double all = 0.0;
    for (std::size_t i = 0; i < near.size(); ++i) {
      all += near.count_around(i, 0.1F).all;
    }
    const double mean = all / static_cast<double>(near.size());
    EXPECT_GT(mean, 10.0) << count;
    EXPECT_LT(mean, 1000.0) << count;
    EXPECT_GT(near.sectors_seen(), 2.0);
    EXPECT_LE(near.sectors_seen(), 16.0) << "a view of 70 degrees lies on one face";
  }
}

}  // namespace
}  // namespace berm
