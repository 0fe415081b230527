#include "berm/geometry/polar_grid.hpp"

#include <cfloat>
#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kNanPlace = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfPlace = std::numeric_limits<double>::infinity();

bool refused(int sectors, int bins, double min_range_m, double max_range_m) {
  try {
    const PolarGrid grid(sectors, bins, min_range_m, max_range_m);
  } catch (const Error& error) {
    return error.code() == ErrorCode::invalid_argument;
  }
  return false;
}

bool refused(std::vector<double> edges_m) {
  try {
    const PolarGrid grid(8, std::move(edges_m));
  } catch (const Error& error) {
    return error.code() == ErrorCode::invalid_argument;
  }
  return false;
}

TEST(PolarGrid, FollowsTheFormulasOfG) {
  const PolarGrid grid(80, 120, 3.4, 120.0);
  EXPECT_EQ(grid.sectors(), 80);
  EXPECT_EQ(grid.bins(), 120);
  EXPECT_EQ(grid.size(), 9600U);
  EXPECT_EQ(grid.cell_of(10.0, 0.0), (PolarCell{40, 6}));
  EXPECT_EQ(grid.cell_of(0.0, 10.0), (PolarCell{60, 6}));
  EXPECT_EQ(grid.cell_of(0.0, -10.0), (PolarCell{20, 6}));
  EXPECT_EQ(grid.cell_of(3.4, 0.0)->bin, 0) << "the inner edge is inside";
  EXPECT_EQ(grid.cell_of(3.3999, 0.0), std::nullopt);
  EXPECT_EQ(grid.cell_of(120.0, 0.0), std::nullopt) << "the outer edge is outside";
  EXPECT_EQ(grid.cell_of(119.999, 0.0)->bin, 119);
}

TEST(PolarGrid, DoesNotLosePointsStraightBehind) {
  for (const int sectors : {1, 2, 3, 7, 80, 360, 65536}) {
    const PolarGrid grid(sectors, 10, 0.0, 100.0);
    EXPECT_EQ(grid.cell_of(-10.0, 0.0), (PolarCell{0, 1})) << "azimuth +pi, " << sectors;
    EXPECT_EQ(grid.cell_of(-10.0, -0.0), (PolarCell{0, 1})) << "azimuth -pi, " << sectors;
    const auto just_below = grid.sector_of(std::nextafter(kPi, 0.0));
    ASSERT_TRUE(just_below.has_value());
    EXPECT_TRUE(*just_below == sectors - 1 || *just_below == 0);
    EXPECT_EQ(grid.sector_of(std::atan2(0.0F, -1.0F)), 0) << "pi as a float is larger than as a double";
    EXPECT_EQ(grid.sector_of(-kPi), 0);
  }
}

TEST(PolarGrid, GivesNothingForWhatHasNoCell) {
  const PolarGrid grid(80, 120, 3.4, 120.0);
  for (const double odd : {kNanPlace, kInfPlace, -kInfPlace, DBL_MAX, -DBL_MAX, static_cast<double>(FLT_MAX), 1e10}) {
    EXPECT_EQ(grid.cell_of(odd, 1.0), std::nullopt) << odd;
    EXPECT_EQ(grid.cell_of(1.0, odd), std::nullopt) << odd;
    EXPECT_EQ(grid.bin_of(odd), std::nullopt) << odd;
    EXPECT_EQ(grid.sector_of(odd), std::nullopt) << odd;
  }
  EXPECT_EQ(grid.cell_of(0.0, 0.0), std::nullopt);
  EXPECT_EQ(grid.bin_of(-1.0), std::nullopt);
  EXPECT_EQ(grid.sector_of(kPi + 0.01), std::nullopt);
  EXPECT_EQ(PolarGrid(80, 1, 0.0, 1.0).cell_of(0.0, 0.0)->bin, 0) << "the origin has a cell where the rings reach it";
}

TEST(PolarGrid, TakesEdgesOfTheUser) {
  const PolarGrid grid(4, {1.0, 2.0, 5.0, 10.0});
  EXPECT_EQ(grid.bins(), 3);
  EXPECT_EQ(grid.bin_of(0.999), std::nullopt);
  EXPECT_EQ(grid.bin_of(1.0), 0);
  EXPECT_EQ(grid.bin_of(1.999), 0);
  EXPECT_EQ(grid.bin_of(2.0), 1);
  EXPECT_EQ(grid.bin_of(9.999), 2);
  EXPECT_EQ(grid.bin_of(10.0), std::nullopt);
  EXPECT_DOUBLE_EQ(grid.center_range_m(1), 3.5);
}

