#include "berm/core/point_cloud.hpp"

#include <limits>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/core/scan.hpp"

namespace berm {
namespace {

PointChannels filled(std::size_t points) {
  return {.x = std::vector<float>(points, 1.0F),
          .y = std::vector<float>(points, 2.0F),
          .z = std::vector<float>(points, 3.0F),
          .intensity = std::vector<float>(points, 4.0F),
          .time = std::vector<float>(points, 5.0F),
          .ring = std::vector<std::uint16_t>(points, 65535),
          .label = std::vector<Label>(points, Label::terrain)};
}

/// The message with which a cloud refuses `channels`; empty if it takes them.
std::string complaint(PointChannels channels) {
  try {
    const PointCloud cloud(std::move(channels));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    return error.what();
  }
  return {};
}

TEST(PointCloud, IsEmptyByDefault) {
  const PointCloud cloud;
  EXPECT_TRUE(cloud.empty());
  EXPECT_EQ(cloud.size(), 0U);
  EXPECT_TRUE(cloud.view().empty());
  EXPECT_TRUE(cloud.view().label.empty());
}

TEST(PointCloud, ShowsEveryChannel) {
  const PointCloud cloud(filled(3));
  const PointsView view = cloud.view();
  ASSERT_EQ(view.size(), 3U);
  EXPECT_EQ(view.x[2], 1.0F);
  EXPECT_EQ(view.y[2], 2.0F);
  EXPECT_EQ(view.z[2], 3.0F);
  EXPECT_EQ(view.intensity[2], 4.0F);
  EXPECT_EQ(view.time[2], 5.0F);
  EXPECT_EQ(view.ring[2], 65535);
  EXPECT_EQ(view.label[2], Label::terrain);
}

TEST(PointCloud, KeepsAbsentChannelsEmpty) {
  PointChannels channels;
  channels.x = channels.y = channels.z = {1.0F, 2.0F};
  const PointCloud cloud(std::move(channels));
  EXPECT_EQ(cloud.size(), 2U);
  EXPECT_TRUE(cloud.view().intensity.empty());
  EXPECT_TRUE(cloud.view().time.empty());
  EXPECT_TRUE(cloud.view().ring.empty());
  EXPECT_TRUE(cloud.view().label.empty());
}

TEST(PointCloud, RefusesChannelsOfAnotherLength) {
  const auto with = [](auto PointChannels::*channel, std::size_t length) {
    PointChannels channels = filled(3);
    (channels.*channel).resize(length);
    return complaint(std::move(channels));
  };
  for (const std::size_t length : {1U, 2U, 4U}) {
    EXPECT_NE(with(&PointChannels::x, length), "");
    EXPECT_NE(with(&PointChannels::y, length), "");
    EXPECT_NE(with(&PointChannels::z, length), "");
    EXPECT_NE(with(&PointChannels::intensity, length), "");
    EXPECT_NE(with(&PointChannels::time, length), "");
    EXPECT_NE(with(&PointChannels::ring, length), "");
    EXPECT_NE(with(&PointChannels::label, length), "");
  }
  EXPECT_NE(with(&PointChannels::x, 0), "") << "intensities of no points";
  EXPECT_NE(with(&PointChannels::y, 0), "") << "y is not optional";
  EXPECT_NE(with(&PointChannels::z, 0), "") << "z is not optional";
  EXPECT_EQ(with(&PointChannels::ring, 0), "");
}

TEST(PointCloud, NamesTheChannelThatIsWrong) {
  PointChannels channels = filled(3);
  channels.time.resize(2);
  EXPECT_EQ(complaint(std::move(channels)), "point cloud: channel time has 2 values for 3 points");
}

TEST(PointCloud, GivesItsMemoryBack) {
  PointCloud cloud(filled(1000));
  const float* memory = cloud.view().x.data();
  PointChannels channels = std::move(cloud).release();
  EXPECT_EQ(channels.x.data(), memory);
  channels.clear();
  EXPECT_TRUE(channels.x.empty());
  EXPECT_TRUE(channels.ring.empty());
  EXPECT_GE(channels.x.capacity(), 1000U);
  EXPECT_EQ(cloud.size(), 0U);  // NOLINT(bugprone-use-after-move): release() promises an empty cloud
}

TEST(IsNoReturn, KnowsWhatDriversSend) {
  constexpr float kInf = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_TRUE(is_no_return(0.0F, 0.0F, 0.0F));
  EXPECT_TRUE(is_no_return(-0.0F, 0.0F, -0.0F));
  EXPECT_TRUE(is_no_return(kInf, kInf, kInf));
  EXPECT_TRUE(is_no_return(-kInf, 1.0F, 1.0F));
  EXPECT_TRUE(is_no_return(1.0F, kInf, 1.0F));
  EXPECT_TRUE(is_no_return(1.0F, 1.0F, -kInf));
  EXPECT_FALSE(is_no_return(kNan, kNan, kNan)) << "a bad point, not a missing one (REP-117)";
  EXPECT_FALSE(is_no_return(1.0F, 0.0F, 0.0F));
  EXPECT_FALSE(is_no_return(std::numeric_limits<float>::denorm_min(), 0.0F, 0.0F));
  EXPECT_FALSE(is_no_return(std::numeric_limits<float>::max(), 0.0F, 0.0F));
}

TEST(Scan, StartsAtTheOriginOfTimeAndSpace) {
  const Scan scan;
  EXPECT_EQ(scan.stamp_ns, 0);
  EXPECT_TRUE(scan.cloud.empty());
  EXPECT_TRUE(scan.T_base_sensor.matrix().isIdentity());
}

}  // namespace
}  // namespace berm
