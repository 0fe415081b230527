#include "berm/edge/ring_edges.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "edge/road_scene.hpp"

namespace berm {
namespace {

std::vector<EdgePoint> find(const test::RoadScan& scan, const RingEdgesConfig& config = {}) {
  RingEdges edges(config);
  const EdgeResult result = edges.process(scan.input());
  return {result.edges.begin(), result.edges.end()};
}

TEST(RingEdges, MarkThatRingsAreCompressedOnABerm) {
  const std::vector<EdgePoint> found = find(test::scan_road(test::road_between_berms(8.0, 2.0)));
  ASSERT_GT(found.size(), 50U);
  for (const EdgePoint& edge : found) {
    EXPECT_GT(std::abs(edge.y_m), 7.0F);
    EXPECT_EQ(edge.side == EdgeSide::left, edge.y_m > 0.0F) << edge.x_m << ' ' << edge.y_m;
  }
}

TEST(RingEdges, SeeNoneOnALevelPlain) {
  EXPECT_TRUE(find(test::scan_road([](double, double) { return 0.0; })).empty());
}

TEST(RingEdges, CallWhatIsFlatPlain) {
  const test::RoadScan scan = test::scan_road(test::road_between_berms(8.0, 2.0));
  RingEdges edges({});
  const EdgeResult result = edges.process(scan.input());
  ASSERT_GT(result.plain.size(), 1000U);
  const auto on_road = std::count_if(result.plain.begin(), result.plain.end(),
                                     [&](std::uint32_t i) { return std::abs(scan.channels.y[i]) < 8.0F; });
  EXPECT_GT(on_road, 1000);
}

TEST(RingEdges, GetRingsByElevationWhereTheScanHasNone) {
  test::RoadScan scan = test::scan_road(test::road_between_berms(8.0, 2.0));
  RingEdgesConfig config;
  const std::vector<EdgePoint> by_channel = find(scan, config);
  scan.channels.ring.clear();
  const std::vector<EdgePoint> by_elevation = find(scan);
  ASSERT_EQ(by_channel.size(), by_elevation.size());
}

TEST(RingEdges, SayWhatIsWrongWithTheirSettings) {
  RingEdgesConfig config;
  config.alpha = 0.8;
  EXPECT_THROW(RingEdges{config}, ConfigError);
  config = {};
  config.sectors = 3;
  EXPECT_THROW(RingEdges{config}, ConfigError);
}

}  // namespace
}  // namespace berm
