#include "berm/geometry/traces.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/angle.hpp"
#include "piste/mid70_scan.hpp"
#include "support/made_scan.hpp"

namespace berm {
namespace {

constexpr double kHeight_m = 2.3;

/// A scan by a level sensor `kHeight_m` above the ground, what it is labelled, and its traces.
struct Traced {
  PointChannels points;
  std::vector<Label> labels;
  LevelPoints level;
  bearing_grid::SectorTable sectors;
  TraceFinder finder;

  void add(const Eigen::Vector3d& p, Label label = Label::drivable) {
    points.x.push_back(static_cast<float>(p.x()));
    points.y.push_back(static_cast<float>(p.y()));
    points.z.push_back(static_cast<float>(p.z()));
    labels.push_back(label);
  }
  void add_no_return() { add(Eigen::Vector3d::Zero(), Label::no_return); }
  /// Where a beam meets flat ground; no return above the horizon.
  void add_beam(const Eigen::Vector3d& direction) {
    if (direction.z() < -0.02) {
      add(-kHeight_m / direction.z() * direction);
    } else {
      add_no_return();
    }
  }

  const Traces& find() {
    const PointsView view{.x = points.x, .y = points.y, .z = points.z, .ring = points.ring};
    level.fill(view, Pose(Eigen::Quaterniond::Identity(), {0.0, 0.0, kHeight_m}));
    return finder.process(view, labels, level, sectors);
  }
};

Eigen::Vector3d direction(double azimuth_deg, double elevation_deg) {
  const double azimuth = azimuth_deg * kRadPerDeg;
  const double elevation = elevation_deg * kRadPerDeg;
  return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth), std::sin(elevation)};
}

Traced rosette() {
  Traced scan;
  const Eigen::Quaterniond nose_down(Eigen::AngleAxisd(11.0 * kRadPerDeg, Eigen::Vector3d::UnitY()));
  for (const Eigen::Vector3d& beam : test::mid70_beams().directions) {
    scan.add_beam(nose_down * beam);
  }
  return scan;
}

/// `lasers` fired one after the other, column by column, 2 degrees apart: neighbours of a column are none on a trace.
/// `without` of ten beams meet nothing.
Traced taking_turns(std::size_t lasers, unsigned without, bool with_rings = false) {
  Traced scan;
  std::mt19937 random(1);
  for (int column = 0; column < 600; ++column) {
    for (std::size_t laser = 0; laser < lasers; ++laser) {
      if (random() % 10 < without) {
        scan.add_no_return();
      } else {
        scan.add_beam(direction(-60.0 + 0.2 * column, -35.0 + 2.0 * static_cast<double>(laser)));
      }
      if (with_rings) {
        scan.points.ring.push_back(static_cast<std::uint16_t>(laser));
      }
    }
  }
  return scan;
}

template <typename Value>
void permute(std::vector<Value>& values, const std::vector<std::size_t>& order) {
  std::vector<Value> permuted;
  for (const std::size_t i : order) {
    permuted.push_back(values[i]);
  }
  values = std::move(permuted);
}

Traced shuffled(Traced scan, std::uint32_t seed = 1) {
  std::vector<std::size_t> order(scan.labels.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random(seed);
  std::shuffle(order.begin(), order.end(), random);
  permute(scan.points.x, order);
  permute(scan.points.y, order);
  permute(scan.points.z, order);
  permute(scan.labels, order);
  if (!scan.points.ring.empty()) {
    permute(scan.points.ring, order);
  }
  return scan;
}

std::size_t count_broken(const Traces& traces) {
  return static_cast<std::size_t>(std::count(traces.is_broken.begin(), traces.is_broken.end(), 1));
}

/// Every ground point once, with its own coordinates.
bool holds_the_ground_once(const Traced& scan, const Traces& traces) {
  std::vector<std::uint32_t> held = traces.index;
  std::sort(held.begin(), held.end());
  std::vector<std::uint32_t> ground;
  for (std::uint32_t i = 0; i < scan.labels.size(); ++i) {
    if (scan.labels[i] == Label::drivable) {
      ground.push_back(i);
    }
  }
  bool same = held == ground;
  for (std::size_t k = 0; same && k < traces.index.size(); ++k) {
    const std::size_t i = traces.index[k];
    same = traces.x[k] == scan.level.x[i] && traces.y[k] == scan.level.y[i] && traces.z[k] == scan.level.z[i];
  }
  return same && traces.range.size() == held.size() && traces.is_broken.size() == held.size() &&
         (held.empty() || traces.is_broken[0] == 1);
}

TEST(Traces, FollowTheFiringOrderOfARosette) {
  Traced scan = rosette();
  const Traces& traces = scan.find();
  EXPECT_EQ(traces.kind, TraceKind::firing);
  EXPECT_TRUE(std::is_sorted(traces.index.begin(), traces.index.end()));
  EXPECT_TRUE(holds_the_ground_once(scan, traces));
  EXPECT_GT(traces.index.size(), 5000U);
  // Petals leave the ground and come back: some 20 turns of it.
  EXPECT_LT(count_broken(traces), 100U);
  EXPECT_GT(count_broken(traces), 5U);
}

TEST(Traces, FollowTheFiringOrderAlsoAcrossBeamsWithoutReturn) {
  Traced scan = rosette();
  std::mt19937 random(2);
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    if (random() % 10 < 7) {
      scan.points.x[i] = scan.points.y[i] = scan.points.z[i] = 0.0F;
      scan.labels[i] = Label::no_return;
    }
  }
  const Traces& traces = scan.find();
  EXPECT_EQ(traces.kind, TraceKind::firing);
  EXPECT_TRUE(holds_the_ground_once(scan, traces));
}

