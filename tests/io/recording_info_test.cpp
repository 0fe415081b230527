#include "berm/io/recording_info.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/angle.hpp"
#include "berm/core/error.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/pcd.hpp"
#include "support/data.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

constexpr double kPi = std::numbers::pi;

void add_point(PointChannels& cloud, double azimuth_rad, double elevation_rad, double range_m) {
  cloud.x.push_back(static_cast<float>(range_m * std::cos(elevation_rad) * std::cos(azimuth_rad)));
  cloud.y.push_back(static_cast<float>(range_m * std::cos(elevation_rad) * std::sin(azimuth_rad)));
  cloud.z.push_back(static_cast<float>(range_m * std::sin(elevation_rad)));
}

/// A room that is a little different in every direction, so that no two points coincide.
double room_m(double azimuth_rad, double elevation_rad) {
  return 5.0 + std::sin(3.0 * azimuth_rad) + std::cos(7.0 * elevation_rad);
}

/// `rings` lasers from `low` to `high` deg, `columns` azimuths clockwise, as VLP and HDL sensors turn.
PointChannels spinning(int rings, double low_deg, double high_deg, int columns, bool column_wise) {
  PointChannels cloud;
  const int outer = column_wise ? columns : rings;
  const int inner = column_wise ? rings : columns;
  for (int o = 0; o < outer; ++o) {
    for (int i = 0; i < inner; ++i) {
      const int column = column_wise ? o : i;
      const int ring = column_wise ? i : o;
      const double azimuth_rad = kPi * (1.0 - 2.0 * (column + 0.5) / columns);
      const double elevation_rad = (low_deg + (high_deg - low_deg) * ring / (rings - 1)) * kRadPerDeg;
      add_point(cloud, azimuth_rad, elevation_rad, room_m(azimuth_rad, elevation_rad));
    }
  }
  return cloud;
}

/// A rosette of many petals in a cone about +x.
PointChannels rosette(double cone_deg, int points) {
  PointChannels cloud;
  for (int i = 0; i < points; ++i) {
    const double phase = 0.01 * i;
    const double off_rad = 0.5 * cone_deg * kRadPerDeg * std::abs(std::sin(phase));
    const double turn_rad = phase * 1.2345;
    const double azimuth_rad = off_rad * std::cos(turn_rad);
    const double elevation_rad = off_rad * std::sin(turn_rad);
    add_point(cloud, azimuth_rad, elevation_rad, room_m(azimuth_rad, elevation_rad));
  }
  return cloud;
}

template <typename Channel>
void permute(Channel& channel, const std::vector<std::size_t>& order) {
  const Channel old = channel;
  for (std::size_t i = 0; i < order.size(); ++i) {
    channel[i] = old[order[i]];
  }
}

