#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/snow/sparse_snow.hpp"
#include "snow/snow_cases.hpp"

namespace berm {
namespace {

using test::SnowyScan;

/// Clear scans of small sensors; casting beams takes longer than everything else here.
const std::vector<test::MadeScan>& clear_scans() {
  static const std::vector<test::MadeScan> all = [] {
    const std::vector<test::Lookout> small = {{"64 rings", test::spinning_beams(64, -24.9, 2.0, 200), 1.73, 0.0},
                                              {"16 rings", test::spinning_beams(16, -15.0, 15.0, 600), 1.73, 0.0},
                                              {"rosette", test::rosette_beams(70.4, 6000), 2.3, 11.0}};
    std::vector<test::MadeScan> scans;
    for (const test::Lookout& lookout : small) {
      for (std::uint32_t street = 1; street <= 3; ++street) {
        scans.push_back(lookout.look(test::made_street(street), street));
      }
    }
    return scans;
  }();
  return all;
}

/// Any of the scans in snowfall that meets so many beams in a hundred, with intensity or without.
SnowyScan any_scan(int least_percent, int most_percent) {
  const auto& scans = clear_scans();
  const test::MadeScan& clear = scans[*rc::gen::inRange<std::size_t>(0, scans.size())];
  const double share = 0.01 * *rc::gen::inRange(least_percent, most_percent);
  SnowyScan scan = test::let_it_snow(clear, {.share = share}, *rc::gen::arbitrary<std::uint32_t>());
  if (*rc::gen::inRange(0, 4) == 0) {
    scan.channels.intensity.assign(scan.is_flake.size(), 0.0F);
  }
  return scan;
}

std::vector<std::uint8_t> marks_of(SparseSnow& snow, const SnowyScan& scan) {
  const SnowResult result = snow.process(scan.view(), {});
  return {result.falling.begin(), result.falling.end()};
}

TEST(SnowLaws, OrderOfPointsDoesNotMatter) {
  EXPECT_TRUE(rc::check("marks are permuted with the points", [] {
    const SnowyScan scan = any_scan(0, 60);
    std::vector<std::size_t> order(scan.is_flake.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    std::shuffle(order.begin(), order.end(), random);
    SparseSnow snow({});
    const auto expected = marks_of(snow, scan);
    const auto shuffled = marks_of(snow, test::picked(scan, order));
    for (std::size_t i = 0; i < order.size(); ++i) {
      RC_ASSERT(shuffled[i] == expected[order[i]]);
    }
  }));
}

TEST(SnowLaws, TurningTheSensorHardlyMatters) {
  EXPECT_TRUE(rc::check("marks stay under rotation", [] {
    const SnowyScan scan = any_scan(4, 30);
    const SnowyScan turned =
        test::turned(scan, *rc::gen::inRange(-180, 180), *rc::gen::inRange(-90, 90), *rc::gen::inRange(-180, 180));
    SparseSnow snow({});
    const auto a = marks_of(snow, scan);
    const auto b = marks_of(snow, turned);
    std::size_t differ = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      differ += a[i] != b[i] ? 1U : 0U;
    }
    const auto marks = static_cast<std::size_t>(std::count(a.begin(), a.end(), 1));
    // Cells cut the neighbourhood elsewhere, so that some flakes have one neighbour more or less.
    RC_ASSERT(differ <= a.size() / 500 + marks / 5);
  }));
}

TEST(SnowLaws, NothingIsRememberedOfTheScanBefore) {
  EXPECT_TRUE(rc::check("the same marks after any other scan", [] {
    const SnowyScan scan = any_scan(0, 60);
    const SnowyScan other = any_scan(0, 60);
    SparseSnow used({});
    SparseSnow fresh({});
    (void)used.process(other.view(), {});
    RC_ASSERT(marks_of(used, scan) == marks_of(fresh, scan));
  }));
}

TEST(SnowLaws, NoMarkIsOnANoReturn) {
  EXPECT_TRUE(rc::check("marks are on points and are counted", [] {
    const SnowyScan scan = any_scan(0, 60);
    SparseSnow snow({});
    RC_ASSERT(test::is_sound(snow.process(scan.view(), {}), scan.view()));
  }));
}

TEST(SnowLaws, ScansOfAnyDensityInAnyOrderLeaveNoTrace) {
  SparseSnow used({});
  std::vector<SnowyScan> scans;
  for (const int count : {500, 5000, 400000, 1000, 100000}) {
    const test::Lookout lookout{"rosette", test::rosette_beams(70.4, count), 2.3, 11.0};
    scans.push_back(test::let_it_snow(lookout.look(test::made_street(1)), {}, 1));
    scans.push_back(test::turned(scans.back(), 120.0, 80.0, 10.0));
  }
  for (int round = 0; round < 2; ++round) {
    for (const SnowyScan& scan : scans) {
      SparseSnow fresh({});
      EXPECT_EQ(marks_of(used, scan), marks_of(fresh, scan)) << scan.is_flake.size() << " points";
    }
  }
}

}  // namespace
}  // namespace berm