class TracesOfLasersThatTakeTurns : public testing::TestWithParam<std::pair<std::size_t, unsigned>> {};

TEST_P(TracesOfLasersThatTakeTurns, AreThoseOfEachLaser) {
  const auto [lasers, without] = GetParam();
  Traced scan = taking_turns(lasers, without);
  const Traces& traces = scan.find();
  EXPECT_EQ(traces.kind, TraceKind::interleaved);
  EXPECT_TRUE(holds_the_ground_once(scan, traces));
  for (std::size_t k = 1; k < traces.index.size(); ++k) {
    const std::size_t laser = traces.index[k] % lasers;
    const std::size_t before = traces.index[k - 1] % lasers;
    ASSERT_LE(before, laser) << "one laser after the other";
    if (laser == before) {
      ASSERT_LT(traces.index[k - 1], traces.index[k]);
    } else {
      ASSERT_EQ(traces.is_broken[k], 1);
    }
  }
  EXPECT_LT(count_broken(traces), traces.index.size() / 20);
}

INSTANTIATE_TEST_SUITE_P(Counts, TracesOfLasersThatTakeTurns,
                         testing::Values(std::pair{2U, 0U}, std::pair{4U, 0U}, std::pair{6U, 0U}, std::pair{16U, 0U},
                                         std::pair{2U, 4U}, std::pair{4U, 4U}, std::pair{6U, 4U}, std::pair{16U, 4U}));

TEST(Traces, FollowTheRingsWhereThereAreAny) {
  Traced scan = taking_turns(16, 3, true);
  const Traces& traces = scan.find();
  EXPECT_EQ(traces.kind, TraceKind::rings);
  EXPECT_TRUE(holds_the_ground_once(scan, traces));
  for (std::size_t k = 1; k < traces.index.size(); ++k) {
    const std::uint16_t ring = scan.points.ring[traces.index[k]];
    const std::uint16_t before = scan.points.ring[traces.index[k - 1]];
    ASSERT_TRUE(before < ring || (before == ring && traces.index[k - 1] < traces.index[k]));
  }
  EXPECT_LT(count_broken(traces), traces.index.size() / 20);
}

/// The end of a full turn lies beside the beginning of the next ring.
TEST(Traces, BreakBetweenRingsThatLieCloseTogether) {
  Traced scan;
  for (int column = 0; column < 1800; ++column) {
    for (int ring = 0; ring < 32; ++ring) {
      scan.add_beam(direction(-180.0 + 0.2 * column, -25.0 + 0.4 * ring));
      scan.points.ring.push_back(static_cast<std::uint16_t>(ring));
    }
  }
  const Traces& traces = scan.find();
  ASSERT_EQ(traces.kind, TraceKind::rings);
  for (std::size_t k = 1; k < traces.index.size(); ++k) {
    if (scan.points.ring[traces.index[k]] != scan.points.ring[traces.index[k - 1]]) {
      ASSERT_EQ(traces.is_broken[k], 1) << "ring " << scan.points.ring[traces.index[k]];
    }
  }
}

TEST(Traces, TakeOneRingForNone) {
  Traced scan = rosette();
  scan.points.ring.assign(scan.labels.size(), 7);
  EXPECT_EQ(scan.find().kind, TraceKind::firing);
}

