#include "berm/snow/repair.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"
#include "support/random_points.hpp"

namespace berm {
namespace {

constexpr float kNanRepaired = std::numeric_limits<float>::quiet_NaN();

struct Repaired {
  std::vector<float> x;
  std::vector<int> interpolated;
};

/// Along x; y is twice and z minus x, where x is a number.
Repaired repair(const std::vector<float>& x, const std::vector<std::uint8_t>& falling) {
  PointChannels channels{.x = x, .y = x, .z = x};
  for (std::size_t i = 0; i < x.size(); ++i) {
    channels.y[i] *= 2.0F;
    channels.z[i] *= -1.0F;
  }
  const PointCloud cloud(std::move(channels));
  SeriesRepair series;
  const SeriesView view = series.process(cloud.view(), falling);
  for (std::size_t i = 0; i < view.size(); ++i) {
    EXPECT_FLOAT_EQ(view.y[i], 2.0F * view.x[i]);
    EXPECT_FLOAT_EQ(view.z[i], -view.x[i]);
  }
  return {{view.x.begin(), view.x.end()}, {view.interpolated.begin(), view.interpolated.end()}};
}

TEST(SeriesRepair, PointsOfAGapAreEquallySpaced) {
  const Repaired r = repair({10, 1, 0, 1, 14, 15}, {0, 1, 0, 1, 0, 0});
  EXPECT_EQ(r.x, (std::vector<float>{10, 11, 12, 13, 14, 15}));
  EXPECT_EQ(r.interpolated, (std::vector<int>{0, 1, 1, 1, 0, 0}));
}

TEST(SeriesRepair, GapsAtTheEndsRepeatTheNeighbour) {
  const Repaired r = repair({0, 3, 5, 7, 2, kNanRepaired}, {0, 1, 0, 0, 1, 0});
  EXPECT_EQ(r.x, (std::vector<float>{5, 5, 5, 7, 7, 7}));
  EXPECT_EQ(r.interpolated, (std::vector<int>{1, 1, 0, 0, 1, 1}));
}

TEST(SeriesRepair, NanAndAbsurdPointsAreGaps) {
  const Repaired r =
      repair({1, kNanRepaired, 3, std::numeric_limits<float>::infinity(), 5, 1e9F, 7}, {0, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(r.x, (std::vector<float>{1, 2, 3, 4, 5, 6, 7}));
}

TEST(SeriesRepair, WithoutAPointToGoByThereAreZeros) {
  const Repaired r = repair({0, 4, kNanRepaired}, {0, 1, 0});
  EXPECT_EQ(r.x, (std::vector<float>{0, 0, 0}));
  EXPECT_EQ(r.interpolated, (std::vector<int>{1, 1, 1}));
  EXPECT_TRUE(repair({}, {}).x.empty());
}

TEST(SeriesRepair, NeedsOneMarkPerPoint) {
  const PointCloud cloud(PointChannels{.x = {1, 2}, .y = {0, 0}, .z = {0, 0}});
  SeriesRepair series;
  const std::vector<std::uint8_t> one = {0};
  EXPECT_THROW((void)series.process(cloud.view(), one), Error);
}

TEST(SeriesRepair, LeavesGoodPointsAndFillsTheRestBetweenThem) {
  EXPECT_TRUE(rc::check("good points stay, others lie between their neighbours", [] {
    const PointCloud cloud(
        test::random_points(*rc::gen::inRange<std::size_t>(0, 200), *rc::gen::arbitrary<std::uint32_t>(), {}));
    std::vector<std::uint8_t> falling;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      falling.push_back(static_cast<std::uint8_t>(*rc::gen::inRange(0, 2)));
    }
    SeriesRepair series;
    const SeriesView view = series.process(cloud.view(), falling);
    RC_ASSERT(view.size() == cloud.size());
    float last = 0.0F;
    for (std::size_t i = 0; i < view.size(); ++i) {
      RC_ASSERT(std::isfinite(view.x[i]) && std::isfinite(view.y[i]) && std::isfinite(view.z[i]));
      if (view.interpolated[i] == 0) {
        RC_ASSERT(view.x[i] == cloud.view().x[i] && falling[i] == 0);
        last = view.x[i];
        continue;
      }
      std::size_t next = i;
      while (next < view.size() && view.interpolated[next] != 0) {
        ++next;
      }
      if (next < view.size() && i > 0) {
        const float low = std::min(last, view.x[next]);
        const float high = std::max(last, view.x[next]);
        const bool at_start = std::all_of(view.interpolated.begin(), view.interpolated.begin() + static_cast<long>(i),
                                          [](std::uint8_t made) { return made != 0; });
        RC_ASSERT(at_start || (view.x[i] >= low - 1e-3F && view.x[i] <= high + 1e-3F));
      }
    }
  }));
}

}  // namespace
}  // namespace berm
