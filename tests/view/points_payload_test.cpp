#include "berm/view/points_payload.hpp"

#include <cstring>
#include <limits>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace berm {
namespace {

template <typename Number>
Number number_at(const std::string& bytes, std::size_t offset) {
  Number value{};
  std::memcpy(&value, bytes.data() + offset, sizeof(value));
  return value;
}

PointChannels three_points() {
  PointChannels channels;
  channels.x = {1.0F, 2.0F, 3.0F};
  channels.y = {0.0F, 0.0F, 0.0F};
  channels.z = {0.5F, 0.5F, 0.5F};
  return channels;
}

TEST(PointsPayload, HoldsSixteenBytesAPointInTheFrameOfTheBase) {
  PointChannels channels = three_points();
  channels.intensity = {0.0F, 127.6F, 300.0F};
  channels.label = {Label::drivable, Label::terrain, Label::obstacle};
  channels.time = {0.0F, 0.05F, 0.1F};
  channels.ring = {0, 7, 400};
  // A quarter turn to the left: x becomes y.
  const Pose T_base_sensor = Pose::from_yaw_pitch_roll(std::numbers::pi / 2.0, 0.0, 0.0, {0.0, 0.0, 2.0});
  const std::string payload = make_points_payload(PointCloud(std::move(channels)).view(), T_base_sensor);

  ASSERT_EQ(payload.size(), 16U + 3U * 16U);
  EXPECT_EQ(payload.substr(0, 4), "BRM1");
  EXPECT_EQ(number_at<std::uint32_t>(payload, 4), 3U);
  EXPECT_EQ(number_at<float>(payload, 8), 0.0F);
  EXPECT_EQ(number_at<std::uint32_t>(payload, 12), 15U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(number_at<float>(payload, 16 + 4 * i), 0.0F, 1e-6F);
    EXPECT_NEAR(number_at<float>(payload, 28 + 4 * i), static_cast<float>(i + 1), 1e-6F);
    EXPECT_NEAR(number_at<float>(payload, 40 + 4 * i), 2.5F, 1e-6F);
  }
  EXPECT_EQ(payload.substr(52, 3), std::string("\0\x80\xFF", 3));
  EXPECT_EQ(payload.substr(55, 3), std::string("\3\4\5", 3));
  EXPECT_EQ(payload.substr(58, 3), std::string("\0\x80\xFF", 3));
  EXPECT_EQ(payload.substr(61, 3), std::string("\0\7\xFF", 3));
}

TEST(PointsPayload, SaysWhichChannelsAreThere) {
  PointChannels channels = three_points();
  EXPECT_EQ(number_at<std::uint32_t>(make_points_payload(PointCloud(channels).view(), {}), 12), 0U);
  channels.time = {0.0F, 0.0F, 0.0F};
  const std::string payload = make_points_payload(PointCloud(channels).view(), {});
  EXPECT_EQ(number_at<std::uint32_t>(payload, 12), std::uint32_t{kPayloadTime});
  EXPECT_EQ(payload.substr(52), std::string(12, '\0'));
}

TEST(PointsPayload, LeavesOutWhatCannotBeDrawn) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kMax = std::numeric_limits<float>::max();
  PointChannels channels;
  channels.x = {0.0F, kNan, 1.0F, 1.0F, kMax, 4.0F};
  channels.y = {0.0F, 1.0F, -kInf, 1.0F, 0.0F, 5.0F};
  channels.z = {0.0F, 1.0F, 1.0F, kNan, 0.0F, 6.0F};
  channels.intensity = {1.0F, 1.0F, 1.0F, 1.0F, 1.0F, kNan};
  const std::string payload = make_points_payload(PointCloud(channels).view(), {});
  ASSERT_EQ(payload.size(), 32U);
  EXPECT_EQ(number_at<float>(payload, 16), 4.0F);
  EXPECT_EQ(number_at<float>(payload, 24), 6.0F);
  EXPECT_EQ(payload[28], '\0');
  EXPECT_EQ(make_points_payload(PointsView(), {}).size(), 16U);
}

}  // namespace
}  // namespace berm
