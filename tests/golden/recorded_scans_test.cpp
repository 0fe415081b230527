// Facts about real recordings, found with a few lines of Python and none of our code.
#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/io/kitti_bin.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/pcd.hpp"
#include "support/data.hpp"
#include "support/file_error.hpp"

namespace berm {
namespace {

struct Facts {
  std::size_t points = 0;
  std::vector<float> first;  ///< x y z intensity
  std::vector<double> sums;  ///< of x y z intensity
  float max_intensity = 0.0F;
};

void expect_facts(const ScanRecord& record, const Facts& facts) {
  const std::vector<const std::vector<float>*> channels = {&record.channels.x, &record.channels.y, &record.channels.z,
                                                           &record.channels.intensity};
  for (std::size_t i = 0; i < channels.size(); ++i) {
    SCOPED_TRACE(i);
    ASSERT_EQ(channels[i]->size(), facts.points);
    EXPECT_EQ(channels[i]->front(), facts.first[i]);
    double sum = 0.0;
    for (const float value : *channels[i]) {
      sum += static_cast<double>(value);
    }
    EXPECT_NEAR(sum, facts.sums[i], 2e-3);
  }
  const auto& intensity = record.channels.intensity;
  EXPECT_EQ(*std::max_element(intensity.begin(), intensity.end()), facts.max_intensity);
}

std::size_t no_returns(const ScanRecord& record) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < record.channels.x.size(); ++i) {
    count += is_no_return(record.channels.x[i], record.channels.y[i], record.channels.z[i]) ? 1U : 0U;
  }
  return count;
}

std::map<std::uint32_t, std::size_t> count_classes(const std::vector<std::uint32_t>& labels) {
  std::map<std::uint32_t, std::size_t> counts;
  for (const std::uint32_t label : labels) {
    ++counts[semantic_class(label)];
  }
  return counts;
}

TEST(RecordedScans, KittiBin) {
  BERM_NEED_DATA(path, "kitti00/velodyne/000000.bin");
  const ScanRecord record = read_kitti_bin(path, IntensityScale::byte);
  expect_facts(record, {124668,
                        {52.89794158935547F, 0.02298973873257637F, 1.9979945421218872F, 0.07999999821186066F},
                        {-178942.814, 127768.874, -150940.371, 36669.1},
                        0.99F});
  EXPECT_EQ(recognise_intensity_scale(record.channels.intensity), IntensityScale::unit);
}

TEST(RecordedScans, KittiLabels) {
  BERM_NEED_DATA(path, "kitti00/labels/000000.label");
  const std::vector<std::uint32_t> labels = read_labels(path, 124668);
  EXPECT_EQ(count_classes(labels), (std::map<std::uint32_t, std::size_t>{{0, 74890},
                                                                         {10, 1918},
                                                                         {32, 42},
                                                                         {40, 15814},
                                                                         {44, 1328},
                                                                         {48, 11909},
                                                                         {50, 6340},
                                                                         {51, 122},
                                                                         {70, 10499},
                                                                         {71, 520},
                                                                         {72, 968},
                                                                         {80, 270},
                                                                         {81, 48}}));
  test::expect_file_error(ErrorCode::malformed, "124668 labels for a scan of 124667 points",
                          [&] { (void)read_labels(path, 124667); });
}

TEST(RecordedScans, WadsBinAndLabels) {
  BERM_NEED_DATA(path, "wads36/velodyne/042223.bin");
  const ScanRecord record = read_kitti_bin(path, IntensityScale::byte);
  expect_facts(record, {209297,
                        {-0.05890781804919243F, 3.402048349380493F, 0.9016634225845337F, 0.0F},
                        {-62972.891, 699192.768, -127883.757, 2475330.0},
                        255.0F});
  EXPECT_EQ(recognise_intensity_scale(record.channels.intensity), IntensityScale::byte);
  BERM_NEED_DATA(label_path, "wads36/labels/042223.label");
  const auto counts = count_classes(read_labels(label_path, record.channels.x.size()));
  EXPECT_EQ(counts.at(110), 10422U);
  EXPECT_EQ(counts.at(111), 84933U);
}

TEST(RecordedScans, LivoxAsciiWithNoReturns) {
  BERM_NEED_DATA(path, "livox_horizon/1.pcd");
  const ScanRecord record = read_pcd(path);
  expect_facts(record, {23986, {19.003F, -6.559F, 1.052F, 3.0F}, {296486.528, 10931.632, 2106.775, 236332.0}, 255.0F});
  EXPECT_EQ(no_returns(record), 8619U);
  BERM_NEED_DATA(mid360, "livox_mid360/20240509061326.pcd");
  const ScanRecord dome = read_pcd(mid360);
  expect_facts(dome, {19965, {0.314F, -0.478F, 0.285F, 10.0F}, {1519.727, 6475.828, 8846.937, 552202.0}, 170.0F});
  EXPECT_EQ(no_returns(dome), 5750U);
}

TEST(RecordedScans, HeaderWithZeroWidth) {
  BERM_NEED_DATA(path, "livox_mid40/10.pcd");
  const ScanRecord record = read_pcd(path);
  expect_facts(record, {240887, {29.292F, -2.742F, 6.879F, 0.0F}, {3332142.076, -76647.923, 237713.398, 0.0}, 0.0F});
  ASSERT_FALSE(record.notes.empty());
  EXPECT_EQ(record.notes.front(), "WIDTH 0 and HEIGHT 0 were ignored, POINTS says 240887");
}

TEST(RecordedScans, PaddedRecordsWithRings) {
  BERM_NEED_DATA(path, "hdl32_rings/50.pcd");
  const ScanRecord record = read_pcd(path);
  expect_facts(record, {63657,
                        {0.5012618899345398F, 4.136155605316162F, -2.470889091491699F, 3.0F},
                        {-339.077, 124162.533, -82642.228, 780036.0},
                        119.0F});
  std::uint64_t rings = 0;
  for (const std::uint16_t ring : record.channels.ring) {
    rings += ring;
  }
  EXPECT_EQ(rings, 937165U);
}

TEST(RecordedScans, CompressedWithAbsoluteTime) {
  BERM_NEED_DATA(path, "per_point_time/2021-10-26-16-21-29-468.pcd");
  const ScanRecord record = read_pcd(path);
  ASSERT_EQ(record.channels.time.size(), 80787U);
  EXPECT_EQ(record.start_ns, 1'635'236'489'369'081'974);
  double times_s = 0.0;
  for (const float time : record.channels.time) {
    times_s += static_cast<double>(time);
  }
  EXPECT_NEAR(times_s, 4326.845925807953, 1e-3);
  EXPECT_TRUE(std::is_sorted(record.channels.time.begin(), record.channels.time.end()));
  EXPECT_EQ(*std::max_element(record.channels.ring.begin(), record.channels.ring.end()), 60);
  EXPECT_EQ(record.channels.x.front(), -5.927565574645996F);
}

TEST(RecordedScans, ThreeFloatsAPointAreNoKittiScan) {
  BERM_NEED_DATA(path, "deskew/raw_00.bin");
  test::expect_file_error(ErrorCode::truncated, "12 bytes left for a point of 16",
                          [&] { (void)read_kitti_bin(path, IntensityScale::byte); });
}

}  // namespace
}  // namespace berm
