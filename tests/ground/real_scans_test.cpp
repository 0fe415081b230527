#include <cmath>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "berm/eval/label_metrics.hpp"
#include "berm/ground/polar_ground.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/recording.hpp"
#include "ground/ground_cases.hpp"
#include "support/data.hpp"

namespace berm {
namespace {

struct LabelledScan {
  PointCloud cloud;
  std::vector<std::uint32_t> truth;
};

struct Tilt {
  std::string name;
  double pitch_deg;
  double roll_deg;
};

const std::vector<Tilt>& tilts() {
  static const std::vector<Tilt> all = {
      {"level", 0.0, 0.0}, {"pitch_10", 10.0, 0.0}, {"pitch_20", 20.0, 0.0}, {"roll_15", 0.0, 15.0}};
  return all;
}

std::vector<LabelledScan> labelled_scans(const std::filesystem::path& path) {
  const Recording recording = Recording::open(path);
  std::vector<LabelledScan> scans;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    if (const auto labels = recording.scan(i).truth_labels) {
      Scan scan;
      recording.read(i, scan);
      scans.push_back({std::move(scan.cloud), {}});
      scans.back().truth = read_labels(*labels, scans.back().cloud.size());
    }
  }
  return scans;
}

/// F1 of the ground over all scans, each turned about the sensor.
double f1_of(GroundSegmenter& ground, const std::vector<LabelledScan>& scans, const Tilt& tilt, double height_m) {
  BinaryCounts counts;
  for (const LabelledScan& scan : scans) {
    const PointCloud cloud = test::turned(scan.cloud.view(), 0.0, tilt.pitch_deg, tilt.roll_deg);
    const GroundResult result = ground.process(cloud.view(), test::mount(height_m));
    EXPECT_TRUE(test::counts_add_up(result, cloud.size()));
    std::vector<std::uint32_t> output;
    for (const GroundClass c : result.classes) {
      output.push_back(c == GroundClass::ground ? 40U : 99U);
    }
    counts += judge_ground(output, scan.truth);
  }
  return derive_metrics(counts).f1.value_or(0.0);
}

TEST(GroundOnKitti, ReachesWhatIsAskedLevelAndTilted) {
  BERM_NEED_DATA(path, "kitti00");
  const std::vector<LabelledScan> scans = labelled_scans(path);
  ASSERT_EQ(scans.size(), 8U) << "the even frames are labelled";
  TerrainGround ground({});
  PolarGround reference({});
  for (const double height_m : {1.73, 1.2, 2.5}) {
    for (const Tilt& tilt : tilts()) {
      const double f1 = f1_of(ground, scans, tilt, height_m);
      const std::string name = tilt.name + "_mount_" + std::to_string(static_cast<int>(100.0 * height_m));
      RecordProperty(name, std::to_string(f1));
      EXPECT_GE(f1, tilt.name == "level" ? 0.992 : 0.988) << name;
    }
  }
  for (const Tilt& tilt : tilts()) {
    const double f1 = f1_of(reference, scans, tilt, 1.73);
    RecordProperty("reference_" + tilt.name, std::to_string(f1));
    EXPECT_GT(f1, tilt.name == "level" ? 0.8 : 0.1) << "the reference as published, " << tilt.name;
  }
}

TEST(GroundOnKitti, GivesTheSameBytesInEveryRunAndObject) {
  BERM_NEED_DATA(path, "kitti00");
  const Recording recording = Recording::open(path);
  TerrainGround used({});
  for (const std::size_t i : {0U, 7U, 15U}) {
    Scan scan;
    recording.read(i, scan);
    TerrainGround fresh({});
    const GroundResult first = fresh.process(scan.cloud.view(), test::mount(1.73));
    const GroundResult again = used.process(scan.cloud.view(), test::mount(1.73));
    EXPECT_EQ(test::classes_of(first), test::classes_of(again)) << i;
    EXPECT_EQ(first.surface->channels().height_m, again.surface->channels().height_m) << i;
    EXPECT_EQ(first.surface->channels().variance_m2, again.surface->channels().variance_m2) << i;
    const auto kept = test::classes_of(again);
    EXPECT_EQ(test::classes_of(used.process(scan.cloud.view(), test::mount(1.73))), kept) << i;
  }
}

struct Plausible {
  double height_m;
  double least_share;  ///< of ground among the returns of every scan
  double most_share;
};

/// Looked at as pictures; the shares are those of the scans, with room. The Mid-360 stands in a small room, and no beam
/// of it meets the floor.
const std::map<std::string, Plausible>& plausible_shares() {
  static const std::map<std::string, Plausible> all = {
      {"kitti00", {1.73, 0.3, 0.7}},      {"wads36", {2.0, 0.2, 0.8}},        {"livox_horizon", {1.9, 0.1, 0.9}},
      {"livox_vehicle", {0.0, 0.1, 0.9}}, {"livox_mid40", {1.5, 0.05, 0.95}}, {"livox_mid360", {0.5, 0.0, 0.05}},
      {"hdl32_rings", {2.0, 0.2, 0.8}},   {"per_point_time", {2.0, 0.2, 0.8}}};
  return all;
}

class GroundOnRecording : public ::testing::TestWithParam<std::string> {};

TEST_P(GroundOnRecording, FindsAPlausibleShare) {
  BERM_NEED_DATA(path, GetParam());
  const Plausible plausible = plausible_shares().at(GetParam());
  const Recording recording = Recording::open(path);
  ASSERT_GT(recording.size(), 0U);
  TerrainGround ground({});
  PolarGround reference({});
  Scan scan;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    recording.read(i, scan);
    ASSERT_GT(scan.cloud.size(), 1000U);
    const GroundResult result = ground.process(scan.cloud.view(), test::mount(plausible.height_m));
    EXPECT_TRUE(test::counts_add_up(result, scan.cloud.size()));
    const double returns = static_cast<double>(result.counts.ground + result.counts.not_ground);
    const double share = static_cast<double>(result.counts.ground) / returns;
    EXPECT_GE(share, plausible.least_share) << recording.scan(i).name;
    EXPECT_LT(share, plausible.most_share) << recording.scan(i).name;
    EXPECT_TRUE(
        test::counts_add_up(reference.process(scan.cloud.view(), test::mount(plausible.height_m)), scan.cloud.size()));
  }
}

INSTANTIATE_TEST_SUITE_P(All, GroundOnRecording,
                         ::testing::Values("kitti00", "wads36", "livox_horizon", "livox_vehicle", "livox_mid40",
                                           "livox_mid360", "hdl32_rings", "per_point_time"));

}  // namespace
}  // namespace berm
