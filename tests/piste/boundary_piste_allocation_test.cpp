#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "berm/piste/boundary_piste.hpp"
#include "piste/boundary_scene.hpp"
#include "piste/mid70_scan.hpp"
#include "support/counting_new.hpp"

namespace berm {
namespace {

TEST(BoundaryPisteAllocation, IsCounted) {
  const std::size_t before = test::allocations();
  const auto number = std::make_unique<std::vector<int>>(10);
  EXPECT_EQ(test::allocations() - before, 2U) << number->size();
}

TEST(BoundaryPisteAllocation, IsOverAfterTheLargestScans) {
  const test::StraightPiste straight{};
  std::vector<test::PisteScan> scans;
  scans.push_back(test::look_at(straight, test::mid70_beams(), test::groomer_mount()));
  scans.push_back(test::look_at({.bank_m = 2.0}, test::spinning_beams(32, -35.0, 5.0, 300), test::groomer_mount()));
  scans.push_back(test::shuffled(scans.front(), 1));
  scans.push_back(test::look_at(straight, test::mid70_beams(500, 3000), test::groomer_mount()));
  scans.emplace_back();
  for (test::PisteScan& scan : scans) {
    for (std::size_t i = 0; i < scan.labels.size(); i += 17) {
      scan.labels[i] = Label::obstacle;
    }
  }
  BoundaryPiste piste({});
  const auto process = [&piste](const test::PisteScan& scan) {
    const std::size_t before = test::allocations();
    (void)piste.process(scan.input());
    return test::allocations() - before;
  };
  EXPECT_GT(process(scans.front()), 0U);
  for (const test::PisteScan& scan : scans) {
    (void)process(scan);
  }
  for (std::size_t i = 0; i < 2 * scans.size(); ++i) {
    EXPECT_EQ(process(scans[i % scans.size()]), 0U) << "scan " << i % scans.size();
  }
}

}  // namespace
}  // namespace berm
