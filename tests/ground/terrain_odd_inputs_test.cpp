#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "berm/ground/terrain_ground.hpp"
#include "ground/ground_cases.hpp"

// Scans that no sensor should send, and some do.

namespace berm {
namespace {

using Eigen::Vector3f;
using Points = std::vector<Vector3f>;

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kMax = std::numeric_limits<float>::max();

struct Outcome {
  std::vector<GroundClass> classes;
  GroundCounts counts;
};

/// Labels the points; checks the counts, and that every height of the surface is a number.
Outcome process(const Points& points, const Pose& T_base_sensor = test::mount(1.73),
                const TerrainGroundConfig& config = {}) {
  TerrainGround ground(config);
  const PointCloud cloud = test::cloud_of(points);
  const GroundResult result = ground.process(cloud.view(), T_base_sensor);
  EXPECT_TRUE(test::counts_add_up(result, points.size()));
  EXPECT_NE(result.surface, nullptr);
  const HeightGrid::Channels& channels = result.surface->channels();
  const auto finite = [](float value) { return std::isfinite(value); };
  EXPECT_TRUE(std::all_of(channels.height_m.begin(), channels.height_m.end(), finite));
  EXPECT_TRUE(std::all_of(channels.radial_slope.begin(), channels.radial_slope.end(), finite));
  EXPECT_TRUE(std::all_of(channels.variance_m2.begin(), channels.variance_m2.end(),
                          [](float value) { return std::isfinite(value) && value >= 0.0F; }));
  EXPECT_TRUE(result.surface->T_level_sensor().matrix().allFinite()) << result.surface->T_level_sensor().matrix();
  return {test::classes_of(result), result.counts};
}

Points good_scan() {
  return test::points_of(test::rings_64().look(test::flat_street().world).cloud.view());
}

/// How many of the labels differ, over points that both scans share.
std::size_t different(const std::vector<GroundClass>& a, const std::vector<GroundClass>& b,
                      const std::vector<bool>& skip) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    count += !skip[i] && a[i] != b[i] ? 1U : 0U;
  }
  return count;
}

TEST(TerrainOddInputs, EmptyAndNearlyEmptyScans) {
  EXPECT_EQ(process({}).classes.size(), 0U);
  const auto one = process({{5.0F, 1.0F, -1.73F}});
  EXPECT_EQ(one.counts.ground, 1U) << "the mount says where the ground is";
  EXPECT_EQ(process({{5.0F, 1.0F, 0.5F}}).counts.ground, 0U);
  const auto five = process(
      {{5.0F, 1.0F, -1.73F}, {5.0F, -1.0F, -1.7F}, {7.0F, 0.0F, -1.75F}, {-6.0F, 2.0F, -1.72F}, {-6.0F, 2.0F, 1.0F}});
  EXPECT_EQ(five.counts.ground, 4U);
  EXPECT_EQ(process({{5.0F, 1.0F, -1.73F}}, test::mount(0.0)).classes.size(), 1U) << "height unknown";
}

TEST(TerrainOddInputs, PointsThatSayNothingAboutAPlane) {
  const auto all_same = process(Points(1000, Vector3f(8.0F, 3.0F, -1.7F)));
  EXPECT_EQ(all_same.counts.ground, 1000U);
  Points line;
  Points column;
  Points wall;
  for (int i = 0; i < 1000; ++i) {
    const float t = 0.03F * static_cast<float>(i);
    line.emplace_back(2.5F + t, 1.0F, -1.73F);
    column.emplace_back(8.0F, 3.0F, -1.73F + t);
    wall.emplace_back(8.0F, -15.0F + t, -1.0F + 0.1F * static_cast<float>(i % 40));
  }
  EXPECT_GT(process(line).counts.ground, 900U) << "along a straight line of ground";
  EXPECT_LT(process(column).counts.ground, 20U) << "a pole";
  EXPECT_LT(process(wall).counts.ground, 300U) << "nothing but a wall";
}

TEST(TerrainOddInputs, NothingButBadPoints) {
  EXPECT_EQ(process(Points(100, Vector3f(kNan, kNan, kNan))).counts.invalid, 100U);
  EXPECT_EQ(process(Points(100, Vector3f(1.0F, 1.0F, kNan))).counts.invalid, 100U);
  EXPECT_EQ(process(Points(100, Vector3f(kMax, kMax, kMax))).counts.invalid, 100U);
  EXPECT_EQ(process(Points(100, Vector3f(5.0F, 5.0F, -kMax))).counts.invalid, 100U);
  EXPECT_EQ(process(Points(100, Vector3f(kInf, kInf, kInf))).counts.no_return, 100U);
  EXPECT_EQ(process(Points(100, Vector3f::Zero())).counts.no_return, 100U);
  const auto denormal = process(Points(100, Vector3f(1e-40F, 1e-41F, -1e-42F)));
  EXPECT_EQ(denormal.counts.ground + denormal.counts.not_ground, 100U) << "tiny, and still a place";
}