TEST(PolarGrid, RefusesWhatMakesNoGrid) {
  EXPECT_FALSE(refused(1, 1, 0.0, 1.0));
  EXPECT_TRUE(refused(0, 1, 0.0, 1.0));
  EXPECT_TRUE(refused(-5, 1, 0.0, 1.0));
  EXPECT_TRUE(refused(1, 0, 0.0, 1.0));
  EXPECT_TRUE(refused(1, -5, 0.0, 1.0));
  EXPECT_TRUE(refused(1, 1 << 30, 0.0, 1.0));
  EXPECT_TRUE(refused(1 << 30, 1, 0.0, 1.0));
  EXPECT_TRUE(refused(1, 1, 1.0, 1.0));
  EXPECT_TRUE(refused(1, 1, 2.0, 1.0));
  EXPECT_TRUE(refused(1, 1, -1.0, 1.0));
  EXPECT_TRUE(refused(1, 1, kNanPlace, 1.0));
  EXPECT_TRUE(refused(1, 4, 0.0, kNanPlace));
  EXPECT_TRUE(refused(1, 4, 0.0, kInfPlace));
  EXPECT_TRUE(refused({}));
  EXPECT_TRUE(refused({1.0}));
  EXPECT_TRUE(refused({1.0, 1.0}));
  EXPECT_TRUE(refused({2.0, 1.0}));
  EXPECT_TRUE(refused({1.0, kNanPlace, 3.0}));
  EXPECT_TRUE(refused({1.0, kInfPlace}));
  EXPECT_TRUE(refused(65536, 65536, 5.0, std::nextafter(5.0, 6.0))) << "bins too narrow to have a width";
}

TEST(PolarGrid, MeetsEveryCellAtItsMiddleAndOnce) {
  for (const PolarGrid& grid : {PolarGrid(80, 120, 3.4, 120.0), PolarGrid(7, 3, 0.0, 1.0), PolarGrid(1, 1, 0.0, 2.0),
                                PolarGrid(36, {0.5, 1.0, 3.0, 10.0, 200.0})}) {
    std::set<std::size_t> offsets;
    for (int sector = 0; sector < grid.sectors(); ++sector) {
      for (int bin = 0; bin < grid.bins(); ++bin) {
        const double azimuth_rad = grid.center_azimuth_rad(sector);
        const double range_m = grid.center_range_m(bin);
        const auto cell = grid.cell_of(range_m * std::cos(azimuth_rad), range_m * std::sin(azimuth_rad));
        EXPECT_EQ(cell, (PolarCell{sector, bin}));
        offsets.insert(grid.offset({sector, bin}));
      }
    }
    EXPECT_EQ(offsets.size(), grid.size());
    EXPECT_EQ(*offsets.rbegin(), grid.size() - 1);
  }
}

TEST(PolarGrid, AgreesWithASearchThroughAllCells) {
  EXPECT_TRUE(rc::check("uniform rings equal the same edges given one by one; the sector encloses the azimuth", [] {
    const int sectors = *rc::gen::inRange(1, 400);
    const int bins = *rc::gen::inRange(1, 200);
    const double min_m = *rc::gen::inRange(0, 100) * 0.1;
    const PolarGrid uniform(sectors, bins, min_m, min_m + 50.0);
    const PolarGrid listed(sectors, uniform.edges_m());
    const double x_m = *rc::gen::inRange(-60'000, 60'000) * 1e-3;
    const double y_m = *rc::gen::inRange(-60'000, 60'000) * 1e-3;
    const auto cell = uniform.cell_of(x_m, y_m);
    const double range_m = std::hypot(x_m, y_m);
    RC_ASSERT(cell.has_value() == (range_m >= min_m && range_m < min_m + 50.0));
    if (cell) {
      const auto other = listed.cell_of(x_m, y_m);
      RC_ASSERT(other->sector == cell->sector);
      // On an edge itself, division and comparison may round to different sides.
      const auto& edges_m = uniform.edges_m();
      const auto bin = static_cast<std::size_t>(cell->bin);
      RC_ASSERT(range_m >= edges_m[bin] - 1e-9 && range_m <= edges_m[bin + 1] + 1e-9);
      const double off_rad = std::remainder(std::atan2(y_m, x_m) - uniform.center_azimuth_rad(cell->sector), 2.0 * kPi);
      RC_ASSERT(std::abs(off_rad) <= kPi / sectors + 1e-9);
    }
  }));
}

}  // namespace
}  // namespace berm
