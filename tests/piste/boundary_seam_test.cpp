#include "boundary_seam.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace berm {
namespace {

using bearing_grid::Arc;
using bearing_grid::kBins;
using bearing_grid::kSectors;

constexpr std::size_t kPlaces = kBins + 1;
constexpr std::size_t kCells = std::size_t{kSectors} * kBins;

struct Price {
  double jump_cost = 0.15;
  int max_jump_bins = 25;

  [[nodiscard]] double of(int from, int to) const {
    return jump_cost * static_cast<double>(std::min(std::abs(from - to), max_jump_bins));
  }
};

/// What the seam pays in a sector for having its bound in each place.
std::vector<double> costs_of_sector(const std::vector<float>& cells, std::size_t sector) {
  std::vector<double> costs(kPlaces, 0.0);
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    costs[bin + 1] = costs[bin] + double{cells[sector * kBins + bin]};
  }
  return costs;
}

double cost_of(const std::vector<float>& cells, const Arc& arc, const Price& price, std::span<const int> bound) {
  double cost = 0.0;
  for (int i = 0; i < arc.count; ++i) {
    const std::size_t sector = arc.sector(i);
    cost += costs_of_sector(cells, sector)[static_cast<std::size_t>(bound[sector])];
    cost += i > 0 ? price.of(bound[arc.sector(i - 1)], bound[sector]) : 0.0;
  }
  return cost;
}

/// Least cost of any seam, every pair of places tried.
double least_cost(const std::vector<float>& cells, const Arc& arc, const Price& price) {
  std::vector<double> before(kPlaces, 0.0);
  for (int i = 0; i < arc.count; ++i) {
    std::vector<double> costs = costs_of_sector(cells, arc.sector(i));
    for (std::size_t to = 0; to < kPlaces; ++to) {
      double least = i == 0 ? 0.0 : before[0] + price.of(0, static_cast<int>(to));
      for (std::size_t from = 1; i > 0 && from < kPlaces; ++from) {
        least = std::min(least, before[from] + price.of(static_cast<int>(from), static_cast<int>(to)));
      }
      costs[to] += least;
    }
    before = costs;
  }
  return *std::min_element(before.begin(), before.end());
}

/// Cells of which a part, or all, hold something.
rc::Gen<std::vector<float>> any_cells() {
  return rc::gen::apply(
      [](std::uint32_t seed, unsigned filled) {
        std::mt19937 random(seed);
        std::vector<float> cells(kCells, 0.0F);
        for (float& cell : cells) {
          cell = random() % 10 < filled ? static_cast<float>(random() % 600) * 0.01F - 2.0F : 0.0F;
        }
        return cells;
      },
      rc::gen::arbitrary<std::uint32_t>(), rc::gen::inRange(1U, 11U));
}

rc::Gen<Arc> any_arc() {
  return rc::gen::apply(
      [](int first, int count) {
        return Arc{first, count};
      },
      rc::gen::inRange(0, kSectors), rc::gen::element(1, 2, 3, 35, 60, kSectors));
}

TEST(BoundarySeam, IsTheCheapestOfAll) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<float> cells = *any_cells();
    const Arc arc = *any_arc();
    const Price price{*rc::gen::element(0.0, 0.01, 0.15, 1.0, 10.0, 100.0),
                      *rc::gen::element(1, 2, 3, 15, 16, 25, 31, 32, 50, 63, 64, 65, 99, 100, 101, 1000)};
    BoundarySeam seam(price.jump_cost, price.max_jump_bins);
    const std::span<const int> bound = seam.find(cells, arc);
    RC_ASSERT(bound.size() == std::size_t{kSectors});
    for (const int bin : bound) {
      RC_ASSERT(bin >= 0 && bin <= kBins);
    }
    const double least = least_cost(cells, arc, price);
    RC_ASSERT(cost_of(cells, arc, price, bound) <= least + 1e-3 + 1e-5 * std::abs(least));
  }));
}

/// `count` sectors of an arc with evidence against piste before `bin` and for it from there on.
void draw(std::vector<float>& cells, const Arc& arc, int from, int count, int bin, float strength) {
  for (int i = from; i < from + count; ++i) {
    for (int b = 0; b < kBins; ++b) {
      cells[arc.sector(i) * kBins + static_cast<std::size_t>(b)] = b < bin ? -strength : strength;
    }
  }
}

TEST(BoundarySeam, TakesJumpsLongerThanAnyThatItChargesFor) {
  for (const int max_jump_bins : {1, 10, 31, 40, 63, 70, 90, 1000}) {
    for (const int far : {30, 50, 70, 95}) {
      const Arc arc{20, 60};
      std::vector<float> cells(kCells, 0.0F);
      draw(cells, arc, 0, 30, 2, 1.0F);
      draw(cells, arc, 30, 30, far, 1.0F);
      BoundarySeam seam(1.0, max_jump_bins);
      const std::span<const int> bound = seam.find(cells, arc);
      EXPECT_EQ(bound[arc.sector(29)], 2) << max_jump_bins << ", " << far;
      EXPECT_EQ(bound[arc.sector(30)], far) << max_jump_bins << ", " << far;
    }
  }
}