TEST(TerrainOddInputs, OneBadPointChangesNoOtherLabel) {
  const Points good = good_scan();
  const auto expected = process(good).classes;
  for (const Vector3f& bad :
       {Vector3f(kNan, kNan, kNan), Vector3f(10.0F, 1.0F, kNan), Vector3f(10.0F, kNan, -1.7F),
        Vector3f(kInf, -kInf, kInf), Vector3f(kMax, -kMax, kMax), Vector3f(10.0F, 1.0F, kMax),
        Vector3f(10.0F, 1.0F, -kMax), Vector3f(10.0F, 1.0F, -kInf), Vector3f(1e-40F, 0.0F, -1e-40F)}) {
    Points points = good;
    points.push_back(bad);
    auto classes = process(points).classes;
    EXPECT_NE(classes.back(), GroundClass::ground) << bad.transpose();
    classes.pop_back();
    // One more point moves no stride; a place of its own could take a cell, so not all labels need to stay.
    EXPECT_LE(different(classes, expected, std::vector<bool>(good.size(), false)), good.size() / 1000)
        << bad.transpose();
  }
}

TEST(TerrainOddInputs, OnePercentOfBadPointsHardlyTouchesTheOthers) {
  const Points good = good_scan();
  const auto expected = process(good).classes;
  std::mt19937 random(5);
  for (const Vector3f& bad : {Vector3f(kNan, kNan, kNan), Vector3f(kInf, kInf, kInf), Vector3f(kMax, kMax, -kMax),
                              Vector3f(0.0F, 0.0F, 0.0F)}) {
    Points points = good;
    std::vector<bool> spoilt(good.size(), false);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (random() % 100 == 0) {
        points[i] = bad;
        spoilt[i] = true;
      }
    }
    const auto outcome = process(points);
    EXPECT_LT(different(outcome.classes, expected, spoilt), good.size() / 1000) << bad.transpose();
    for (std::size_t i = 0; i < points.size(); ++i) {
      ASSERT_FALSE(spoilt[i] && outcome.classes[i] == GroundClass::ground) << bad.transpose();
    }
  }
}

TEST(TerrainOddInputs, AnyFloatsAtAllGiveNumbers) {
  std::mt19937 random(17);
  const auto any_float = [&random] {
    const auto bits = static_cast<std::uint32_t>(random());
    float value = 0.0F;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  };
  for (int round = 0; round < 20; ++round) {
    Points points = round % 2 == 0 ? Points() : good_scan();
    for (int i = 0; i < 2000; ++i) {
      points.emplace_back(any_float(), any_float(), any_float());
    }
    TerrainGroundConfig config;
    config.min_range_m = round % 3 == 0 ? 0.0 : 2.0;
    (void)process(points, test::mount(round % 4 == 0 ? 0.0 : 1.73), config);
  }
}

TEST(TerrainOddInputs, AMountOfAnyKindGivesNumbers) {
  const Points good = good_scan();
  for (const double height_m : {-3.0, 0.0, 1e-9, 50.0, 1e6}) {
    (void)process(good, test::mount(height_m));
  }
  for (const double roll_rad : {0.5, 1.57, 3.14}) {
    (void)process(good, Pose::from_yaw_pitch_roll(1.0, 0.3, roll_rad, {0.0, 0.0, 1.73}));
  }
}

TEST(TerrainOddInputs, TenMillionPoints) {
  std::mt19937 random(2);
  PointChannels channels;
  constexpr std::size_t kCount = 10'000'000;
  channels.x.reserve(kCount), channels.y.reserve(kCount), channels.z.reserve(kCount);
  const auto unit = [&random] { return static_cast<float>(random()) * 0x1p-32F; };
  for (std::size_t i = 0; i < kCount; ++i) {
    channels.x.push_back(80.0F * unit() - 40.0F);
    channels.y.push_back(80.0F * unit() - 40.0F);
    channels.z.push_back(i % 2 == 0 ? -1.73F : 3.0F * unit());
  }
  const PointCloud cloud(std::move(channels));
  TerrainGround ground({});
  const GroundResult result = ground.process(cloud.view(), test::mount(1.73));
  EXPECT_TRUE(test::counts_add_up(result, kCount));
  EXPECT_NEAR(static_cast<double>(result.counts.ground), 0.5 * kCount, 0.02 * kCount);
}

}  // namespace
}  // namespace berm
