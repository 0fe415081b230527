#include "berm/ground/polar_ground.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "ground/ground_cases.hpp"

// Clouds of a few points whose labels follow from METHODS G by hand. Cells without points count as the height of the
// ground under the sensor, -sensor_height_m, so that most clouds need points in a few cells only.

namespace berm {
namespace {

using Eigen::Vector3f;
using test::cloud_of;

/// A point at the middle of a cell of G's grid: 80 channels, 120 bins from 3.4 to 120 m.
Vector3f in_cell(int channel, int bin, double z_m) {
  const double azimuth_rad = (channel + 0.5) / 80.0 * 2.0 * std::numbers::pi - std::numbers::pi;
  const double range_m = 3.4 + (bin + 0.5) / 120.0 * (120.0 - 3.4);
  return Vector3f(static_cast<float>(range_m * std::cos(azimuth_rad)),
                  static_cast<float>(range_m * std::sin(azimuth_rad)), static_cast<float>(z_m));
}

/// Which of the points G calls ground, in order: 'g', '.' not ground, '0' no return, '!' invalid.
std::string labels(const std::vector<Vector3f>& points, const PolarGroundConfig& config = {},
                   const Pose& T_base_sensor = Pose()) {
  PolarGround ground(config);
  const PointCloud cloud = cloud_of(points);
  const GroundResult result = ground.process(cloud.view(), T_base_sensor);
  EXPECT_TRUE(test::counts_add_up(result, points.size()));
  std::string text;
  for (const GroundClass c : result.classes) {
    text += c == GroundClass::ground       ? 'g'
            : c == GroundClass::not_ground ? '.'
            : c == GroundClass::no_return  ? '0'
                                           : '!';
  }
  return text;
}

/// One point per cell of channel 10, bins 20 and on.
std::vector<Vector3f> channel_of(const std::vector<double>& heights_m) {
  std::vector<Vector3f> points;
  for (std::size_t i = 0; i < heights_m.size(); ++i) {
    points.push_back(in_cell(10, 20 + static_cast<int>(i), heights_m[i]));
  }
  return points;
}

/// Channels below have empty cells that are neither ground nor stuck at T_hmin.
PolarGroundConfig low_sensor() {
  PolarGroundConfig config;
  config.sensor_height_m = 1.5;
  return config;
}

TEST(PolarGround, Step1DropsWhatIsNearerThan3p4AndFartherThan120Metres) {
  EXPECT_EQ(labels({{3.3F, 0.0F, -0.5F}, {3.5F, 0.0F, -1.9F}, {119.9F, 0.0F, -1.9F}, {120.1F, 0.0F, -1.9F}}), ".gg.");
  EXPECT_EQ(labels({{0.0F, 0.0F, -1.9F}, {0.0F, 0.0F, -50.0F}}), "..") << "straight below there is no channel";
  PolarGroundConfig config;
  config.min_range_m = 5.0;
  config.max_range_m = 20.0;
  EXPECT_EQ(labels({{4.9F, 0.0F, -0.5F}, {6.0F, 0.0F, -1.9F}, {19.0F, 0.0F, -1.9F}, {20.1F, 0.0F, -1.9F}}, config),
            ".gg.");
}

TEST(PolarGround, Step2KeepsTheLowestPointOfACell) {
  // Ground at -1.9 lets -1.68 in, ground at -1.8 does not let -1.5 in.
  EXPECT_EQ(labels({in_cell(10, 20, -1.68), in_cell(10, 20, -1.9)}), "gg");
  EXPECT_EQ(labels({in_cell(10, 20, -1.5), in_cell(10, 20, -1.8)}), ".g");
  // The next bin and the next channel are other cells: -1.68 alone is ground of its own, and it lets -1.45 in.
  EXPECT_EQ(labels({in_cell(10, 20, -1.9), in_cell(10, 21, -1.68), in_cell(10, 21, -1.45)}), "ggg");
  EXPECT_EQ(labels({in_cell(10, 20, -1.9), in_cell(11, 20, -1.68), in_cell(11, 20, -1.45)}), "ggg");
  EXPECT_EQ(labels({in_cell(10, 20, -1.9), in_cell(10, 20, -1.68), in_cell(10, 20, -1.45)}), "gg.");
}

TEST(PolarGround, Step2LosesAzimuthPlusPiAsPublished) {
  EXPECT_EQ(labels({{-10.0F, 0.0F, -1.9F}}), ".") << "channel 80 of 0..79";
  EXPECT_EQ(labels({{-10.0F, -0.0F, -1.9F}}), "g") << "azimuth -pi";
}

TEST(PolarGround, Step3TakesTheGroundUnderTheSensorForAPrototypeAboveTheRange) {
  PolarGroundConfig config;
  config.sensor_height_m = 0.5;
  EXPECT_EQ(labels({in_cell(10, 20, -0.3)}, config), "g") << "-0.3 < -0.5 + 0.25";
  EXPECT_EQ(labels({in_cell(10, 20, -0.2)}, config), ".");
  config.sensor_height_m = 0.6;
  EXPECT_EQ(labels({in_cell(10, 20, -0.3)}, config), ".") << "-0.3 > -0.6 + 0.25";
  EXPECT_EQ(labels({in_cell(10, 20, -0.41), in_cell(10, 20, -0.3)}, config), "gg") << "-0.41 lies in the range";
}

TEST(PolarGround, Step3HoldsAPrototypeBelowTheRangeAtItsLowerEnd) {
  EXPECT_EQ(labels({in_cell(10, 20, -3.0), in_cell(10, 20, -1.76), in_cell(10, 20, -1.74)}), "gg.");
  PolarGroundConfig config;
  config.min_height_m = -2.2;
  config.sensor_height_m = 2.2;
  EXPECT_EQ(labels({in_cell(10, 20, -3.0), in_cell(10, 20, -1.96), in_cell(10, 20, -1.94)}, config), "gg.");
}

TEST(PolarGround, Steps4And6LetASmoothedHeightDecideForACellAtTheUpperEnd) {
  // A cell at T_hmax itself is ground only if it is smoothed to below it; -0.5 is exact in binary.
  PolarGroundConfig config;
  config.max_height_m = -0.5;
  config.sensor_height_m = 0.4;  // empty cells: above T_hmax, not ground
  EXPECT_EQ(labels(channel_of({-0.5}), config), ".") << "empty neighbours at -0.4 pull it up";
  EXPECT_EQ(labels(channel_of({-0.7, -0.5, -0.7}), config), "ggg") << "neighbours at -0.7 pull it down";
  EXPECT_EQ(labels(channel_of({-0.7, -0.5}), config), "gg") << "-0.7 pulls more than -0.4";
  EXPECT_EQ(labels(channel_of({-0.55, -0.5, -0.5, -0.55}), config), "gggg");
}

TEST(PolarGround, Steps5And6RefuseAStepOf40CentimetresAlongTheChannel) {
  EXPECT_EQ(labels(channel_of({-1.9, -1.9, -1.52, -1.6, -1.9})), "ggggg") << "steps of 0.38 and 0.3";
  EXPECT_EQ(labels(channel_of({-1.9, -1.9, -1.48, -1.7, -1.9})), "g..gg") << "a step of 0.42 marks both of its cells";
  EXPECT_EQ(labels(channel_of({-1.9, -1.7, -1.48, -1.9, -1.9})), "gg..g") << "to the next bin as well";
  EXPECT_EQ(labels({in_cell(10, 0, -1.5)}), ".") << "the first bin has only the next to differ from";
  EXPECT_EQ(labels({in_cell(10, 0, -1.7)}), "g");
  EXPECT_EQ(labels({in_cell(10, 119, -1.5)}), ".") << "the last one only the one before";
  EXPECT_EQ(labels({in_cell(10, 119, -1.7)}), "g");
}

TEST(PolarGround, Step5DoesNotLookAtTheNextChannel) {
  std::vector<Vector3f> points;
  for (int bin = 0; bin < 120; ++bin) {
    points.push_back(in_cell(10, bin, -0.6));
    points.push_back(in_cell(11, bin, -1.9));
  }
  EXPECT_EQ(labels(points), std::string(240, 'g'));
}

TEST(PolarGround, Step7GivesACellStuckAtTheLowerEndTheMeanOfItsNeighbours) {
  // Stuck at -2.0 it would let in up to -1.75; at the mean of -1.9 and -1.7 up to -1.55.
  std::vector<Vector3f> points = channel_of({-1.8, -1.9, -2.3, -1.7, -1.8});
  points.push_back(in_cell(10, 22, -1.57));
  points.push_back(in_cell(10, 22, -1.53));
  EXPECT_EQ(labels(points, low_sensor()), "gggggg.");
}

TEST(PolarGround, Step7GivesTwoStuckCellsTheMeanOfTheGoodOnesAroundThem) {
  std::vector<Vector3f> points = channel_of({-1.8, -1.8, -2.3, -2.3, -1.8, -1.8});
  for (const int bin : {22, 23}) {
    points.push_back(in_cell(10, bin, -1.57));
    points.push_back(in_cell(10, bin, -1.53));
  }
  EXPECT_EQ(labels(points, low_sensor()), "ggggggg.g.");
}

TEST(PolarGround, Step7LeavesThreeStuckCellsAsTheyAre) {
  std::vector<Vector3f> points = channel_of({-1.8, -1.8, -2.3, -2.3, -2.3, -1.8, -1.8});
  for (const int bin : {22, 23, 24}) {
    points.push_back(in_cell(10, bin, -1.77));
    points.push_back(in_cell(10, bin, -1.73));
  }
  EXPECT_EQ(labels(points, low_sensor()), "gggggggg.g.g.");
}

TEST(PolarGround, Step7StaysWithinARunOfGround) {
  // Bin 21 lies at a step of 0.5 and is no ground: the stuck bin 22 keeps its height.
  std::vector<Vector3f> points = channel_of({-1.3, -1.8, -2.3, -1.8, -1.8});
  points.push_back(in_cell(10, 22, -1.77));
  points.push_back(in_cell(10, 22, -1.73));
  EXPECT_EQ(labels(points, low_sensor()), "..gggg.");
}

TEST(PolarGround, Step8FillsACellBetweenFourGroundCellsWithTheMeanOfTheMiddleTwo) {
  PolarGroundConfig config;
  config.sensor_height_m = 0.3;  // empty cells, and those with high points, are above T_hmax: not ground
  const std::vector<Vector3f> middle = {in_cell(10, 20, -0.19), in_cell(10, 20, -0.17)};
  EXPECT_EQ(labels(middle, config), "..");
  std::vector<Vector3f> points = {in_cell(10, 19, -0.41), in_cell(10, 21, -0.42), in_cell(9, 20, -0.60),
                                  in_cell(11, 20, -0.44)};
  points.insert(points.end(), middle.begin(), middle.end());
  // Sorted -0.60 -0.44 -0.42 -0.41: ground at -0.43 lets in up to -0.18; the mean of all four only up to -0.2175.
  EXPECT_EQ(labels(points, config), "ggggg.");
  points.erase(points.begin() + 3);
  EXPECT_EQ(labels(points, config), "ggg..") << "three of four are not enough";
}

TEST(PolarGround, Step9LetsInPointsUpToTheTolerance) {
  EXPECT_EQ(labels({in_cell(10, 20, -1.9), in_cell(10, 20, -1.66), in_cell(10, 20, -1.64), in_cell(10, 20, 3.0)}),
            "gg..");
  PolarGroundConfig config;
  config.tolerance_m = 0.1;
  EXPECT_EQ(labels({in_cell(10, 20, -1.9), in_cell(10, 20, -1.81), in_cell(10, 20, -1.79)}, config), "gg.");
}

TEST(PolarGround, UsesTheRotationOfTheMountAndNotItsPlace) {
  const std::vector<Vector3f> level = {in_cell(40, 20, -1.9), in_cell(40, 20, -1.5), in_cell(75, 30, -1.8),
                                       in_cell(3, 9, -1.0)};
  const std::string expected = labels(level);
  EXPECT_EQ(expected, "g.g.");
  const Pose T_base_sensor = Pose::from_yaw_pitch_roll(0.0, 0.3, -0.2, {5.0, 6.0, 7.0});
  std::vector<Vector3f> seen;
  for (const Vector3f& p : level) {
    seen.push_back((T_base_sensor.rotation().conjugate() * p.cast<double>()).cast<float>());
  }
  EXPECT_EQ(labels(seen, {}, T_base_sensor), expected);
  EXPECT_NE(labels(seen), expected) << "without the rotation";
}

TEST(PolarGround, CountsBadPointsAndNeverUsesThem) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kMax = std::numeric_limits<float>::max();
  EXPECT_EQ(labels({{kNan, 1.0F, 1.0F},
                    {10.0F, 0.1F, kNan},
                    {kMax, kMax, kMax},
                    {10.0F, 0.1F, -kMax},
                    {2e4F, 0.0F, 0.0F},
                    {0.0F, 0.0F, 0.0F},
                    {kInf, kInf, kInf},
                    {10.0F, 0.1F, -1.9F},
                    {10.0F, 0.1F, -1.7F}}),
            "!!!!!00gg");
  EXPECT_EQ(labels({}), "");
}

TEST(PolarGround, RemembersNothingOfTheScanBefore) {
  const PointCloud high = cloud_of({in_cell(10, 20, -1.9), in_cell(10, 21, -1.2)});
  const PointCloud low = cloud_of({in_cell(10, 20, -1.8)});
  PolarGround ground({});
  const auto first = test::classes_of(ground.process(low.view(), Pose()));
  (void)ground.process(high.view(), Pose());
  EXPECT_EQ(test::classes_of(ground.process(low.view(), Pose())), first);
  EXPECT_EQ(ground.process(low.view(), Pose()).surface, nullptr);
}

TEST(PolarGroundConfig, RefusesWhatIsOutOfRange) {
  EXPECT_NO_THROW(PolarGroundConfig{}.check());
  const auto key_refused = [](const std::function<void(PolarGroundConfig&)>& spoil) -> std::string {
    PolarGroundConfig config;
    spoil(config);
    try {
      const PolarGround ground(config);
    } catch (const ConfigError& error) {
      return error.key();
    }
    return "none";
  };
  using C = PolarGroundConfig;
  EXPECT_EQ(key_refused([](C& c) { c.channels = 0; }), "ground_reference.channels");
  EXPECT_EQ(key_refused([](C& c) { c.bins = -1; }), "ground_reference.bins");
  EXPECT_EQ(key_refused([](C& c) { c.tolerance_m = -0.1; }), "ground_reference.tolerance_m");
  EXPECT_EQ(key_refused([](C& c) { c.tolerance_m = std::nan(""); }), "ground_reference.tolerance_m");
  EXPECT_EQ(key_refused([](C& c) { c.max_difference_m = 0.0; }), "ground_reference.max_difference_m");
  EXPECT_EQ(key_refused([](C& c) { c.min_range_m = 30.0, c.max_range_m = 20.0; }), "ground_reference.min_range_m");
  EXPECT_EQ(key_refused([](C& c) { c.min_height_m = c.max_height_m; }), "ground_reference.min_height_m");
}

}  // namespace
}  // namespace berm
