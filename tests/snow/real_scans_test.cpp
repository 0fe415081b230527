#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/io/label_file.hpp"
#include "berm/io/recording.hpp"
#include "berm/snow/box_snow.hpp"
#include "berm/snow/sparse_snow.hpp"
#include "snow/snow_cases.hpp"
#include "support/data.hpp"

namespace berm {
namespace {

/// Marks and truth over several scans.
struct Counts {
  double hits = 0.0;
  double marks = 0.0;
  double flakes = 0.0;

  [[nodiscard]] double f1() const { return 2.0 * hits / (marks + flakes); }
};

template <typename Filter>
Counts count(Filter& filter, const std::filesystem::path& path, bool drop_intensity) {
  const Recording recording = Recording::open(path);
  Counts counts;
  Scan scan;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    recording.read(i, scan);
    const std::vector<std::uint32_t> truth = read_labels(*recording.scan(i).truth_labels, scan.cloud.size());
    PointsView points = scan.cloud.view();
    if (drop_intensity) {
      points.intensity = {};
    }
    const SnowResult result = filter.process(points, Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {0.0, 0.0, 2.0}));
    EXPECT_TRUE(test::is_sound(result, points));
    counts.marks += static_cast<double>(result.count);
    for (std::size_t k = 0; k < truth.size(); ++k) {
      const bool flake = (truth[k] & 0xFFFFU) == 110U;
      counts.flakes += flake ? 1.0 : 0.0;
      counts.hits += flake && result.falling[k] != 0 ? 1.0 : 0.0;
    }
  }
  return counts;
}

TEST(SnowOnWads, ReachesWhatIsAsked) {
  BERM_NEED_DATA(path, "wads36");
  SparseSnow snow({});
  const Counts found = count(snow, path, false);
  RecordProperty("f1", std::to_string(found.f1()));
  EXPECT_GE(found.f1(), 0.95);
  const Counts geometry = count(snow, path, true);
  RecordProperty("f1_without_intensity", std::to_string(geometry.f1()));
  EXPECT_GE(geometry.f1(), 0.88);
  BoxSnow reference({});
  EXPECT_LT(count(reference, path, false).f1(), 0.5) << "the reference as published";
}

class SnowOnClearScans : public ::testing::TestWithParam<std::string> {};

TEST_P(SnowOnClearScans, MarksNextToNothing) {
  BERM_NEED_DATA(path, GetParam());
  const Recording recording = Recording::open(path);
  ASSERT_GT(recording.size(), 0U);
  SparseSnow snow({});
  Scan scan;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    recording.read(i, scan);
    PointsView points = scan.cloud.view();
    ASSERT_GT(points.size(), 1000U);
    const auto most = static_cast<std::size_t>(0.0005 * static_cast<double>(points.size()));
    const SnowResult result = snow.process(points, {});
    EXPECT_TRUE(test::is_sound(result, points));
    EXPECT_LE(result.count, most) << i;
    points.intensity = {};
    EXPECT_LE(snow.process(points, {}).count, most) << i << " without intensity";
  }
}

INSTANTIATE_TEST_SUITE_P(Recordings, SnowOnClearScans,
                         ::testing::Values("kitti00", "livox_horizon", "livox_vehicle", "livox_mid40", "livox_mid360",
                                           "hdl32_rings", "per_point_time"),
                         [](const auto& instance) { return instance.param; });

}  // namespace
}  // namespace berm
