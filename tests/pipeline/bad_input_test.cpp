#include <algorithm>
#include <limits>
#include <numeric>
#include <ostream>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "berm/pipeline/pipeline.hpp"
#include "groomer_scan.hpp"

namespace berm {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

struct Methods {
  const char* name;
  const char* snow;
  const char* ground;
  const char* piste;
};

void PrintTo(const Methods& methods, std::ostream* stream) {
  *stream << methods.name;
}

template <typename Values>
void reorder(Values& values, const std::vector<std::size_t>& order) {
  if (values.empty()) {
    return;
  }
  Values sorted;
  for (const std::size_t i : order) {
    sorted.push_back(values[i]);
  }
  values = std::move(sorted);
}

void reorder(PointChannels& channels, const std::vector<std::size_t>& order) {
  reorder(channels.x, order);
  reorder(channels.y, order);
  reorder(channels.z, order);
  reorder(channels.intensity, order);
  reorder(channels.time, order);
}

class BadInput : public testing::TestWithParam<Methods> {
 protected:
  /// Whatever the input: a label for each point, counts that add up, and the same again from a fresh chain.
  Degradations process(const Scan& scan) {
    const Methods& methods = GetParam();
    Pipeline pipeline(test::groomer(methods.snow, methods.ground, methods.piste));
    const ScanResult result = pipeline.process(scan);
    EXPECT_EQ(result.labels.size(), scan.cloud.size());
    EXPECT_EQ(result.counts.points(), scan.cloud.size());
    labels_.assign(result.labels.begin(), result.labels.end());
    counts_ = result.counts;
    mount_ = result.mount;
    Pipeline again(test::groomer(methods.snow, methods.ground, methods.piste));
    const ScanResult second = again.process(scan);
    EXPECT_TRUE(std::equal(labels_.begin(), labels_.end(), second.labels.begin(), second.labels.end()));
    return result.degraded;
  }

  Degradations process_changed(const std::function<void(PointChannels&)>& change) {
    Scan scan = test::groomer_scan();
    test::change_channels(scan, change);
    return process(scan);
  }

  [[nodiscard]] bool has_snow() const { return std::string(GetParam().snow) != "none"; }

  std::vector<Label> labels_;
  LabelCounts counts_;
  MountCheckResult mount_;
};

TEST_P(BadInput, NothingIsWrongWithAGoodScan) {
  EXPECT_EQ(process(test::groomer_scan()).text(), "");
  EXPECT_GT(counts_.drivable + counts_.terrain, counts_.obstacle);
  EXPECT_EQ(mount_.verdict, MountVerdict::plausible);
}

TEST_P(BadInput, NoIntensity) {
  const Degradations degraded = process_changed([](PointChannels& channels) { channels.intensity.clear(); });
  EXPECT_EQ(degraded.has(Degradation::no_intensity), has_snow());
}

TEST_P(BadInput, IntensityAllZeroOrAllEqual) {
  for (const float value : {0.0F, 100.0F, 255.0F}) {
    const Degradations degraded = process_changed(
        [value](PointChannels& channels) { std::fill(channels.intensity.begin(), channels.intensity.end(), value); });
    EXPECT_EQ(degraded.has(Degradation::no_intensity), has_snow()) << value;
    // The published rule takes every dark point near the machine for a flake.
    if (std::string(GetParam().snow) != "reference") {
      EXPECT_LT(counts_.falling_snow, counts_.points() / 50) << "no snow fell; intensity " << value;
    }
  }
}

TEST_P(BadInput, NoReturnsDropped) {
  const Degradations degraded = process_changed([](PointChannels& channels) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < channels.x.size(); ++i) {
      if (!is_no_return(channels.x[i], channels.y[i], channels.z[i])) {
        kept.push_back(i);
      }
    }
    reorder(channels, kept);
  });
  EXPECT_EQ(degraded.has(Degradation::no_returns_dropped), has_snow());
  EXPECT_EQ(counts_.no_return, 0U);
}

TEST_P(BadInput, NoTime) {
  EXPECT_TRUE(process_changed([](PointChannels& channels) { channels.time.clear(); }).has(Degradation::no_time));
  EXPECT_TRUE(process_changed([](PointChannels& channels) {
                std::fill(channels.time.begin(), channels.time.end(), 0.0F);
              }).has(Degradation::no_time));
  EXPECT_TRUE(process_changed([](PointChannels& channels) {
                std::fill(channels.time.begin(), channels.time.end(), kNan);
              }).has(Degradation::no_time));
}

TEST_P(BadInput, NoFiringOrder) {
  const Degradations degraded = process_changed([](PointChannels& channels) {
    std::vector<std::size_t> order(channels.x.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937(3));
    reorder(channels, order);
  });
  EXPECT_TRUE(degraded.has(Degradation::no_firing_order));
}