bool has_note(const RecordingInfo& info, const std::string& part) {
  return std::any_of(info.odd.begin(), info.odd.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

RecordingInfo inspect_cloud(PointChannels channels) {
  const test::TempFolder folder;
  write_pcd(folder / "0.pcd", PointCloud(std::move(channels)).view());
  return inspect(Recording::open(folder.path()));
}

TEST(RecordingInfo, ColumnWiseSpinning) {
  const RecordingInfo info = inspect_cloud(spinning(16, -15.0, 15.0, 1800, true));
  EXPECT_EQ(info.order, FiringOrder::column_wise);
  EXPECT_EQ(info.rings.value().count, 16);
  EXPECT_FALSE(info.rings->from_field);
  EXPECT_EQ(info.sensor.name, "Velodyne VLP-16");
  EXPECT_NEAR(info.turns_per_scan, 1.0, 0.01);
  ASSERT_TRUE(info.field_of_view);
  EXPECT_TRUE(info.field_of_view->full_turn);
  EXPECT_NEAR(info.field_of_view->elevation_min_rad, -15.0 * kRadPerDeg, 1e-4);
}

TEST(RecordingInfo, RingWiseSpinning) {
  const RecordingInfo info = inspect_cloud(spinning(32, -30.67, 10.67, 1000, false));
  EXPECT_EQ(info.order, FiringOrder::ring_wise);
  EXPECT_EQ(info.rings.value().count, 32);
  EXPECT_EQ(info.sensor.name, "Velodyne HDL-32E");
}

TEST(RecordingInfo, TheRingFieldIsBelieved) {
  PointChannels cloud = spinning(16, -15.0, 15.0, 500, true);
  for (std::size_t i = 0; i < cloud.x.size(); ++i) {
    cloud.ring.push_back(static_cast<std::uint16_t>(i % 16));
  }
  const RecordingInfo info = inspect_cloud(std::move(cloud));
  EXPECT_EQ(info.rings.value().count, 16);
  EXPECT_TRUE(info.rings->from_field);
  EXPECT_EQ(info.channels, (std::vector<std::string>{"xyz", "ring"}));
}

TEST(RecordingInfo, Rosette) {
  const RecordingInfo info = inspect_cloud(rosette(70.4, 30'000));
  EXPECT_EQ(info.order, FiringOrder::non_repeating);
  EXPECT_EQ(info.interleaved_lines, 1);
  EXPECT_TRUE(info.field_of_view.value().circular);
  EXPECT_FALSE(info.rings);
  EXPECT_EQ(info.sensor.name, "Livox Mid-70");
}

TEST(RecordingInfo, ShuffledPointsHaveNoOrderAndNoSensor) {
  PointChannels cloud = rosette(70.4, 30'000);
  std::vector<std::size_t> order(cloud.x.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i * 7919 % order.size();
  }
  permute(cloud.x, order);
  permute(cloud.y, order);
  permute(cloud.z, order);
  const RecordingInfo info = inspect_cloud(std::move(cloud));
  EXPECT_EQ(info.order, FiringOrder::unordered);
  EXPECT_EQ(info.sensor.name, "unknown");
  EXPECT_TRUE(has_note(info, "neighbours in the list are no neighbours"));
}

TEST(RecordingInfo, ASensorThatLooksBackwards) {
  PointChannels cloud = rosette(70.4, 30'000);
  for (std::size_t i = 0; i < cloud.x.size(); ++i) {
    cloud.x[i] = -cloud.x[i];
    cloud.y[i] = -cloud.y[i];
  }
  const RecordingInfo info = inspect_cloud(std::move(cloud));
  const FieldOfView& view = info.field_of_view.value();
  EXPECT_NEAR(view.azimuth_max_rad - view.azimuth_min_rad, 70.4 * kRadPerDeg, 0.02);
  EXPECT_EQ(info.sensor.name, "Livox Mid-70");
}

TEST(RecordingInfo, CountsWhatIsNoPoint) {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  PointChannels cloud;
  cloud.x = {0, 0, kInf, 1, kNan, 2, 2, 3, 4, 5};
  cloud.y = {0, 0, kInf, kNan, kNan, 0, 0, 0, 0, -kInf};
  cloud.z = {0, 0, kInf, 1, kNan, 0, 0, 0, 0, 0};
  const RecordingInfo info = inspect_cloud(std::move(cloud));
  EXPECT_DOUBLE_EQ(info.no_return_zero_share, 0.2);
  EXPECT_DOUBLE_EQ(info.no_return_inf_share, 0.2);
  EXPECT_DOUBLE_EQ(info.nan_share, 0.2);
  EXPECT_DOUBLE_EQ(info.duplicate_share, 0.1);
  EXPECT_EQ(info.range_m.value().min, 2.0);
  EXPECT_EQ(info.range_m->max, 4.0);
  EXPECT_EQ(info.order, FiringOrder::unknown);
  EXPECT_FALSE(info.field_of_view);
  EXPECT_TRUE(has_note(info, "20 % of the points are NaN"));
}

TEST(RecordingInfo, NoReturnsThatWereMovedShowWhereTheSensorIs) {
  PointChannels cloud = rosette(38.4, 30'000);
  for (std::size_t i = 0; i < cloud.x.size(); ++i) {
    const float keep = i % 5 == 0 ? 0.0F : 1.0F;
    cloud.x[i] = cloud.x[i] * keep + 10.0F;
    cloud.y[i] = cloud.y[i] * keep + 0.5F;
    cloud.z[i] = cloud.z[i] * keep - 0.25F;
  }
  const RecordingInfo info = inspect_cloud(std::move(cloud));
  ASSERT_TRUE(info.repeated_point);
  EXPECT_EQ(info.repeated_point->position_m, (std::array<float, 3>{10.0F, 0.5F, -0.25F}));
  EXPECT_DOUBLE_EQ(info.repeated_point->share, 0.2);
  EXPECT_EQ(info.duplicate_share, 0.0);
  EXPECT_EQ(info.sensor.name, "Livox Mid-40");
  EXPECT_TRUE(has_note(info, "not the frame of the sensor"));
}

TEST(RecordingInfo, IntensitiesOfTheWrongUnit) {
  const auto with_intensity = [](float a, float b) {
    PointChannels cloud;
    cloud.x = cloud.y = cloud.z = {1.0F, 2.0F};
    cloud.intensity = {a, b};
    return inspect_cloud(std::move(cloud));
  };
  EXPECT_TRUE(has_note(with_intensity(0, 0), "all intensities are 0"));
  EXPECT_TRUE(has_note(with_intensity(0, 0.5F), "stay within 0..1"));
  EXPECT_TRUE(has_note(with_intensity(0, 4096), "intensities reach 4096"));
  EXPECT_FALSE(has_note(with_intensity(0, 255), "intensities"));
}

TEST(RecordingInfo, PointsAtTheEndsOfFloat) {
  constexpr float kMax = std::numeric_limits<float>::max();
  constexpr float kTiny = std::numeric_limits<float>::denorm_min();
  PointChannels cloud;
  for (int i = 0; i < 2000; ++i) {
    cloud.x.push_back(i % 3 == 0 ? kMax : kTiny);
    cloud.y.push_back(i % 2 == 0 ? -kMax : kTiny);
    cloud.z.push_back(i % 5 == 0 ? kMax : -kTiny);
    cloud.intensity.push_back(i % 7 == 0 ? kMax : -kMax);
    cloud.time.push_back(i % 2 == 0 ? std::numeric_limits<float>::quiet_NaN() : 0.0F);
  }
  EXPECT_EQ(inspect_cloud(std::move(cloud)).points, 2000U);
}

TEST(RecordingInfo, EmptyOnePointAllTheSame) {
  EXPECT_TRUE(has_note(inspect_cloud({}), "1 scans hold no points"));
  PointChannels one;
  one.x = one.y = one.z = {1.0F};
  EXPECT_EQ(inspect_cloud(std::move(one)).points_per_scan.median, 1.0);
  PointChannels same;
  same.x = same.y = same.z = std::vector<float>(5000, 3.0F);
  const RecordingInfo info = inspect_cloud(std::move(same));
  EXPECT_DOUBLE_EQ(info.repeated_point.value().share, 1.0);
  EXPECT_FALSE(info.range_m);
}

TEST(RecordingInfo, BrokenScansLabelsAndPosesAreCountedAndNamed) {
  const test::TempFolder folder;
  fs::create_directories(folder / "scans");
  fs::create_directories(folder / "labels");
  for (int i = 0; i < 6; ++i) {
    PointChannels cloud;
    cloud.x = cloud.y = cloud.z = {1.0F, 2.0F};
    write_pcd(folder / ("scans/" + std::to_string(i) + ".pcd"), PointCloud(std::move(cloud)).view());
  }
  test::spill(folder / "scans/2.pcd", "no scan");
  write_labels(folder / "labels/0.label", std::vector<std::uint32_t>{40, 0x0001'0046});
  write_labels(folder / "labels/1.label", std::vector<std::uint32_t>{40});
  test::spill(folder / "gnss.tum", "what?\n");
  test::spill(folder / "truth.tum", "0 0 0 0 0 0 0 1\n1 3 4 0 0 0 0 1\n");
  test::spill(folder / "times.txt", "0\n0.1\n0.2\n0.3\n0.4\n0.9\n");
  const RecordingInfo info = inspect(Recording::open(folder.path()));
  EXPECT_EQ(info.scans, 6U);
  EXPECT_EQ(info.scans_read, 5U);
  EXPECT_EQ(info.scans_failed, 1U);
  EXPECT_EQ(info.labelled_scans, 1U);
  ASSERT_EQ(info.truth_classes.size(), 2U);
  EXPECT_EQ(info.truth_classes[1].id, 70U);
  EXPECT_FALSE(info.given_poses);
  EXPECT_EQ(info.truth_poses.value().length_m, 5.0);
  EXPECT_NEAR(info.rate_hz.value(), 10.0, 1e-9);
  EXPECT_TRUE(has_note(info, "2.pcd"));
  EXPECT_TRUE(has_note(info, "1 of 6 scans cannot be read"));
  EXPECT_TRUE(has_note(info, "1.label"));
  EXPECT_TRUE(has_note(info, "gnss.tum: line 1"));
  EXPECT_TRUE(has_note(info, "the longest step from scan to scan is 0.5 s"));
}

TEST(RecordingInfo, ALogOfPosesIsShownAsPoses) {
  const test::TempFolder folder;
  fs::create_directories(folder / "scans");
  PointChannels cloud;
  cloud.x = cloud.y = cloud.z = {1.0F};
  write_pcd(folder / "scans/0.pcd", PointCloud(std::move(cloud)).view());
  const std::string header = "t,x,y,z,roll_deg,pitch_deg,yaw_deg\n";
  test::spill(folder / "gnss.csv", header + "0,0,0,0,0,0,0\n1,3,4,0,0,0,0\n2,,,,0,0,0\n");
  const PosesInfo poses = inspect(Recording::open(folder.path())).given_poses.value();
  EXPECT_EQ(poses.file, "gnss.csv");
  EXPECT_EQ(poses.count, 2U);
  EXPECT_EQ(poses.length_m, 5.0);
  test::spill(folder / "gnss.csv", header + "2,,,,0,0,0\n");
  EXPECT_TRUE(has_note(inspect(Recording::open(folder.path())), "holds no pose: 1 records"));
  test::spill(folder / "gnss.csv", "what?\n");
  const RecordingInfo broken = inspect(Recording::open(folder.path()));
  EXPECT_FALSE(broken.given_poses);
  EXPECT_TRUE(has_note(broken, "gnss.csv: line 1"));
}

TEST(RecordingInfo, LooksIntoTheScansThatWereAskedFor) {
  const test::TempFolder folder;
  for (int i = 0; i < 5; ++i) {
    PointChannels cloud;
    cloud.x = cloud.y = cloud.z = std::vector<float>(static_cast<std::size_t>(i), 1.0F);
    write_pcd(folder / (std::to_string(i) + ".pcd"), PointCloud(std::move(cloud)).view());
  }
  const Recording recording = Recording::open(folder.path());
  std::vector<std::size_t> steps;
  const RecordingInfo info = inspect(
      recording, {.first = 3, .count = 9, .progress = [&](std::size_t done, std::size_t) { steps.push_back(done); }});
  EXPECT_EQ(info.scans, 5U);
  EXPECT_EQ(info.scans_read, 2U);
  EXPECT_EQ(info.points, 7U);
  EXPECT_EQ(steps, (std::vector<std::size_t>{1, 2}));
  EXPECT_THROW((void)inspect(recording, {.first = 5, .count = {}, .progress = {}}), Error);
}

struct Expected {
  const char* name;
  const char* sensor;
  FiringOrder order;
  int rings;
  const char* note;
};

class RealRecordingInfo : public ::testing::TestWithParam<Expected> {};

TEST_P(RealRecordingInfo, IsRight) {
  const Expected& expected = GetParam();
  BERM_NEED_DATA(folder, expected.name);
  const RecordingInfo info = inspect(Recording::open(folder), {.first = 0, .count = 3, .progress = {}});
  EXPECT_EQ(info.sensor.name, expected.sensor);
  EXPECT_EQ(info.order, expected.order);
  EXPECT_EQ(info.rings.value_or(RingCount{}).count, expected.rings);
  EXPECT_TRUE(*expected.note == 0 || has_note(info, expected.note)) << expected.note;
}

INSTANTIATE_TEST_SUITE_P(
    All, RealRecordingInfo,
    ::testing::Values(
        Expected{"kitti00", "Velodyne HDL-64E", FiringOrder::ring_wise, 64, "truth labels for 8 of 16 scans"},
        Expected{"wads36", "Hesai Pandar64", FiringOrder::column_wise, 64, "two returns per beam"},
        Expected{"livox_horizon", "Livox Horizon", FiringOrder::non_repeating, 0, "2 numbers are missing"},
        Expected{"livox_vehicle", "Livox Horizon", FiringOrder::non_repeating, 0, "exactly at (10.15, 0.555, -0.15)"},
        Expected{"livox_mid40", "Livox Mid-40", FiringOrder::non_repeating, 0, "all intensities are 0"},
        Expected{"livox_mid360", "Livox Mid-360", FiringOrder::non_repeating, 0, ""},
        Expected{"hdl32_rings", "Velodyne HDL-32E", FiringOrder::column_wise, 32, "a scan turns by 401 deg"},
        Expected{"per_point_time", "Hesai Pandar64", FiringOrder::column_wise, 61, ""}),
    [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace berm
