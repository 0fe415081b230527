#include "feature/feature_finder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

namespace berm {
namespace {

/// Points in firing order with one label each.
struct Series {
  PointChannels channels;
  std::vector<Label> labels;

  void add(double x_m, double y_m, double z_m, Label label) {
    channels.x.push_back(static_cast<float>(x_m));
    channels.y.push_back(static_cast<float>(y_m));
    channels.z.push_back(static_cast<float>(z_m));
    channels.time.push_back(1e-5F * static_cast<float>(labels.size()));
    labels.push_back(label);
  }
  [[nodiscard]] OdometryInput input() const {
    return {.points = {.x = channels.x, .y = channels.y, .z = channels.z, .time = channels.time, .ring = channels.ring},
            .labels = labels};
  }
};

/// A wall across the view, at a distance.
Series wall(double distance_m, Label label, int count = 20) {
  Series series;
  for (int i = 0; i < count; ++i) {
    series.add(distance_m, 0.1 * (i - 0.5 * count), 0.0, label);
  }
  return series;
}

/// A post 5 m away before a wall at 20 m: the post's points are numbers 8, 9 and 10.
Series post(Label label) {
  Series series = wall(20.0, label, 8);
  for (const double y_m : {0.0, 0.02, 0.04}) {
    series.add(5.0, y_m, 0.0, label);
  }
  for (int i = 0; i < 8; ++i) {
    series.add(20.0, 1.0 + 0.1 * i, 0.0, label);
  }
  return series;
}

std::vector<Feature> find(const Series& series, const FeatureOdometryConfig& config = {}) {
  return FeatureFinder().process(series.input(), config);
}

std::size_t count(const std::vector<Feature>& features, FeatureClass kind) {
  return static_cast<std::size_t>(
      std::count_if(features.begin(), features.end(), [kind](const Feature& f) { return f.kind == kind; }));
}

TEST(Curvature, AgreesWithAHandCalculation) {
  const std::vector<Eigen::Vector3d> straight = {{10, -2, 0}, {10, -1, 0}, {10, 0, 0}, {10, 1, 0}, {10, 2, 0}};
  EXPECT_EQ(curvature_of(straight), 0.0);
  // The differences are (-1, 2, 0), (-1, 1, 0), (-1, -1, 0) and (-1, -2, 0): their sum is 4 m long.
  const std::vector<Eigen::Vector3d> dent = {{10, -2, 0}, {10, -1, 0}, {9, 0, 0}, {10, 1, 0}, {10, 2, 0}};
  EXPECT_NEAR(curvature_of(dent), 4.0 / (4.0 * 9.0), 1e-12);
  // (0, 1, 0) and (0, 0, -1): a corner, root of 2 over 2 neighbours and 5 m.
  const std::vector<Eigen::Vector3d> corner = {{3, 3, 0}, {3, 4, 0}, {3, 4, 1}};
  EXPECT_NEAR(curvature_of(corner), std::sqrt(2.0) / (2.0 * 5.0), 1e-12);
}

TEST(FeatureFinder, ClassesFollowTheLabels) {
  EXPECT_EQ(count(find(wall(10.0, Label::drivable)), FeatureClass::piste_plane), 16U);
  EXPECT_EQ(count(find(wall(10.0, Label::terrain)), FeatureClass::obstacle_plane), 16U);
  EXPECT_EQ(count(find(wall(10.0, Label::obstacle)), FeatureClass::obstacle_plane), 16U);
  const FeatureOdometryConfig one{.variant = "one_class"};
  EXPECT_EQ(count(find(wall(10.0, Label::drivable), one), FeatureClass::obstacle_plane), 16U);
  for (const Label label : {Label::falling_snow, Label::no_return, Label::unlabeled}) {
    EXPECT_TRUE(find(wall(10.0, label)).empty());
  }
}

TEST(FeatureFinder, AnEdgeIsTheNearSideOfAStep) {
  const auto features = find(post(Label::obstacle));
  ASSERT_GT(count(features, FeatureClass::obstacle_edge), 0U);
  for (const Feature& feature : features) {
    if (is_edge(feature.kind)) {
      EXPECT_NEAR(feature.base_m.x(), 5.0, 1e-6);
      EXPECT_GT(feature.curvature, 0.1);
    }
  }
  EXPECT_EQ(count(find(post(Label::drivable)), FeatureClass::piste_edge), count(features, FeatureClass::obstacle_edge));
}

TEST(FeatureFinder, ALonePointIsNoEdge) {
  Series series = wall(20.0, Label::obstacle, 8);
  series.add(5.0, 0.0, 0.0, Label::obstacle);
  for (int i = 0; i < 8; ++i) {
    series.add(20.0, 1.0 + 0.1 * i, 0.0, Label::obstacle);
  }
  EXPECT_EQ(count(find(series), FeatureClass::obstacle_edge), 0U);
}

TEST(FeatureFinder, NothingBesideAFlakeOrABeamWithoutReturn) {
  for (const Label label : {Label::falling_snow, Label::no_return}) {
    Series series = wall(10.0, Label::drivable);
    series.labels[10] = label;
    const auto features = find(series);
    EXPECT_EQ(features.size(), 11U);
    for (const Feature& feature : features) {
      EXPECT_GT(std::abs(std::lround(feature.time_s / 1e-5) - 10), 2);
    }
  }
}

TEST(FeatureFinder, NothingThatTheBeamGrazes) {
  Series series;
  for (int i = 0; i < 20; ++i) {
    series.add(20.0 + i, 0.0, -1.0, Label::drivable);
  }
  EXPECT_TRUE(find(series).empty());
  EXPECT_EQ(find(series, {.min_view_angle_deg = 1.0}).size(), 16U);
}

TEST(FeatureFinder, EveryLaserIsASeriesOfItsOwn) {
  Series series;
  for (int i = 0; i < 20; ++i) {
    // Two lasers take turns: together they zigzag by 4 m, each alone sees a straight wall.
    series.add(i % 2 == 0 ? 10.0 : 14.0, 0.1 * std::floor(0.5 * i), 0.0, Label::obstacle);
    series.channels.ring.push_back(static_cast<std::uint16_t>(i % 2));
  }
  EXPECT_EQ(count(find(series), FeatureClass::obstacle_plane), 12U);
  series.channels.ring.clear();
  EXPECT_EQ(count(find(series), FeatureClass::obstacle_plane), 0U);
}

TEST(FeatureFinder, TheCapLeavesThePistePlanesOfTheSmallestCurvature) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise_m(0.0, 0.01);
  Series series;
  for (int i = 0; i < 400; ++i) {
    series.add(10.0 + noise_m(random), 0.1 * (i - 200), 0.0, i % 40 < 30 ? Label::drivable : Label::obstacle);
  }
  const auto all = find(series, {.variant = "four_classes"});
  const auto capped = find(series, {.max_piste_planes = 50});
  EXPECT_EQ(count(capped, FeatureClass::piste_plane), 50U);
  EXPECT_EQ(count(capped, FeatureClass::obstacle_plane), count(all, FeatureClass::obstacle_plane));
  std::vector<double> curvatures;
  for (const Feature& feature : all) {
    if (feature.kind == FeatureClass::piste_plane) {
      curvatures.push_back(feature.curvature);
    }
  }
  ASSERT_GT(curvatures.size(), 200U);
  std::sort(curvatures.begin(), curvatures.end());
  for (const Feature& feature : capped) {
    if (feature.kind == FeatureClass::piste_plane) {
      EXPECT_LE(feature.curvature, curvatures[49]);
    }
  }
}

TEST(FeatureFinder, EqualCurvaturesAreCappedAllTheSame) {
  EXPECT_EQ(find(wall(10.0, Label::drivable, 100), {.max_piste_planes = 10}).size(), 10U);
}

TEST(FeatureFinder, LivesOnWhatIsNoNumber) {
  Series series = wall(10.0, Label::drivable);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  series.channels.x[3] = nan;
  series.channels.y[9] = std::numeric_limits<float>::infinity();
  series.channels.time[14] = nan;
  series.channels.time[15] = 1e30F;
  for (const Feature& feature : find(series)) {
    EXPECT_TRUE(feature.base_m.allFinite());
    EXPECT_LT(feature.time_s, 1.0);
  }
}

}  // namespace
}  // namespace berm
