// Both methods on scans that go wrong on real machines. Whatever arrives: no crash, edges that are numbers, and the
// same again when it arrives again.

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/edge/ring_edges.hpp"
#include "berm/edge/trace_edges.hpp"
#include "edge/road_scene.hpp"

namespace berm {
namespace {

const test::RoadScan& good_scan() {
  static const test::RoadScan scan = test::scan_road(test::road_between_berms(7.0, 1.0));
  return scan;
}

struct BadScan {
  std::string name;
  std::function<void(test::RoadScan&)> spoil;
};

void keep_first(test::RoadScan& scan, std::size_t count) {
  for (auto* channel : {&scan.channels.x, &scan.channels.y, &scan.channels.z, &scan.channels.time}) {
    channel->resize(std::min(channel->size(), count));
  }
  scan.channels.ring.resize(std::min(scan.channels.ring.size(), count));
  scan.labels.resize(std::min(scan.labels.size(), count));
}

std::vector<BadScan> bad_scans() {
  static constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
  return {
      {"as_it_should_be", [](test::RoadScan&) {}},
      {"no_rings", [](test::RoadScan& scan) { scan.channels.ring.clear(); }},
      {"no_times", [](test::RoadScan& scan) { scan.channels.time.clear(); }},
      {"one_ring_for_all", [](test::RoadScan& scan) { scan.channels.ring.assign(scan.channels.ring.size(), 3); }},
      {"rings_at_random",
       [](test::RoadScan& scan) {
         std::mt19937 random(1);  // NOLINT(cert-msc32-c,cert-msc51-cpp)
         for (std::uint16_t& ring : scan.channels.ring) {
           ring = static_cast<std::uint16_t>(random());
         }
       }},
      {"rings_upside_down",
       [](test::RoadScan& scan) {
         for (std::uint16_t& ring : scan.channels.ring) {
           ring = static_cast<std::uint16_t>(65535 - ring);
         }
       }},
      {"empty", [](test::RoadScan& scan) { keep_first(scan, 0); }},
      {"one_point", [](test::RoadScan& scan) { keep_first(scan, 1); }},
      {"a_third_of_a_turn", [](test::RoadScan& scan) { keep_first(scan, scan.labels.size() / 3); }},
      {"no_returns_only",
       [](test::RoadScan& scan) {
         for (auto* channel : {&scan.channels.x, &scan.channels.y, &scan.channels.z}) {
           channel->assign(channel->size(), 0.0F);
         }
         scan.labels.assign(scan.labels.size(), Label::no_return);
       }},
      {"no_returns_that_are_called_ground",
       [](test::RoadScan& scan) {
         for (auto* channel : {&scan.channels.x, &scan.channels.y, &scan.channels.z}) {
           channel->assign(channel->size(), 0.0F);
         }
         scan.labels.assign(scan.labels.size(), Label::drivable);
       }},
      {"nan_that_is_called_ground",
       [](test::RoadScan& scan) {
         for (std::size_t i = 0; i < scan.labels.size(); i += 3) {
           scan.channels.y[i] = kNaN;
           scan.labels[i] = Label::drivable;
         }
       }},
      {"nan_only",
       [](test::RoadScan& scan) {
         scan.channels.x.assign(scan.channels.x.size(), kNaN);
         scan.labels.assign(scan.labels.size(), Label::obstacle);
       }},
      {"infinitely_far",
       [](test::RoadScan& scan) {
         for (std::size_t i = 0; i < scan.labels.size(); i += 5) {
           scan.channels.x[i] = std::numeric_limits<float>::infinity();
           scan.channels.z[i] = -1e30F;
         }
       }},
      {"all_in_one_place",
       [](test::RoadScan& scan) {
         scan.channels.x.assign(scan.channels.x.size(), 10.0F);
         scan.channels.y.assign(scan.channels.y.size(), 1.0F);
         scan.channels.z.assign(scan.channels.z.size(), -4.0F);
       }},
      {"nothing_is_known", [](test::RoadScan& scan) { scan.labels.assign(scan.labels.size(), Label::unlabeled); }},
      {"mount_upside_down",
       [](test::RoadScan& scan) {
         scan.T_base_sensor = Pose::from_yaw_pitch_roll(0.0, 0.0, 3.14, {0.0, 0.0, 4.0});
       }},
      {"mount_height_unknown", [](test::RoadScan& scan) { scan.T_base_sensor = Pose(); }},
  };
}

class EdgesOnBadScans : public testing::TestWithParam<BadScan> {};

void expect_good_manners(EdgeDetector& edges, const test::RoadScan& scan) {
  const EdgeResult result = edges.process(scan.input());
  const std::vector<EdgePoint> found(result.edges.begin(), result.edges.end());
  for (const EdgePoint& edge : found) {
    for (const float value : {edge.x_m, edge.y_m, edge.z_m, edge.time_s, edge.height_m, edge.width_m}) {
      EXPECT_TRUE(std::isfinite(value));
    }
    EXPECT_GE(edge.confidence, 0.0F);
    EXPECT_LE(edge.confidence, 1.0F);
    EXPECT_GE(edge.height_m, 0.0F);
    EXPECT_GE(edge.width_m, 0.0F);
  }
  for (const std::uint32_t i : result.plain) {
    ASSERT_LT(i, scan.labels.size());
    EXPECT_TRUE(std::isfinite(scan.channels.x[i] + scan.channels.y[i] + scan.channels.z[i]));
  }
  (void)edges.process(good_scan().input());
  const EdgeResult again = edges.process(scan.input());
  ASSERT_EQ(again.edges.size(), found.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(again.edges[i].x_m, found[i].x_m);
    EXPECT_EQ(again.edges[i].confidence, found[i].confidence);
  }
}

TEST_P(EdgesOnBadScans, AreNumbersAndTheSameAgain) {
  test::RoadScan scan = good_scan();
  GetParam().spoil(scan);
  TraceEdges by_default({});
  expect_good_manners(by_default, scan);
  RingEdges reference({});
  expect_good_manners(reference, scan);
}

INSTANTIATE_TEST_SUITE_P(All, EdgesOnBadScans, testing::ValuesIn(bad_scans()),
                         [](const auto& one) { return one.param.name; });

TEST(EdgesOnBadInput, SayThatLabelsAreMissing) {
  test::RoadScan scan = good_scan();
  scan.labels.pop_back();
  TraceEdges by_default({});
  EXPECT_THROW((void)by_default.process(scan.input()), Error);
  RingEdges reference({});
  EXPECT_THROW((void)reference.process(scan.input()), Error);
}

TEST(EdgesOnBadInput, AreFoundWithoutRingsToo) {
  test::RoadScan scan = good_scan();
  scan.channels.ring.clear();
  TraceEdges edges({});
  const EdgeResult result = edges.process(scan.input());
  ASSERT_GE(result.edges.size(), 12U);
  for (const EdgePoint& edge : result.edges) {
    EXPECT_NEAR(std::abs(edge.y_m), 7.0F, 0.15F);
    EXPECT_EQ(edge.side == EdgeSide::left, edge.y_m > 0.0F);
  }
}

}  // namespace
}  // namespace berm
