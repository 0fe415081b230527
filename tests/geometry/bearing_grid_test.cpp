#include "berm/geometry/bearing_grid.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace berm::bearing_grid {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSector_rad = 2.0 * kPi / kSectors;
constexpr int kTurns = 4 * kTurnsPerQuadrant;

TEST(BearingGridTurn, RisesWithTheBearingAllAround) {
  constexpr int kSteps = 100000;
  for (const double range_m : {1e-3, 1.0, 37.0, 1e6}) {
    int last = 0;
    for (int i = 1; i < kSteps; ++i) {
      const double bearing_rad = -kPi + 2.0 * kPi * i / kSteps;
      const int turn = turn_of(static_cast<float>(range_m * std::cos(bearing_rad)),
                               static_cast<float>(range_m * std::sin(bearing_rad)));
      ASSERT_GE(turn, last) << "bearing " << bearing_rad;
      ASSERT_LE(turn, last + 1) << "bearing " << bearing_rad;
      last = turn;
    }
    EXPECT_EQ(last, kTurns - 1);
  }
}

TEST(BearingGridTurn, BeginsAndEndsStraightBehind) {
  EXPECT_EQ(turn_of(-1.0F, -0.0F), 0);
  EXPECT_EQ(turn_of(-1.0F, 0.0F), kTurns - 1);
  EXPECT_EQ(turn_of(0.0F, -1.0F), kTurns / 4);
  EXPECT_EQ(turn_of(1.0F, 0.0F), kTurns / 2);
  EXPECT_EQ(turn_of(0.0F, 1.0F), 3 * kTurns / 4);
}

TEST(BearingGridTurn, IsInItsTableForEveryPairOfFloats) {
  using Limits = std::numeric_limits<float>;
  const std::vector<float> odd = {0.0F,
                                  -0.0F,
                                  1.0F,
                                  -1.0F,
                                  Limits::denorm_min(),
                                  -Limits::denorm_min(),
                                  Limits::max(),
                                  Limits::lowest(),
                                  Limits::infinity(),
                                  -Limits::infinity(),
                                  Limits::quiet_NaN(),
                                  -Limits::quiet_NaN()};
  const SectorTable sectors;
  for (const float x : odd) {
    for (const float y : odd) {
      ASSERT_LT(turn_of(x, y), kTurns) << x << ", " << y;
      ASSERT_LT(sectors.of(x, y), kSectors) << x << ", " << y;
    }
  }
}

TEST(BearingGridSector, IsRightToATwentieth) {
  const SectorTable sectors;
  EXPECT_TRUE(rc::check("a bearing lies in its sector, widened by a twentieth on both sides", [&] {
    const double bearing_rad = *rc::gen::inRange(-3141592, 3141593) * 1e-6;
    const double range_m = std::pow(10.0, *rc::gen::inRange(-20, 31) * 0.1);
    const int sector = sectors.of(static_cast<float>(range_m * std::cos(bearing_rad)),
                                  static_cast<float>(range_m * std::sin(bearing_rad)));
    RC_ASSERT(std::abs(bearing_rad - double{bearing_of(sector)}) < 0.55 * kSector_rad);
  }));
}

TEST(BearingGridSector, HoldsTheMiddleThatItSays) {
  const SectorTable sectors;
  for (int sector = 0; sector < kSectors; ++sector) {
    EXPECT_EQ(sectors.of(std::cos(bearing_of(sector)), std::sin(bearing_of(sector))), sector);
    EXPECT_NEAR(bearing_of(sector), -kPi + (sector + 0.5) * kSector_rad, 1e-6);
  }
}

/// Straight ahead is a border: no bearing is nearer to one side of the machine than to the other.
TEST(BearingGridSector, IsThatOfTheMirrorImageMirrored) {
  const SectorTable sectors;
  EXPECT_TRUE(rc::check([&] {
    const float x = static_cast<float>(*rc::gen::inRange(-100000, 100001)) * 1e-3F;
    const float y = static_cast<float>(*rc::gen::inRange(1, 100001)) * 1e-3F;
    RC_PRE(turn_of(x, y) + turn_of(x, -y) == kTurns - 1);  // else on a border
    RC_ASSERT(sectors.of(x, y) + sectors.of(x, -y) == kSectors - 1);
  }));
}

TEST(BearingGridBin, IsTheInverseOfItsRange) {
  for (int bin = 0; bin < kBins; ++bin) {
    const float inside_m = range_of(bin) * 1.0005F;
    EXPECT_EQ(bin_of(inside_m * inside_m), bin);
    const float last_m = range_of(bin + 1) * 0.9995F;
    EXPECT_EQ(bin_of(last_m * last_m), bin);
  }
}

