#include "berm/pipeline/pipeline.hpp"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "support/made_recording.hpp"

namespace berm {
namespace {

Machine made_machine(const std::string& method) {
  Machine machine;
  machine.machine.name = "made";
  machine.sensor.model = "made";
  machine.mount.height_m = 1.7;
  machine.methods.ground = method;
  return machine;
}

class PipelineTest : public testing::TestWithParam<const char*> {};

TEST_P(PipelineTest, LabelsEveryPointAndCountsAddUp) {
  Pipeline pipeline(made_machine(GetParam()));
  for (const std::size_t points : {0U, 1U, 5U, 3000U}) {
    Scan scan{.cloud = test::made_cloud(0, points)};
    const ScanResult result = pipeline.process(scan);
    ASSERT_EQ(result.labels.size(), points);
    const auto count = [&result](Label label) {
      return static_cast<std::size_t>(std::count(result.labels.begin(), result.labels.end(), label));
    };
    EXPECT_EQ(count(Label::drivable), result.counts.drivable);
    EXPECT_EQ(count(Label::terrain), result.counts.terrain);
    EXPECT_EQ(count(Label::obstacle), result.counts.obstacle);
    EXPECT_EQ(count(Label::falling_snow), result.counts.falling_snow);
    EXPECT_EQ(count(Label::no_return), result.counts.no_return);
    EXPECT_EQ(count(Label::unlabeled), result.counts.invalid);
    EXPECT_EQ(result.counts.points(), points);
  }
}

TEST_P(PipelineTest, PointsThatAreNoneAreNeitherGroundNorObstacle) {
  PointCloud cloud = test::made_cloud(0, 700);
  PointChannels channels = std::move(cloud).release();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < channels.x.size(); i += 100) {
    channels.z[i] = nan;
  }
  Pipeline pipeline(made_machine(GetParam()));
  const ScanResult result = pipeline.process({.cloud = PointCloud(std::move(channels))});
  for (std::size_t i = 0; i < 700; ++i) {
    const Label label = result.labels[i];
    if (i % 100 == 0) {
      EXPECT_EQ(label, Label::unlabeled) << i;
    } else if (i % 7 == 6) {
      EXPECT_EQ(label, Label::no_return) << i;
    } else {
      EXPECT_TRUE(label == Label::drivable || label == Label::obstacle) << i;
    }
  }
}

TEST_P(PipelineTest, WhatCameBeforeDoesNotMatter) {
  const Scan scan{.cloud = test::made_cloud(3, 2000)};
  Pipeline fresh(made_machine(GetParam()));
  const auto expected = fresh.process(scan);
  Pipeline used(made_machine(GetParam()));
  for (std::size_t i = 0; i < 3; ++i) {
    static_cast<void>(used.process({.cloud = test::made_cloud(i, 1500 + 700 * i)}));
  }
  const auto labels = used.process(scan);
  EXPECT_TRUE(std::equal(expected.labels.begin(), expected.labels.end(), labels.labels.begin(), labels.labels.end()));
}

INSTANTIATE_TEST_SUITE_P(Methods, PipelineTest, testing::Values("default", "reference"),
                         [](const auto& test) { return std::string(test.param); });

TEST(Pipeline, AnUnknownMethodIsRefused) {
  EXPECT_THROW(Pipeline(made_machine("best")), ConfigError);
}

}  // namespace
}  // namespace berm
