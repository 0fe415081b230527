#include "direction_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "band_count.hpp"

namespace berm {
namespace {

using Eigen::Vector3f;

std::vector<Vector3f> directions(std::size_t count, std::uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<float> normal;
  std::vector<Vector3f> all;
  while (all.size() < count) {
    const float x = normal(random);
    const float y = normal(random);
    all.push_back(Vector3f(x, y, normal(random)).normalized());
  }
  return all;
}

struct Located {
  std::vector<std::uint32_t> cell;
  std::vector<float> range_m;
};

Located locate(const DirectionCells& cells, const std::vector<Vector3f>& points) {
  PointChannels channels;
  for (const Vector3f& p : points) {
    channels.x.push_back(p.x());
    channels.y.push_back(p.y());
    channels.z.push_back(p.z());
  }
  const PointCloud cloud(std::move(channels));
  Located located{std::vector<std::uint32_t>(points.size()), std::vector<float>(points.size())};
  cells.locate(cloud.view(), located.cell, located.range_m);
  return located;
}

TEST(DirectionCells, AreAboutEquallyLarge) {
  const DirectionCells cells(4);
  std::vector<int> hits(cells.size());
  for (const std::uint32_t cell : locate(cells, directions(600000, 1)).cell) {
    ASSERT_LT(cell, cells.size());
    ++hits[cell];
  }
  const auto [least, most] = std::minmax_element(hits.begin(), hits.end());
  EXPECT_GT(*least, 200) << "390 on average";
  EXPECT_LT(*most, 600);
}

TEST(DirectionCells, DoNotDependOnTheRangeAndTellIt) {
  const DirectionCells cells(6);
  const std::vector<Vector3f> near = directions(2000, 2);
  std::vector<Vector3f> far = near;
  for (Vector3f& p : far) {
    p *= 64.0F;
  }
  const Located a = locate(cells, near);
  const Located b = locate(cells, far);
  EXPECT_EQ(a.cell, b.cell);
  for (std::size_t i = 0; i < near.size(); ++i) {
    EXPECT_NEAR(a.range_m[i], 1.0F, 1e-5F);
    EXPECT_NEAR(b.range_m[i], 64.0F, 1e-3F);
  }
}

TEST(DirectionCells, WhatIsNoPointIsNowhere) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kMax = std::numeric_limits<float>::max();
  const DirectionCells cells(6);
  const Located located = locate(cells, {{0, 0, 0},
                                         {-0.0F, 0, 0},
                                         {kNan, 1, 1},
                                         {1, kNan, 1},
                                         {1, 1, kNan},
                                         {kInf, 0, 0},
                                         {0, -kInf, kNan},
                                         {kMax, 1, 1},
                                         {1, 2e4F, 1}});
  for (std::size_t i = 0; i < located.cell.size(); ++i) {
    EXPECT_EQ(located.cell[i], cells.nowhere()) << i;
    EXPECT_EQ(located.range_m[i], 0.0F) << i;
  }
}

/// Whatever lies within half a cell of a point lies in the block around it.
TEST(DirectionCells, ABlockHoldsTheNeighbourhoodAlsoAcrossTheEdgesOfTheCube) {
  for (const int bits : {4, 5, 6, 8}) {
    const DirectionCells cells(bits);
    const float reach = 0.35F * 1.5708F / static_cast<float>(cells.side());
    const std::vector<Vector3f> points = directions(20000, 3);
    std::vector<Vector3f> moved = directions(20000, 4);
    for (std::size_t i = 0; i < points.size(); ++i) {
      moved[i] = (points[i] + reach * moved[i]).normalized();
    }
    const Located here = locate(cells, points);
    const Located there = locate(cells, moved);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto block = cells.block(here.cell[i]);
      ASSERT_EQ(block[4], here.cell[i]);
      ASSERT_NE(std::find(block.begin(), block.end(), there.cell[i]), block.end()) << bits << " bits, " << i;
      std::set<std::uint32_t> once(block.begin(), block.end());
      once.erase(cells.nowhere());
      ASSERT_GE(once.size(), 8U);
      if (cells.is_inner(here.cell[i])) {
        ASSERT_EQ(block[0] + 2, block[2]);
        ASSERT_EQ(block[3] + 2, block[5]);
        ASSERT_EQ(block[6] + 2, block[8]);
      }
    }
  }
}

std::uint32_t count_slowly(const std::vector<std::uint16_t>& values, std::uint32_t first, std::uint32_t count, int low,
                           int width) {
  return static_cast<std::uint32_t>(
      std::count_if(values.begin() + first, values.begin() + first + count,
                    [low, width](int value) { return value >= low && value <= low + width; }));
}

TEST(BandCount, AgreesWithTheSlowWay) {
  std::mt19937 random(5);
  std::vector<std::uint16_t> values(200000 + BandCount::kMargin);
  for (std::uint16_t& value : values) {
    value = static_cast<std::uint16_t>(random() % 2 == 0 ? random() : random() % 300);
  }
  for (const std::uint32_t count : {0U, 1U, 7U, 8U, 9U, 15U, 24U, 25U, 100U, 4120U, 4121U, 65528U, 65536U, 200000U}) {
    for (const auto& [low, width] : {std::pair{0, 65535}, {0, 0}, {100, 50}, {65535, 0}, {65000, 535}, {299, 1}}) {
      BandCount found(static_cast<std::uint16_t>(low), static_cast<std::uint16_t>(width));
      found.add(values.data(), count);
      EXPECT_EQ(found.total(), count_slowly(values, 0, count, low, width)) << count << " from " << low << ", " << width;
    }
  }
}

/// As many as cells around a point, and so long that lanes would overflow.
TEST(BandCount, AddsUpRuns) {
  const std::vector<std::uint16_t> values(20000 + BandCount::kMargin, 7);
  for (const std::uint32_t count : {3U, 20U, 500U, 4119U, 20000U}) {
    BandCount found(5, 2);
    for (int run = 0; run < 9; ++run) {
      found.add(values.data(), count);
    }
    EXPECT_EQ(found.total(), 9 * count);
  }
}

}  // namespace
}  // namespace berm
