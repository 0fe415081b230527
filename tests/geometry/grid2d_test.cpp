#include "berm/geometry/grid2d.hpp"

#include <array>
#include <cfloat>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace berm {
namespace {

constexpr double kNanKey = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfKey = std::numeric_limits<double>::infinity();
const GridShape kShape{.origin_x_m = -10.0, .origin_y_m = 5.0, .cell_m = 0.5, .columns = 40, .rows = 20};

TEST(Grid2D, FindsTheCellOfAPlace) {
  const Grid2D<int> grid(kShape, 7);
  EXPECT_EQ(grid.size(), 800U);
  EXPECT_EQ(grid.index_of(-10.0, 5.0), (GridIndex{0, 0})) << "lower edges belong to the cell";
  EXPECT_EQ(grid.index_of(-9.51, 5.49), (GridIndex{0, 0}));
  EXPECT_EQ(grid.index_of(-9.5, 5.5), (GridIndex{1, 1})) << "upper edges do not";
  EXPECT_EQ(grid.index_of(9.99, 14.99), (GridIndex{39, 19}));
  EXPECT_EQ(grid.index_of(10.0, 14.99), std::nullopt);
  EXPECT_EQ(grid.index_of(9.99, 15.0), std::nullopt);
  EXPECT_EQ(grid.index_of(-10.01, 5.0), std::nullopt);
  EXPECT_EQ(*grid.find_at(0.0, 10.0), 7);
}

TEST(Grid2D, GivesNothingOutside) {
  Grid2D<double> grid(kShape);
  for (const double odd : {kNanKey, kInfKey, -kInfKey, DBL_MAX, -DBL_MAX, static_cast<double>(FLT_MAX), 1e10, -1e10}) {
    EXPECT_EQ(grid.index_of(odd, 10.0), std::nullopt) << odd;
    EXPECT_EQ(grid.index_of(0.0, odd), std::nullopt) << odd;
    EXPECT_EQ(grid.find_at(odd, odd), nullptr) << odd;
  }
  constexpr int kMax = std::numeric_limits<int>::max();
  constexpr int kMin = std::numeric_limits<int>::min();
  for (const GridIndex i : {GridIndex{-1, 0}, GridIndex{0, -1}, GridIndex{40, 0}, GridIndex{0, 20},
                            GridIndex{kMax, kMax}, GridIndex{kMin, kMin}}) {
    EXPECT_EQ(grid.find(i), nullptr) << i.column << ", " << i.row;
  }
}

TEST(Grid2D, HasNoCellsByDefault) {
  const Grid2D<int> grid;
  EXPECT_TRUE(grid.empty());
  EXPECT_EQ(grid.find({0, 0}), nullptr);
  EXPECT_EQ(grid.find_at(0.0, 0.0), nullptr);
}

TEST(Grid2D, KeepsWhatIsWritten) {
  Grid2D<int> grid({.cell_m = 1.0, .columns = 3, .rows = 2});
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) {
      *grid.find({column, row}) = 10 * row + column;
    }
  }
  const std::array expected = {0, 1, 2, 10, 11, 12};
  EXPECT_TRUE(std::equal(grid.cells().begin(), grid.cells().end(), expected.begin(), expected.end()));
  grid.fill(5);
  EXPECT_EQ(*grid.find({2, 1}), 5);
}

TEST(Grid2D, RefusesShapesThatMakeNoGrid) {
  const auto refused = [](GridShape shape) {
    try {
      const Grid2D<char> grid(shape);
    } catch (const Error& error) {
      return error.code() == ErrorCode::invalid_argument;
    }
    return false;
  };
  EXPECT_FALSE(refused({.columns = 0, .rows = 5}));
  EXPECT_FALSE(refused({.columns = 5, .rows = 0}));
  EXPECT_TRUE(refused({.columns = -1, .rows = 5}));
  EXPECT_TRUE(refused({.columns = 5, .rows = -1}));
  EXPECT_TRUE(refused({.cell_m = 0.0, .columns = 5, .rows = 5}));
  EXPECT_TRUE(refused({.cell_m = -1.0, .columns = 5, .rows = 5}));
  EXPECT_TRUE(refused({.cell_m = kNanKey, .columns = 5, .rows = 5}));
  EXPECT_TRUE(refused({.cell_m = kInfKey, .columns = 5, .rows = 5}));
  EXPECT_TRUE(refused({.origin_x_m = kNanKey, .columns = 5, .rows = 5}));
  EXPECT_TRUE(refused({.origin_y_m = kInfKey, .columns = 5, .rows = 5}));
  EXPECT_TRUE(refused({.columns = 1 << 30, .rows = 1 << 30})) << "2^60 cells";
  EXPECT_TRUE(refused({.columns = 1 << 28, .rows = 2}));
}

TEST(Grid2D, MeetsEveryCellAtItsMiddle) {
  EXPECT_TRUE(rc::check("index_of(center(i)) = i, for any shape", [] {
    const GridShape shape{.origin_x_m = *rc::gen::inRange(-5'000'000, 5'000'000) * 0.37,
                          .origin_y_m = *rc::gen::inRange(-5'000'000, 5'000'000) * 0.11,
                          .cell_m = *rc::gen::inRange(1, 1000) * 0.01,
                          .columns = *rc::gen::inRange(1, 300),
                          .rows = *rc::gen::inRange(1, 300)};
    const Grid2D<char> grid(shape);
    const GridIndex i{*rc::gen::inRange(0, shape.columns), *rc::gen::inRange(0, shape.rows)};
    RC_ASSERT(grid.index_of(grid.center_x_m(i), grid.center_y_m(i)) == i);
  }));
}

TEST(Grid2D, AgreesWithASearchThroughAllCells) {
  EXPECT_TRUE(rc::check("a place is in the one cell whose edges enclose it", [] {
    const Grid2D<char> grid({.origin_x_m = -2.0, .origin_y_m = -1.0, .cell_m = 0.25, .columns = 16, .rows = 8});
    const double x_m = *rc::gen::inRange(-300, 300) * 0.01;
    const double y_m = *rc::gen::inRange(-300, 300) * 0.01;
    std::optional<GridIndex> expected;
    for (int row = 0; row < 8; ++row) {
      for (int column = 0; column < 16; ++column) {
        const double left = -2.0 + 0.25 * column;
        const double bottom = -1.0 + 0.25 * row;
        if (x_m >= left && x_m < left + 0.25 && y_m >= bottom && y_m < bottom + 0.25) {
          expected = GridIndex{column, row};
        }
      }
    }
    RC_ASSERT(grid.index_of(x_m, y_m) == expected);
  }));
}

}  // namespace
}  // namespace berm