/// The last sector has nobody after it to show how far it would have had to jump.
TEST(BoundarySeam, GoesTheWholeWayInItsLastSector) {
  for (const int max_jump_bins : {31, 32, 63, 64, 90, 1000}) {
    for (const int far : {30, 65, 70, 95, kBins}) {
      const Arc arc{20, 2};
      std::vector<float> cells(kCells, 0.0F);
      draw(cells, arc, 0, 1, 2, 100.0F);
      draw(cells, arc, 1, 1, far, 1.5F);
      BoundarySeam seam(1.0, max_jump_bins);
      const std::span<const int> bound = seam.find(cells, arc);
      EXPECT_EQ(bound[arc.sector(0)], 2) << max_jump_bins << ", " << far;
      EXPECT_EQ(bound[arc.sector(1)], far) << max_jump_bins << ", " << far;
    }
  }
}

TEST(BoundarySeam, CrossesStraightBehind) {
  const Arc arc{kSectors - 20, 40};
  std::vector<float> cells(kCells, 0.0F);
  draw(cells, arc, 0, 20, 40, 1.0F);
  draw(cells, arc, 20, 20, 45, 1.0F);
  BoundarySeam seam(0.15, 25);
  const std::span<const int> bound = seam.find(cells, arc);
  EXPECT_EQ(bound[kSectors - 20], 40);
  EXPECT_EQ(bound[kSectors - 1], 40);
  EXPECT_EQ(bound[0], 45);
  EXPECT_EQ(bound[19], 45);
}

TEST(BoundarySeam, GivesSectorsOutsideOfTheArcTheirNearestNeighbours) {
  const Arc arc{100, 20};
  std::vector<float> cells(kCells, 0.0F);
  draw(cells, arc, 0, 10, 40, 5.0F);
  draw(cells, arc, 10, 10, 60, 5.0F);
  // Cells of others mean nothing.
  const Arc others{120, kSectors - 20};
  draw(cells, others, 0, others.count, 5, 100.0F);
  BoundarySeam seam(0.15, 25);
  const std::span<const int> bound = seam.find(cells, arc);
  for (int i = 0; i < others.count; ++i) {
    EXPECT_EQ(bound[others.sector(i)], i < others.count / 2 ? 60 : 40) << i;
  }
}

TEST(BoundarySeam, IsBeyondAllWhereNothingIsSeen) {
  BoundarySeam seam(0.15, 25);
  const std::vector<float> cells(kCells, 1.0F);
  for (const int bin : seam.find(cells, {})) {
    EXPECT_EQ(bin, kBins);
  }
}

TEST(BoundarySeam, LiesBeyondAllWhereEverythingSpeaksAgainst) {
  BoundarySeam seam(0.15, 25);
  for (const int bin : seam.find(std::vector<float>(kCells, -1.0F), {0, kSectors})) {
    EXPECT_EQ(bin, kBins);
  }
}

TEST(BoundarySeam, LiesBeforeAllWhereEverythingSpeaksFor) {
  BoundarySeam seam(0.15, 25);
  for (const int bin : seam.find(std::vector<float>(kCells, 1.0F), {0, kSectors})) {
    EXPECT_EQ(bin, 0);
  }
}

TEST(BoundarySeam, DoesNotJumpForNothing) {
  const Arc arc{70, 40};
  std::vector<float> cells(kCells, 0.0F);
  draw(cells, arc, 10, 5, 33, 1.0F);
  BoundarySeam seam(0.15, 25);
  const std::span<const int> bound = seam.find(cells, arc);
  for (int i = 0; i < arc.count; ++i) {
    EXPECT_EQ(bound[arc.sector(i)], 33) << i;
  }
}

TEST(BoundarySeam, DoesNotJumpForNothingEvenWhereJumpsAreFree) {
  BoundarySeam seam(0.0, 25);
  const std::span<const int> bound = seam.find(std::vector<float>(kCells, 0.0F), {0, kSectors});
  EXPECT_EQ(std::count(bound.begin(), bound.end(), bound[0]), kSectors);
}

TEST(BoundarySeam, LooksAtEverySectorAloneWhereJumpsAreFree) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<float> cells = *any_cells();
    const Arc arc = *any_arc();
    BoundarySeam seam(0.0, 25);
    const std::span<const int> bound = seam.find(cells, arc);
    for (int i = 0; i < arc.count; ++i) {
      const std::vector<double> costs = costs_of_sector(cells, arc.sector(i));
      const double least = *std::min_element(costs.begin(), costs.end());
      RC_ASSERT(costs[static_cast<std::size_t>(bound[arc.sector(i)])] <= least + 1e-2);
    }
  }));
}

TEST(BoundarySeam, RemembersNothing) {
  EXPECT_TRUE(rc::check([] {
    const std::vector<float> cells = *any_cells();
    const Arc arc = *any_arc();
    BoundarySeam used(0.15, 25);
    (void)used.find(*any_cells(), *any_arc());
    BoundarySeam fresh(0.15, 25);
    const std::span<const int> a = used.find(cells, arc);
    const std::span<const int> b = fresh.find(cells, arc);
    RC_ASSERT(std::equal(a.begin(), a.end(), b.begin(), b.end()));
  }));
}

}  // namespace
}  // namespace berm