TEST(Traces, TakeTheLargestNumbersOfRings) {
  Traced scan = taking_turns(2, 0, true);
  for (std::uint16_t& ring : scan.points.ring) {
    ring = ring == 0 ? 17 : std::numeric_limits<std::uint16_t>::max();
  }
  const Traces& traces = scan.find();
  EXPECT_EQ(traces.kind, TraceKind::rings);
  EXPECT_TRUE(holds_the_ground_once(scan, traces));
}

TEST(Traces, GoOutwardWithinSectorsWhereThereIsNoOrder) {
  Traced scan = shuffled(rosette());
  const Traces& traces = scan.find();
  EXPECT_EQ(traces.kind, TraceKind::radial);
  EXPECT_TRUE(holds_the_ground_once(scan, traces));
  std::set<int> sectors;
  for (std::size_t k = 1; k < traces.index.size(); ++k) {
    const int sector = scan.sectors.of(traces.x[k], traces.y[k]);
    const int before = scan.sectors.of(traces.x[k - 1], traces.y[k - 1]);
    ASSERT_LE(before, sector);
    if (sector == before) {
      ASSERT_LE(scan.level.range2[traces.index[k - 1]], scan.level.range2[traces.index[k]]);
    } else {
      ASSERT_EQ(traces.is_broken[k], 1) << "sector " << sector;
    }
    sectors.insert(sector);
  }
  EXPECT_GT(sectors.size(), 30U);
}

/// Not in the order of the file, but around.
void expect_rings_around(Traced& scan, std::span<const std::uint16_t> rings) {
  const Traces& traces = scan.find();
  ASSERT_EQ(traces.kind, TraceKind::rings);
  EXPECT_TRUE(holds_the_ground_once(scan, traces));
  for (std::size_t k = 1; k < traces.index.size(); ++k) {
    if (traces.is_broken[k] == 0) {
      ASSERT_EQ(rings[traces.index[k]], rings[traces.index[k - 1]]);
    }
  }
  EXPECT_LT(count_broken(traces), traces.index.size() / 20);
}

TEST(Traces, GoAroundWhereTheRingsAreInNoOrder) {
  Traced scan = shuffled(taking_turns(16, 3, true));
  expect_rings_around(scan, scan.points.ring);
}

TEST(Traces, FindTheRingsByElevationWhereNothingTellsThem) {
  Traced scan = shuffled(taking_turns(16, 3, true));
  const std::vector<std::uint16_t> rings = std::exchange(scan.points.ring, {});
  expect_rings_around(scan, rings);
}

TEST(Traces, GoOutwardWhereTheRingsAreWrong) {
  Traced scan = shuffled(rosette());
  for (std::size_t i = 0; i < scan.labels.size(); ++i) {
    scan.points.ring.push_back(static_cast<std::uint16_t>(i % 16));
  }
  const Traces& traces = scan.find();
  EXPECT_EQ(traces.kind, TraceKind::radial);
  EXPECT_TRUE(holds_the_ground_once(scan, traces));
}

TEST(Traces, GoOutwardTheSameHoweverThePointsWereShuffled) {
  Traced first = shuffled(rosette(), 1);
  Traced second = shuffled(rosette(), 2);
  const Traces& a = first.find();
  const Traces& b = second.find();
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
  EXPECT_EQ(a.is_broken, b.is_broken);
}

/// Ground that `range_of_beam` puts at a range for each of 200 beams, 0.1 degrees apart.
template <typename RangeOfBeam>
Traced row_of_beams(RangeOfBeam range_of_beam, double gap_deg = 0.0) {
  Traced scan;
  for (int i = 0; i < 200; ++i) {
    const double range_m = range_of_beam(i);
    const double azimuth = (0.1 * i + (i >= 100 ? gap_deg : 0.0)) * kRadPerDeg;
    scan.add({range_m * std::cos(azimuth), range_m * std::sin(azimuth), -kHeight_m});
  }
  return scan;
}

TEST(Traces, DoNotBreakOnGroundThatGoesOn) {
  Traced level = row_of_beams([](int) { return 15.0; });
  EXPECT_EQ(count_broken(level.find()), 1U);
  Traced slanted = row_of_beams([](int i) { return 15.0 + 0.05 * i; });
  EXPECT_EQ(count_broken(slanted.find()), 1U);
}

TEST(Traces, BreakWhereTheRangeJumps) {
  for (const double jump_m : {-8.0, 8.0}) {
    Traced scan = row_of_beams([&](int i) { return i < 100 ? 15.0 : 15.0 + jump_m; });
    const Traces& traces = scan.find();
    EXPECT_EQ(traces.kind, TraceKind::firing);
    EXPECT_EQ(count_broken(traces), 2U) << jump_m;
    EXPECT_EQ(traces.is_broken[100], 1) << jump_m;
  }
}

