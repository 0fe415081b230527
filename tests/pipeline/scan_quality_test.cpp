#include "scan_quality.hpp"

#include <algorithm>
#include <numeric>
#include <random>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "support/made_scan.hpp"

namespace berm {
namespace {

PointCloud seen(const test::Beams& beams) {
  const test::World world = test::made_street(5);
  return test::cast(world, beams, test::standing_at_origin(world, 1.8, 5.0)).cloud;
}

/// Takes the points in another order.
PointCloud reordered(const PointCloud& cloud, const std::vector<std::size_t>& order) {
  const PointsView view = cloud.view();
  PointChannels channels;
  for (const std::size_t i : order) {
    channels.x.push_back(view.x[i]);
    channels.y.push_back(view.y[i]);
    channels.z.push_back(view.z[i]);
  }
  return PointCloud(std::move(channels));
}

std::vector<std::size_t> shuffled(std::size_t n) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::shuffle(order.begin(), order.end(), std::mt19937(1));
  return order;
}

TEST(FiringOrder, IsSeenInEveryPattern) {
  EXPECT_TRUE(has_firing_order(seen(test::rosette_beams(70.4, 10000)).view()));
  EXPECT_TRUE(has_firing_order(seen(test::spinning_beams(16, -15.0, 15.0, 1800)).view()));
  EXPECT_TRUE(has_firing_order(seen(test::spinning_beams(64, -25.0, 5.0, 900)).view())) << "column by column";
}

TEST(FiringOrder, IsSeenInSensorsThatTakeTurns) {
  const PointCloud cloud = seen(test::rosette_beams(70.4, 12000));
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < 2000; ++i) {
    for (std::size_t line = 0; line < 6; ++line) {
      order.push_back(2000 * line + i);
    }
  }
  EXPECT_TRUE(has_firing_order(reordered(cloud, order).view()));
}

TEST(FiringOrder, IsMissedInShuffledScans) {
  for (const test::Beams& beams : {test::rosette_beams(70.4, 10000), test::spinning_beams(32, -25.0, 10.0, 900)}) {
    const PointCloud cloud = seen(beams);
    EXPECT_FALSE(has_firing_order(reordered(cloud, shuffled(cloud.size())).view()));
  }
}

TEST(FiringOrder, IsNotDoubtedWithoutEvidence) {
  EXPECT_TRUE(has_firing_order({}));
  const PointCloud cloud = seen(test::rosette_beams(70.4, 100));
  EXPECT_TRUE(has_firing_order(reordered(cloud, shuffled(cloud.size())).view()));
  PointChannels empty;
  empty.x.resize(5000);
  empty.y.resize(5000);
  empty.z.resize(5000);
  EXPECT_TRUE(has_firing_order(PointCloud(std::move(empty)).view())) << "nothing but no-returns";
}

TEST(LabelCounts, ByHand) {
  const std::vector<Label> labels = {Label::drivable,     Label::terrain,   Label::terrain,  Label::obstacle,
                                     Label::falling_snow, Label::no_return, Label::unlabeled};
  const LabelCounts counts = count_labels(labels);
  EXPECT_EQ(counts.drivable, 1U);
  EXPECT_EQ(counts.terrain, 2U);
  EXPECT_EQ(counts.obstacle, 1U);
  EXPECT_EQ(counts.falling_snow, 1U);
  EXPECT_EQ(counts.no_return, 1U);
  EXPECT_EQ(counts.invalid, 1U);
  EXPECT_EQ(counts.returns(), 5U);
  EXPECT_EQ(counts.points(), labels.size());
}

TEST(Degradations, AreASetWithNames) {
  Degradations degraded;
  EXPECT_TRUE(degraded.empty());
  EXPECT_EQ(degraded.text(), "");
  degraded.add(Degradation::mount_implausible);
  degraded.add(Degradation::no_time);
  degraded.add(Degradation::no_time);
  EXPECT_TRUE(degraded.has(Degradation::no_time));
  EXPECT_FALSE(degraded.has(Degradation::no_intensity));
  EXPECT_EQ(degraded.text(), "no_time+mount_implausible");
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kDegradations; ++i) {
    names.insert(to_string(static_cast<Degradation>(i)));
  }
  EXPECT_EQ(names.size(), kDegradations);
}

TEST(Degradations, SnowHidesTheSceneOnceItOutweighsTheRest) {
  const PointCloud cloud = seen(test::rosette_beams(70.4, 2000));
  ScanResult result;
  result.counts = {.drivable = 600, .obstacle = 300, .falling_snow = 900, .no_return = 200};
  EXPECT_FALSE(find_degradations(cloud.view(), {}, result).has(Degradation::snow_hides_the_scene));
  ++result.counts.falling_snow;
  EXPECT_TRUE(find_degradations(cloud.view(), {}, result).has(Degradation::snow_hides_the_scene));
}

TEST(Degradations, WithoutGroundOnlyIfThereIsEnoughToJudge) {
  const PointCloud cloud = seen(test::rosette_beams(70.4, 2000));
  ScanResult result;
  result.counts = {.obstacle = 1500, .no_return = 500};
  EXPECT_TRUE(find_degradations(cloud.view(), {}, result).has(Degradation::no_ground));
  result.counts = {.obstacle = 20, .no_return = 1980};
  const Degradations few = find_degradations(cloud.view(), {}, result);
  EXPECT_FALSE(few.has(Degradation::no_ground));
  EXPECT_TRUE(few.has(Degradation::few_returns));
}

}  // namespace
}  // namespace berm
