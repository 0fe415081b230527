#include "berm/pipeline/pipeline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "groomer_scan.hpp"
#include "support/made_recording.hpp"

namespace berm {
namespace {

Machine made_machine(const std::string& method) {
  Machine machine;
  machine.machine.name = "made";
  machine.sensor.model = "made";
  machine.mount.height_m = 1.7;
  machine.methods.ground = method;
  machine.methods.snow = "none";  // points strewn as thinly as these may well be flakes
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
  Machine machine = made_machine("default");
  machine.methods.snow = "best";
  EXPECT_THROW(Pipeline{machine}, ConfigError);
  machine.methods.snow = "default";
  machine.methods.piste = "best";
  EXPECT_THROW(Pipeline{machine}, ConfigError);
}

std::vector<Stage> stages_of(const Machine& machine) {
  Pipeline pipeline(machine);
  std::vector<Stage> stages;
  static_cast<void>(pipeline.process(test::groomer_scan(), [&stages](Stage stage) { stages.push_back(stage); }));
  return stages;
}

TEST(Pipeline, TellsOfEveryStageInOrderAndOfNoneThatIsLeftOut) {
  EXPECT_EQ(stages_of(test::groomer()),
            (std::vector<Stage>{Stage::snow, Stage::ground, Stage::repair, Stage::piste, Stage::check}));
  EXPECT_EQ(stages_of(test::groomer("none", "default", "none")), (std::vector<Stage>{Stage::ground, Stage::check}));
}

/// Dark points in front of the machine are flakes for the published method; the ground must not see them.
TEST(Pipeline, TheGroundDoesNotSeeFlakes) {
  Scan scan = test::groomer_scan();
  const Machine machine = test::groomer("reference", "default", "none");
  Pipeline pipeline(machine);
  // A sheet of flakes half a metre below the true ground: whoever believes it gets all heights wrong.
  test::change_channels(scan, [&machine](PointChannels& channels) {
    const Pose T_sensor_base = machine.mount.T_base_sensor().inverse();
    for (std::size_t i = 0; i < channels.x.size(); i += 2) {
      const Eigen::Vector3d flake =
          T_sensor_base * Eigen::Vector3d(2.5 + 1e-4 * static_cast<double>(i), std::sin(static_cast<double>(i)), -0.5);
      channels.x[i] = static_cast<float>(flake.x());
      channels.y[i] = static_cast<float>(flake.y());
      channels.z[i] = static_cast<float>(flake.z());
      channels.intensity[i] = 1.0F;
    }
  });
  Scan without = scan;
  test::change_channels(without, [](PointChannels& channels) {
    for (std::size_t i = 0; i < channels.x.size(); i += 2) {
      channels.x[i] = channels.y[i] = channels.z[i] = 0.0F;
    }
  });
  const ScanResult snowy = pipeline.process(scan);
  EXPECT_EQ(snowy.counts.falling_snow, scan.cloud.size() / 2);
  std::vector<Label> labels(snowy.labels.begin(), snowy.labels.end());
  const ScanResult clear = pipeline.process(without);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    ASSERT_EQ(labels[i], i % 2 == 0 ? Label::falling_snow : clear.labels[i]) << i;
  }
  ASSERT_NE(clear.surface, nullptr);
}

TEST(Pipeline, APisteMethodGetsASeriesWithoutGaps) {
  Scan scan = test::groomer_scan();
  test::let_it_snow(scan, 0.1);
  Pipeline pipeline(test::groomer("reference", "default", "reference"));
  const ScanResult result = pipeline.process(scan);
  ASSERT_EQ(result.series.size(), scan.cloud.size());
  ASSERT_EQ(result.piste.steps.size(), scan.cloud.size());
  for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
    const bool gap = result.labels[i] == Label::falling_snow || result.labels[i] == Label::no_return;
    EXPECT_EQ(result.series.interpolated[i] != 0, gap) << i;
  }
  EXPECT_TRUE(result.piste.slope);
  EXPECT_FALSE(result.piste.envelopes.empty());
}

TEST(Pipeline, WithoutAPisteMethodThereIsNoSeries) {
  Pipeline pipeline(test::groomer("default", "default", "none"));
  const Scan scan = test::groomer_scan();
  const ScanResult result = pipeline.process(scan);
  EXPECT_EQ(result.series.size(), 0U);
  EXPECT_FALSE(result.piste.slope);
  EXPECT_EQ(result.counts.terrain, 0U);
}

TEST(Pipeline, TheTiltOfTheGroundIsKnownWhereThereIsASurface) {
  const Scan scan = test::groomer_scan();
  Pipeline with(test::groomer());
  const auto tilt_rad = with.process(scan).ground_tilt_rad;
  ASSERT_TRUE(tilt_rad);
  EXPECT_LT(*tilt_rad, 0.1);
  Pipeline without(test::groomer("default", "reference", "default"));
  EXPECT_FALSE(without.process(scan).ground_tilt_rad);
}

}  // namespace
}  // namespace berm