TEST_P(BadInput, TwoSensorsMerged) {
  const Scan first = test::groomer_scan(1);
  Scan merged = test::groomer_scan(2);
  test::change_channels(merged, [&first](PointChannels& channels) {
    const PointsView other = first.cloud.view();
    channels.x.insert(channels.x.end(), other.x.begin(), other.x.end());
    channels.y.insert(channels.y.end(), other.y.begin(), other.y.end());
    channels.z.insert(channels.z.end(), other.z.begin(), other.z.end());
    channels.intensity.insert(channels.intensity.end(), other.intensity.begin(), other.intensity.end());
    channels.time.insert(channels.time.end(), other.time.begin(), other.time.end());
  });
  EXPECT_FALSE(process(merged).has(Degradation::no_firing_order)) << "one after the other each keeps its order";
  EXPECT_GT(counts_.drivable + counts_.terrain, counts_.obstacle);
}

TEST_P(BadInput, NanAndInfinityAnywhere) {
  const Degradations degraded = process_changed([](PointChannels& channels) {
    const float inf = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < channels.x.size(); i += 20) {
      channels.x[i] = kNan;
      channels.y[i + 1] = -inf;
      channels.z[i + 2] = 1e30F;
      channels.intensity[i + 3] = kNan;
      channels.time[i + 4] = kNan;
    }
  });
  EXPECT_TRUE(degraded.has(Degradation::invalid_points));
  EXPECT_GE(counts_.invalid, 500U);
  for (std::size_t i = 0; i < labels_.size(); i += 20) {
    EXPECT_EQ(labels_[i], Label::unlabeled) << i;
  }
}

TEST_P(BadInput, NothingButNan) {
  const Degradations degraded =
      process_changed([](PointChannels& channels) { std::fill(channels.y.begin(), channels.y.end(), kNan); });
  EXPECT_TRUE(degraded.has(Degradation::few_returns));
  EXPECT_EQ(counts_.invalid, labels_.size());
  EXPECT_EQ(mount_.verdict, MountVerdict::unknown);
}

TEST_P(BadInput, NothingButNoReturns) {
  const Degradations degraded = process_changed([](PointChannels& channels) {
    for (std::vector<float>* values : {&channels.x, &channels.y, &channels.z}) {
      std::fill(values->begin(), values->end(), 0.0F);
    }
  });
  EXPECT_TRUE(degraded.has(Degradation::few_returns));
  EXPECT_EQ(counts_.no_return, labels_.size());
  EXPECT_EQ(mount_.verdict, MountVerdict::unknown);
}

TEST_P(BadInput, NoPointOneAndTwo) {
  for (const std::size_t kept : {0U, 1U, 2U}) {
    const Degradations degraded = process_changed([kept](PointChannels& channels) {
      std::vector<std::size_t> order(kept);
      std::iota(order.begin(), order.end(), std::size_t{0});
      reorder(channels, order);
      if (kept == 0) {
        channels = {};
      }
    });
    EXPECT_TRUE(degraded.has(kept == 0 ? Degradation::no_points : Degradation::few_returns)) << kept;
  }
}

TEST_P(BadInput, SixtyPercentFlakes) {
  Scan scan = test::groomer_scan();
  test::let_it_snow(scan, 0.6);
  const Degradations degraded = process(scan);
  EXPECT_EQ(degraded.has(Degradation::snow_hides_the_scene), counts_.falling_snow > counts_.returns() / 2);
  if (has_snow()) {
    EXPECT_GT(counts_.falling_snow, 0U);
  }
}

TEST_P(BadInput, UpsideDown) {
  Scan scan = test::groomer_scan();
  MountConfig mount = test::groomer().mount;
  mount.roll_deg = 180.0;
  scan.T_base_sensor = mount.T_base_sensor();
  EXPECT_TRUE(process(scan).has(Degradation::mount_implausible));
}

TEST_P(BadInput, ThirtyDegreesWrong) {
  for (const double wrong_deg : {-30.0, 30.0}) {
    Scan scan = test::groomer_scan();
    MountConfig mount = test::groomer().mount;
    mount.pitch_deg += wrong_deg;
    scan.T_base_sensor = mount.T_base_sensor();
    EXPECT_TRUE(process(scan).has(Degradation::mount_implausible)) << "pitch " << wrong_deg;
    mount = test::groomer().mount;
    mount.roll_deg = wrong_deg;
    scan.T_base_sensor = mount.T_base_sensor();
    EXPECT_TRUE(process(scan).has(Degradation::mount_implausible)) << "roll " << wrong_deg;
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, BadInput,
                         testing::Values(Methods{"default", "default", "default", "default"},
                                         Methods{"reference", "reference", "default", "reference"},
                                         Methods{"published_ground", "default", "reference", "default"},
                                         Methods{"ground_alone", "none", "default", "none"}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace berm
