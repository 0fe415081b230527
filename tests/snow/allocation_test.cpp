#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/snow/box_snow.hpp"
#include "berm/snow/repair.hpp"
#include "berm/snow/sparse_snow.hpp"
#include "snow/snow_cases.hpp"
#include "support/counting_new.hpp"

namespace berm {
namespace {

std::vector<test::SnowyScan> scans() {
  std::vector<test::SnowyScan> all;
  for (const test::Lookout& lookout : test::lookouts()) {
    all.push_back(test::let_it_snow(lookout.look(test::made_street(1)), {.share = 0.1}, 1));
  }
  all.push_back(test::turned(all.front(), 40.0, 60.0, 10.0));
  all.push_back(all.front());
  all.back().channels.intensity.clear();
  all.emplace_back();
  return all;
}

void expect_no_allocation(SnowFilter& snow, const std::string& name) {
  const std::vector<test::SnowyScan> all = scans();
  SeriesRepair repair;
  for (std::size_t i = 0; i < 3 * all.size(); ++i) {
    const test::SnowyScan& scan = all[i % all.size()];
    const std::size_t before = test::allocations();
    const SnowResult result = snow.process(scan.view(), {});
    (void)repair.process(scan.view(), result.falling);
    if (i >= 3) {
      EXPECT_EQ(test::allocations() - before, 0U) << name << ", scan " << i;
    }
  }
}

TEST(SnowAllocation, IsCounted) {
  const std::size_t before = test::allocations();
  const auto number = std::make_unique<std::vector<int>>(10);
  EXPECT_EQ(test::allocations() - before, 2U) << number->size();
}

TEST(SnowAllocation, IsOverAfterTheThirdScanOfTheDefault) {
  SparseSnow snow({});
  expect_no_allocation(snow, "default");
}

TEST(SnowAllocation, IsOverAfterTheThirdScanOfTheReference) {
  BoxSnow snow({});
  expect_no_allocation(snow, "reference");
}

}  // namespace
}  // namespace berm
