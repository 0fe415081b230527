#include "berm/eval/sharpness.hpp"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

struct Cloud {
  std::vector<float> x, y, z;

  void add(double px, double py, double pz) {
    x.push_back(static_cast<float>(px));
    y.push_back(static_cast<float>(py));
    z.push_back(static_cast<float>(pz));
  }
  [[nodiscard]] Sharpness measure() const { return measure_sharpness(x, y, z); }
};

double uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11U) * 0x1p-53;
}

/// A slope with noise across it, seen a second time `ghost_m` off.
Cloud slope(double noise_m, double ghost_m) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> noise(0.0, noise_m);
  Cloud cloud;
  for (int i = 0; i < 40'000; ++i) {
    const double along_m = 10.0 * uniform(random);
    const double across_m = 10.0 * uniform(random);
    const double off_m = noise(random) + (i % 2 == 0 ? 0.0 : ghost_m);
    cloud.add(0.8 * along_m - 0.6 * off_m, across_m, 0.6 * along_m + 0.8 * off_m);
  }
  return cloud;
}

TEST(SharpnessTest, IsTheNoiseOfAPlane) {
  const Sharpness sharpness = slope(0.02, 0.0).measure();
  EXPECT_NEAR(sharpness.median_thickness_m, 0.02, 0.002);
  EXPECT_NEAR(sharpness.mean_thickness_m, 0.02, 0.003);
  EXPECT_GT(sharpness.patches, 300U);
}

TEST(SharpnessTest, AGhostMakesAPlaneThicker) {
  EXPECT_NEAR(slope(0.01, 0.1).measure().median_thickness_m, 0.05, 0.006);
}

TEST(SharpnessTest, OddInput) {
  Cloud cloud;
  EXPECT_EQ(cloud.measure().patches, 0U);
  for (int i = 0; i < 100; ++i) {
    cloud.add(1.0, 1.0, 0.01 * i);
    cloud.add(std::nan(""), 0.0, 0.0);
    cloud.add(1e30, 0.0, 0.0);
  }
  EXPECT_EQ(cloud.measure().patches, 0U) << "a stalk is no plane";
  cloud.x.pop_back();
  EXPECT_THROW(static_cast<void>(cloud.measure()), Error);
}

}  // namespace
}  // namespace berm
