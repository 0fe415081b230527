#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "berm/edge/ring_edges.hpp"
#include "berm/edge/trace_edges.hpp"
#include "edge/road_scene.hpp"
#include "support/counting_new.hpp"

namespace berm {
namespace {

void expect_no_allocation(EdgeDetector& edges) {
  std::vector<test::RoadScan> scans;
  scans.push_back(test::scan_road(test::road_between_berms(7.0, 1.0)));
  scans.push_back(test::scan_road([](double, double) { return 0.0; }));
  scans.emplace_back();
  for (const test::RoadScan& scan : scans) {
    (void)edges.process(scan.input());
  }
  for (std::size_t i = 0; i < 2 * scans.size(); ++i) {
    const EdgeInput input = scans[i % scans.size()].input();
    const std::size_t before = test::allocations();
    (void)edges.process(input);
    EXPECT_EQ(test::allocations() - before, 0U) << "scan " << i;
  }
}

TEST(EdgeAllocation, IsCounted) {
  const std::size_t before = test::allocations();
  const auto number = std::make_unique<std::vector<int>>(10);
  EXPECT_EQ(test::allocations() - before, 2U) << number->size();
}

TEST(EdgeAllocation, IsOverAfterTheLargestScanOfTheDefault) {
  TraceEdges edges({});
  expect_no_allocation(edges);
}

TEST(EdgeAllocation, IsOverAfterTheLargestScanOfTheReference) {
  RingEdges edges({});
  expect_no_allocation(edges);
}

}  // namespace
}  // namespace berm