/// The next beam passes just above a crest and meets the ground far behind it.
TEST(Traces, BreakBehindACrest) {
  Traced scan;
  for (int i = 0; i < 200; ++i) {
    scan.add((i < 100 ? 1.0 : 2.0) * 15.0 * direction(0.1 * i, -9.0));
  }
  const Traces& traces = scan.find();
  EXPECT_EQ(count_broken(traces), 2U);
  EXPECT_EQ(traces.is_broken[100], 1);
}

TEST(Traces, BreakWhereBeamsAreNoNeighbours) {
  Traced close = row_of_beams([](int) { return 15.0; }, 0.5);
  EXPECT_EQ(count_broken(close.find()), 1U);
  Traced apart = row_of_beams([](int) { return 15.0; }, 5.0);
  const Traces& traces = apart.find();
  EXPECT_EQ(count_broken(traces), 2U);
  EXPECT_EQ(traces.is_broken[100], 1);
}

TEST(Traces, MeasureTheirRangesFromTheSensor) {
  Traced scan = rosette();
  const Traces& traces = scan.find();
  for (std::size_t k = 0; k < traces.index.size(); ++k) {
    const std::size_t i = traces.index[k];
    const double range_m = Eigen::Vector3d(scan.points.x[i], scan.points.y[i], scan.points.z[i]).norm();
    ASSERT_NEAR(traces.range[k], range_m, 1e-4 * range_m);
  }
}

TEST(Traces, OfHardlyAnyPointsAreThosePoints) {
  for (const std::size_t count : {0U, 1U, 2U, 3U}) {
    for (const bool with_rings : {false, true}) {
      Traced scan;
      for (std::size_t i = 0; i < count; ++i) {
        scan.add_beam(direction(static_cast<double>(i), -10.0));
        if (with_rings) {
          scan.points.ring.push_back(static_cast<std::uint16_t>(i));
        }
      }
      const Traces& traces = scan.find();
      EXPECT_EQ(traces.index.size(), count);
      EXPECT_TRUE(holds_the_ground_once(scan, traces)) << count;
    }
  }
}

TEST(Traces, OfNothingButNoReturnsAreEmpty) {
  for (const bool with_rings : {false, true}) {
    Traced scan;
    for (int i = 0; i < 1000; ++i) {
      scan.add_no_return();
      if (with_rings) {
        scan.points.ring.push_back(static_cast<std::uint16_t>(i % 16));
      }
    }
    EXPECT_TRUE(scan.find().index.empty());
  }
}

/// Points that are no numbers are not ground, and hide no order.
TEST(Traces, PassOverWhatIsNotANumber) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  Traced scan = rosette();
  std::mt19937 random(3);
  for (std::size_t i = random() % 4; i < scan.labels.size(); i += 1 + random() % 4) {
    scan.points.x[i] = i % 2 == 0 ? kNan : kInf;
    scan.points.z[i] = kNan;
    scan.labels[i] = Label::unlabeled;
  }
  const Traces& traces = scan.find();
  EXPECT_EQ(traces.kind, TraceKind::firing);
  EXPECT_TRUE(holds_the_ground_once(scan, traces));
  for (std::size_t k = 0; k < traces.index.size(); ++k) {
    ASSERT_TRUE(std::isfinite(traces.range[k]));
  }
}

TEST(Traces, RememberNothing) {
  Traced small = taking_turns(4, 3);
  Traced large = rosette();
  (void)large.find();
  const PointsView view{.x = small.points.x, .y = small.points.y, .z = small.points.z};
  (void)small.find();
  const Traces& a = large.finder.process(view, small.labels, small.level, small.sectors);
  const Traces& b = small.find();
  EXPECT_EQ(a.kind, b.kind);
  EXPECT_EQ(a.index, b.index);
  EXPECT_EQ(a.range, b.range);
  EXPECT_EQ(a.is_broken, b.is_broken);
}

TEST(Traces, HoldEveryGroundPointOnceWhateverIsLabelledGround) {
  EXPECT_TRUE(rc::check([] {
    const int order = *rc::gen::inRange(0, 4);
    Traced scan = order == 0   ? rosette()
                  : order == 1 ? taking_turns(6, 2)
                  : order == 2 ? taking_turns(16, 2, true)
                               : shuffled(rosette());
    std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
    const auto share = *rc::gen::inRange(0U, 11U);
    for (Label& label : scan.labels) {
      label = random() % 10 < share ? Label::drivable : Label::obstacle;
    }
    RC_ASSERT(holds_the_ground_once(scan, scan.find()));
  }));
}

}  // namespace
}  // namespace berm
