#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"
#include "berm/io/pcd.hpp"
#include "support/random_points.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

constexpr PcdEncoding kEncodings[] = {PcdEncoding::ascii, PcdEncoding::binary, PcdEncoding::binary_compressed};

class PcdRoundTrip : public testing::TestWithParam<PcdEncoding> {};

TEST_P(PcdRoundTrip, KeepsEveryChannelOfAnyCloud) {
  const test::TempFolder folder;
  EXPECT_TRUE(rc::check("what is written reads back", [&](std::uint32_t seed, bool large) {
    const std::size_t points = seed % (large ? 3000 : 5);
    // Seeds grow slowly; spread their bits so that all combinations of channels come up.
    const auto set = test::ChannelSet::from_bits((seed * 2654435761U) >> 28U);
    const PointChannels channels = test::random_points(points, seed, set);
    const PointCloud cloud(channels);
    write_pcd(folder / "scan.pcd", cloud.view(), GetParam());
    const ScanRecord record = read_pcd(folder / "scan.pcd");
    const bool text = GetParam() == PcdEncoding::ascii;
    const auto same = [&](const std::vector<float>& a, const std::vector<float>& b) {
      return text ? test::same_values(a, b) : test::same_bits(a, b);
    };
    RC_ASSERT(same(record.channels.x, channels.x));
    RC_ASSERT(same(record.channels.y, channels.y));
    RC_ASSERT(same(record.channels.z, channels.z));
    RC_ASSERT(same(record.channels.intensity, channels.intensity));
    RC_ASSERT(same(record.channels.time, channels.time));
    RC_ASSERT(record.channels.ring == channels.ring);
    RC_ASSERT(record.channels.label == channels.label);
    RC_ASSERT(!record.start_ns);
  }));
}

TEST_P(PcdRoundTrip, SameCloudGivesTheSameBytes) {
  const test::TempFolder folder;
  const PointCloud cloud(test::random_points(20'000, 7, test::ChannelSet::all()));
  const PointCloud other(test::random_points(20'000, 8, test::ChannelSet::all()));
  write_pcd(folder / "a.pcd", cloud.view(), GetParam());
  write_pcd(folder / "other.pcd", other.view(), GetParam());
  write_pcd(folder / "b.pcd", cloud.view(), GetParam());
  EXPECT_EQ(test::slurp(folder / "a.pcd"), test::slurp(folder / "b.pcd"));
}

TEST_P(PcdRoundTrip, EmptyCloud) {
  const test::TempFolder folder;
  write_pcd(folder / "scan.pcd", PointsView{}, GetParam());
  const ScanRecord record = read_pcd(folder / "scan.pcd");
  EXPECT_TRUE(record.channels.x.empty());
  EXPECT_EQ(record.fields, (std::vector<std::string>{"x", "y", "z"}));
}

TEST_P(PcdRoundTrip, ReuseLeavesNothingOfTheScanBefore) {
  const test::TempFolder folder;
  const PointCloud cloud(test::random_points(10, 3, {}));
  write_pcd(folder / "scan.pcd", cloud.view(), GetParam());
  PointChannels before = test::random_points(1000, 4, test::ChannelSet::all());
  const float* const memory = before.x.data();
  ScanRecord record = read_pcd(folder / "scan.pcd", std::move(before));
  EXPECT_EQ(record.channels.x.data(), memory);
  const PointCloud again(std::move(record.channels));
  EXPECT_EQ(again.size(), 10U);
  EXPECT_TRUE(again.view().intensity.empty());
  EXPECT_TRUE(again.view().time.empty());
  EXPECT_TRUE(again.view().ring.empty());
  EXPECT_TRUE(again.view().label.empty());
}

std::string encoding_name(const testing::TestParamInfo<PcdEncoding>& encoding) {
  constexpr const char* kNames[] = {"ascii", "binary", "binary_compressed"};
  return kNames[static_cast<std::size_t>(encoding.param)];
}

INSTANTIATE_TEST_SUITE_P(Encodings, PcdRoundTrip, testing::ValuesIn(kEncodings), encoding_name);

TEST(PcdWrite, NoReturnLabelsReadBackAsUnlabeled) {
  const test::TempFolder folder;
  const std::vector<float> zero = {0.0F};
  const std::vector<Label> label = {Label::no_return};
  write_pcd(folder / "scan.pcd", {.x = zero, .y = zero, .z = zero, .label = label});
  EXPECT_EQ(read_pcd(folder / "scan.pcd").channels.label, std::vector<Label>{Label::unlabeled});
}

TEST(PcdWrite, HeaderIsWhatOtherProgramsExpect) {
  const test::TempFolder folder;
  const PointCloud cloud(test::random_points(2, 3, test::ChannelSet::all()));
  write_pcd(folder / "scan.pcd", cloud.view());
  const std::string expected =
      "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z intensity ring time label\n"
      "SIZE 4 4 4 4 2 4 4\nTYPE F F F F U F U\nCOUNT 1 1 1 1 1 1 1\nWIDTH 2\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\n"
      "POINTS 2\nDATA binary\n";
  const std::string content = test::slurp(folder / "scan.pcd");
  EXPECT_EQ(content.substr(0, expected.size()), expected);
  EXPECT_EQ(content.size(), expected.size() + 2 * 26);
}

TEST(PcdWrite, RefusesChannelsOfOtherLengths) {
  const test::TempFolder folder;
  const std::vector<float> one = {1.0F};
  const std::vector<float> two = {1.0F, 2.0F};
  EXPECT_THROW(write_pcd(folder / "scan.pcd", {.x = one, .y = one, .z = two}), Error);
  EXPECT_THROW(write_pcd(folder / "scan.pcd", {.x = one, .y = one, .z = one, .time = two}), Error);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace berm
