#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/io/pcd.hpp"

namespace berm {
namespace {

ScanRecord golden(const std::string& name) {
  return read_pcd(std::filesystem::path(__FILE__).parent_path() / "pcd" / name);
}

bool has_note(const ScanRecord& record, const std::string& part) {
  return std::any_of(record.notes.begin(), record.notes.end(),
                     [&](const std::string& note) { return note.find(part) != std::string::npos; });
}

class GoldenEncodings : public testing::TestWithParam<const char*> {};

TEST_P(GoldenEncodings, HoldTheSamePoints) {
  const ScanRecord record = golden(GetParam());
  EXPECT_EQ(record.channels.x, (std::vector<float>{1.5F, 10.0F, 0.0F}));
  EXPECT_EQ(record.channels.y, (std::vector<float>{-2.25F, 20.0F, 0.0F}));
  EXPECT_EQ(record.channels.z, (std::vector<float>{0.125F, -3.5F, 0.0F}));
  EXPECT_EQ(record.channels.intensity, (std::vector<float>{0.0F, 17.5F, 255.0F}));
  EXPECT_EQ(record.channels.ring, (std::vector<std::uint16_t>{0, 31, 5}));
  EXPECT_EQ(record.channels.time, (std::vector<float>{0.0F, 0.0625F, 0.09375F}));
  EXPECT_EQ(record.fields, (std::vector<std::string>{"x", "y", "z", "intensity", "ring", "time"}));
  EXPECT_FALSE(record.start_ns);
}

INSTANTIATE_TEST_SUITE_P(Pcd, GoldenEncodings,
                         testing::Values("all_ascii.pcd", "all_binary.pcd", "all_compressed_literals.pcd",
                                         "all_compressed_runs.pcd"));

TEST(GoldenPcd, CarriageReturnsCommentsAndNumbersThatAreNone) {
  const ScanRecord record = golden("quirks_crlf_ascii.pcd");
  ASSERT_EQ(record.channels.x.size(), 2U);
  EXPECT_EQ(record.channels.z[0], 3.0F);
  EXPECT_TRUE(std::isnan(record.channels.x[1]));
  EXPECT_EQ(record.channels.y[1], INFINITY);
  EXPECT_EQ(record.channels.z[1], -INFINITY);
  EXPECT_EQ(record.channels.intensity, (std::vector<float>{4.0F, 255.0F}));
  EXPECT_TRUE(has_note(record, "POINTS says 2"));
}

TEST(GoldenPcd, CarriageReturnsBeforeABinaryBody) {
  // The numbers hold the bytes of line ends: a reader that strips them from the body gets others.
  const ScanRecord record = golden("quirks_crlf_binary.pcd");
  EXPECT_EQ(record.channels.x, std::vector<float>{13.0F});
  EXPECT_EQ(record.channels.y, std::vector<float>{10.0F});
  EXPECT_EQ(record.channels.z, std::vector<float>{-1.0F});
}

TEST(GoldenPcd, PaddingAsPclWritesIt) {
  const ScanRecord record = golden("padding_binary.pcd");
  EXPECT_EQ(record.channels.x, (std::vector<float>{10.0F, 1.5F}));
  EXPECT_EQ(record.channels.intensity, (std::vector<float>{17.5F, 0.0F}));
  EXPECT_EQ(record.channels.ring, (std::vector<std::uint16_t>{31, 0}));
}

TEST(GoldenPcd, Hesai) {
  const ScanRecord record = golden("driver_hesai.pcd");
  EXPECT_EQ(record.start_ns, 1'635'236'489'000'000'000);
  EXPECT_EQ(record.channels.time, (std::vector<float>{0.0625F, 0.0F}));
  EXPECT_TRUE(has_note(record, "timestamp (F8), taken as absolute s"));
  EXPECT_TRUE(has_note(record, "run backwards at 1 points"));
}

TEST(GoldenPcd, Ouster) {
  const ScanRecord record = golden("driver_ouster.pcd");
  EXPECT_EQ(record.channels.time, (std::vector<float>{0.0F, 0.05F}));
  EXPECT_EQ(record.channels.intensity, (std::vector<float>{0.0F, 100.0F}));
  EXPECT_EQ(record.channels.ring, (std::vector<std::uint16_t>{0, 63}));
  EXPECT_TRUE(has_note(record, "t (U4), taken as ns since the stamp"));
  EXPECT_TRUE(has_note(record, "intensity comes from the field reflectivity"));
}

TEST(GoldenPcd, Livox) {
  const ScanRecord record = golden("driver_livox.pcd");
  EXPECT_EQ(record.channels.time, (std::vector<float>{0.0F, 1e-5F}));
  EXPECT_EQ(record.channels.intensity, (std::vector<float>{0.0F, 9.0F}));
  EXPECT_EQ(record.channels.ring, (std::vector<std::uint16_t>{0, 5}));
  EXPECT_TRUE(is_no_return(record.channels.x[0], record.channels.y[0], record.channels.z[0]));
}

TEST(GoldenPcd, Velodyne) {
  const ScanRecord record = golden("driver_velodyne.pcd");
  EXPECT_EQ(record.channels.x, (std::vector<float>{1.0F, 4.0F}));
  EXPECT_EQ(record.channels.time, (std::vector<float>{-0.1F, 0.0F}));
  EXPECT_EQ(record.channels.ring, (std::vector<std::uint16_t>{15, 0}));
  EXPECT_TRUE(has_note(record, "rounded to single precision"));
}

}  // namespace
}  // namespace berm
