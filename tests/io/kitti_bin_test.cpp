#include "berm/io/kitti_bin.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"
#include "support/file_error.hpp"
#include "support/random_points.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::expect_file_error;

const float kNan = std::numeric_limits<float>::quiet_NaN();

TEST(KittiBin, RoundTripKeepsEveryBit) {
  const test::TempFolder folder;
  EXPECT_TRUE(rc::check("bytes of any cloud survive", [&](std::uint32_t seed) {
    PointChannels channels = test::random_points(seed % 3000, seed, test::ChannelSet{.intensity = true});
    const PointCloud cloud(channels);
    write_kitti_bin(folder / "scan.bin", cloud.view(), IntensityScale::byte);
    const ScanRecord record = read_kitti_bin(folder / "scan.bin", IntensityScale::byte);
    RC_ASSERT(test::same_bits(record.channels.x, channels.x));
    RC_ASSERT(test::same_bits(record.channels.y, channels.y));
    RC_ASSERT(test::same_bits(record.channels.z, channels.z));
    RC_ASSERT(test::same_bits(record.channels.intensity, channels.intensity));
  }));
}

TEST(KittiBin, ScalesUnitIntensity) {
  const test::TempFolder folder;
  const std::vector<float> zero = {0.0F, 0.0F};
  const std::vector<float> intensity = {255.0F, 51.0F};
  write_kitti_bin(folder / "scan.bin", {.x = zero, .y = zero, .z = zero, .intensity = intensity}, IntensityScale::unit);
  const ScanRecord raw = read_kitti_bin(folder / "scan.bin", IntensityScale::byte);
  EXPECT_FLOAT_EQ(raw.channels.intensity.at(0), 1.0F);
  EXPECT_FLOAT_EQ(raw.channels.intensity.at(1), 0.2F);
  const ScanRecord scaled = read_kitti_bin(folder / "scan.bin", IntensityScale::unit);
  EXPECT_FLOAT_EQ(scaled.channels.intensity.at(0), 255.0F);
  EXPECT_FLOAT_EQ(scaled.channels.intensity.at(1), 51.0F);
  EXPECT_NE(scaled.notes, raw.notes);
}

TEST(KittiBin, AbsentIntensityIsWrittenAsZero) {
  const test::TempFolder folder;
  const std::vector<float> one = {1.0F};
  write_kitti_bin(folder / "scan.bin", {.x = one, .y = one, .z = one}, IntensityScale::unit);
  EXPECT_EQ(read_kitti_bin(folder / "scan.bin", IntensityScale::byte).channels.intensity, std::vector<float>{0.0F});
}

TEST(KittiBin, RecognisesTheScale) {
  const auto recognise = [](std::vector<float> values) { return recognise_intensity_scale(values); };
  EXPECT_EQ(recognise({0.0F, 0.37F, 1.0F}), IntensityScale::unit);
  EXPECT_EQ(recognise({0.37F, 17.0F}), IntensityScale::byte);
  EXPECT_EQ(recognise({kNan, 2.0F}), IntensityScale::byte);
  // Nothing to tell by: another scan has to decide.
  EXPECT_EQ(recognise({}), std::nullopt);
  EXPECT_EQ(recognise({0.0F, 1.0F, kNan, -3.0F}), std::nullopt);
}

TEST(KittiBin, ReuseLeavesNothingOfTheScanBefore) {
  const test::TempFolder folder;
  const std::vector<float> one = {1.0F};
  write_kitti_bin(folder / "scan.bin", {.x = one, .y = one, .z = one}, IntensityScale::byte);
  PointChannels before = test::random_points(100, 1, test::ChannelSet::all());
  const float* const memory = before.x.data();
  ScanRecord record = read_kitti_bin(folder / "scan.bin", IntensityScale::byte, std::move(before));
  EXPECT_EQ(record.channels.x.data(), memory);
  const PointCloud cloud(std::move(record.channels));
  EXPECT_EQ(cloud.size(), 1U);
  EXPECT_TRUE(cloud.view().time.empty());
  EXPECT_TRUE(cloud.view().ring.empty());
  EXPECT_TRUE(cloud.view().label.empty());
}

TEST(KittiBin, RefusesBytesThatAreNoPoints) {
  const std::vector<std::byte> bytes(37);
  expect_file_error(ErrorCode::truncated, "scan.bin: at byte 32: 5 bytes left",
                    [&] { (void)parse_kitti_bin(bytes, "scan.bin", IntensityScale::byte); });
}

TEST(KittiBin, RefusesToWriteChannelsOfOtherLengths) {
  const test::TempFolder folder;
  const std::vector<float> one = {1.0F};
  const std::vector<float> two = {1.0F, 2.0F};
  EXPECT_THROW(write_kitti_bin(folder / "scan.bin", {.x = one, .y = two, .z = one}, IntensityScale::byte), Error);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace berm
