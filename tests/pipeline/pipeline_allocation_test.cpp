#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/pipeline/pipeline.hpp"
#include "groomer_scan.hpp"
#include "support/counting_new.hpp"
#include "truck_recording.hpp"

namespace berm {
namespace {

class PipelineAllocation : public testing::TestWithParam<const char*> {};

TEST(CountingNew, IsCounted) {
  const std::size_t before = test::allocations();
  const auto number = std::make_unique<std::vector<int>>(10);
  EXPECT_EQ(test::allocations() - before, 2U) << number->size();
}

TEST_P(PipelineAllocation, IsOverAfterAFewScans) {
  std::vector<Scan> scans;
  for (std::uint32_t seed = 1; seed <= 4; ++seed) {
    scans.push_back(test::groomer_scan(seed));
  }
  test::let_it_snow(scans[1], 0.1);
  test::let_it_snow(scans[2], 0.6);
  Pipeline pipeline(test::groomer(GetParam(), "default", GetParam()));
  const StageListener listener = [](Stage) {};
  for (std::size_t i = 0; i < 2 * scans.size(); ++i) {
    static_cast<void>(pipeline.process(scans[i % scans.size()], listener));
  }
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const std::size_t before = test::allocations();
    static_cast<void>(pipeline.process(scans[i], listener));
    EXPECT_EQ(test::allocations() - before, 0U) << "scan " << i;
  }
}

class EdgeAllocation : public testing::TestWithParam<const char*> {};

TEST_P(EdgeAllocation, IsOverAfterAFewScans) {
  std::vector<Scan> scans;
  for (std::size_t i = 0; i < 3; ++i) {
    scans.push_back(test::truck_scan(i));
  }
  Machine machine = test::haul_truck();
  machine.methods.edge = GetParam();
  Pipeline pipeline(machine);
  const StageListener listener = [](Stage) {};
  for (std::size_t i = 0; i < 2 * scans.size(); ++i) {
    static_cast<void>(pipeline.process(scans[i % scans.size()], listener));
  }
  for (const Scan& scan : scans) {
    const std::size_t before = test::allocations();
    const ScanResult result = pipeline.process(scan, listener);
    EXPECT_EQ(test::allocations() - before, 0U) << scan.stamp_ns;
    EXPECT_GT(result.edge.edges.size(), 4U);
  }
}

INSTANTIATE_TEST_SUITE_P(Methods, EdgeAllocation, testing::Values("default", "reference"),
                         [](const auto& test) { return std::string(test.param); });

INSTANTIATE_TEST_SUITE_P(Methods, PipelineAllocation, testing::Values("default", "reference"),
                         [](const auto& test) { return std::string(test.param); });

}  // namespace
}  // namespace berm