TEST(BearingGridBin, IsAsLongAsASectorIsWideOrNearlySo) {
  for (int bin = 0; bin < kBins; ++bin) {
    const double length = double{range_of(bin + 1)} / double{range_of(bin)} - 1.0;
    EXPECT_GT(length, 0.9 * kSector_rad);
    EXPECT_LT(length, 1.3 * kSector_rad);
  }
}

TEST(BearingGridBin, TakesEveryFloatAndRisesWithIt) {
  using Limits = std::numeric_limits<float>;
  EXPECT_EQ(bin_of(0.0F), 0);
  EXPECT_EQ(bin_of(Limits::denorm_min()), 0);
  EXPECT_EQ(bin_of(kFirstRange_m * kFirstRange_m * 0.99F), 0);
  EXPECT_EQ(bin_of(1e6F), kBins - 1);
  EXPECT_EQ(bin_of(Limits::max()), kBins - 1);
  EXPECT_EQ(bin_of(Limits::infinity()), kBins - 1);
  EXPECT_EQ(bin_of(Limits::quiet_NaN()), 0);
}

using Seen = std::vector<std::uint8_t>;

/// Length of the longest cyclic run of zeros, the plain way.
int widest_gap(const Seen& seen) {
  int widest = 0;
  for (int first = 0; first < kSectors; ++first) {
    int length = 0;
    while (length < kSectors && seen[static_cast<std::size_t>((first + length) % kSectors)] == 0) {
      ++length;
    }
    widest = std::max(widest, length);
  }
  return widest;
}

/// Sectors that are seen in runs, as by sensors with one field of view or several.
rc::Gen<Seen> any_seen() {
  return rc::gen::map(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, kSectors)),
                      [](std::vector<int> borders) {
                        Seen seen(kSectors, 0);
                        for (std::size_t i = 0; i + 1 < borders.size(); i += 2) {
                          for (int k = 0; k < borders[i + 1] / 4 + 1; ++k) {
                            seen[static_cast<std::size_t>((borders[i] + k) % kSectors)] = 1;
                          }
                        }
                        return seen;
                      });
}

TEST(BearingGridArc, HoldsWhatIsSeenAndLeavesTheWidestGapOut) {
  EXPECT_TRUE(rc::check([] {
    const Seen seen = *any_seen();
    const Arc arc = find_arc(seen);
    RC_ASSERT(arc.count == kSectors - widest_gap(seen));
    RC_ASSERT(arc.first >= 0 && arc.first < kSectors);
    Seen left = seen;
    for (int i = 0; i < arc.count; ++i) {
      left[arc.sector(i)] = 0;
    }
    RC_ASSERT(std::count(left.begin(), left.end(), 1) == 0);
    if (arc.count > 0 && arc.count < kSectors) {
      RC_ASSERT(seen[arc.sector(0)] == 1);
      RC_ASSERT(seen[arc.sector(arc.count - 1)] == 1);
    }
  }));
}

TEST(BearingGridArc, MayCrossStraightBehind) {
  Seen seen(kSectors, 0);
  std::fill(seen.begin(), seen.begin() + 10, std::uint8_t{1});
  std::fill(seen.end() - 20, seen.end(), std::uint8_t{1});
  const Arc arc = find_arc(seen);
  EXPECT_EQ(arc.first, kSectors - 20);
  EXPECT_EQ(arc.count, 30);
  EXPECT_EQ(arc.sector(0), std::size_t{kSectors - 20});
  EXPECT_EQ(arc.sector(20), 0U);
  EXPECT_EQ(arc.sector(29), 9U);
}

TEST(BearingGridArc, OfAllSectorsBeginsStraightBehind) {
  const Arc arc = find_arc(Seen(kSectors, 1));
  EXPECT_EQ(arc.first, 0);
  EXPECT_EQ(arc.count, kSectors);
}

TEST(BearingGridArc, OfNoneIsEmpty) {
  EXPECT_EQ(find_arc(Seen(kSectors, 0)).count, 0);
}

TEST(BearingGridArc, OfOneSectorIsThatSector) {
  for (const int sector : {0, 1, 90, kSectors - 1}) {
    Seen seen(kSectors, 0);
    seen[static_cast<std::size_t>(sector)] = 1;
    EXPECT_EQ(find_arc(seen).first, sector);
    EXPECT_EQ(find_arc(seen).count, 1);
  }
}

}  // namespace
}  // namespace berm::bearing_grid
