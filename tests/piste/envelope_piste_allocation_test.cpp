#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "berm/piste/envelope_piste.hpp"
#include "made_series.hpp"
#include "piste/mid70_scan.hpp"
#include "support/counting_new.hpp"

namespace berm {
namespace {

TEST(EnvelopePisteAllocation, IsCounted) {
  const std::size_t before = test::allocations();
  const auto number = std::make_unique<std::vector<int>>(10);
  EXPECT_EQ(test::allocations() - before, 2U) << number->size();
}

TEST(EnvelopePisteAllocation, IsOverAfterTheLargestScan) {
  std::vector<test::MadeSeries> scans;
  for (const std::size_t count : {10000U, 5000U, 0U, 10000U}) {
    const test::MadeScan scan = test::mid70_scan(count, count);
    test::MadeSeries series;
    for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
      series.add(scan.cloud.view().x[i], scan.cloud.view().y[i], scan.cloud.view().z[i]);
    }
    scans.push_back(series);
  }
  const std::vector<Label> labels(10000, Label::drivable);
  EnvelopePiste piste({});
  const auto process = [&](const test::MadeSeries& series) {
    PisteInput input = series.input(labels, test::groomer_mount());
    input.labels = input.labels.first(series.size());
    const std::size_t before = test::allocations();
    (void)piste.process(input);
    return test::allocations() - before;
  };
  EXPECT_GT(process(scans.front()), 0U);
  for (const test::MadeSeries& series : scans) {
    EXPECT_EQ(process(series), 0U) << series.size();
  }
}

}  // namespace
}  // namespace berm
