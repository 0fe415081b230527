#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "berm/core/error.hpp"

namespace berm {

/// A cell of a `Grid2D`: column along x, row along y.
struct GridIndex {
  int column = 0;
  int row = 0;

  friend constexpr bool operator==(const GridIndex&, const GridIndex&) = default;
};

/// Where a grid lies: the corner with the smallest x and y, the side of its square cells, and how many there are.
struct GridShape {
  double origin_x_m = 0.0;
  double origin_y_m = 0.0;
  double cell_m = 1.0;
  int columns = 0;
  int rows = 0;
};

/// Values on a regular grid in the plane. A cell holds its lower edges and not its upper ones. Whoever looks outside,
/// also by NaN, Inf or huge coordinates, gets nothing.
template <typename T>
class Grid2D {
  static_assert(!std::is_same_v<T, bool>, "std::vector<bool> has no addresses; take std::uint8_t");

 public:
  /// Most cells of one grid: a wrong cell size must not ask for all the memory there is.
  static constexpr std::size_t kMaxCells = std::size_t{1} << 28;

  /// No cells.
  Grid2D() = default;

  /// Every cell holds `value`. Throws Error(invalid_argument) unless the origin is finite, the cell finite and
  /// positive, the counts not negative and their product at most kMaxCells.
  explicit Grid2D(const GridShape& shape, const T& value = T{}) : shape_(checked(shape)) {
    cells_.assign(static_cast<std::size_t>(shape.columns) * static_cast<std::size_t>(shape.rows), value);
  }

  [[nodiscard]] const GridShape& shape() const { return shape_; }
  [[nodiscard]] std::size_t size() const { return cells_.size(); }
  [[nodiscard]] bool empty() const { return cells_.empty(); }

  [[nodiscard]] bool contains(GridIndex i) const {
    return i.column >= 0 && i.column < shape_.columns && i.row >= 0 && i.row < shape_.rows;
  }

  /// The cell that holds a place, if the grid has one there.
  [[nodiscard]] std::optional<GridIndex> index_of(double x_m, double y_m) const {
    const double column = std::floor((x_m - shape_.origin_x_m) / shape_.cell_m);
    const double row = std::floor((y_m - shape_.origin_y_m) / shape_.cell_m);
    // Compared as doubles: a cast of NaN or of what no int holds is undefined.
    if (column >= 0.0 && column < shape_.columns && row >= 0.0 && row < shape_.rows) {
      return GridIndex{static_cast<int>(column), static_cast<int>(row)};
    }
    return std::nullopt;
  }

  /// The value of a cell, or null outside.
  [[nodiscard]] T* find(GridIndex i) { return contains(i) ? &cells_[offset(i)] : nullptr; }
  [[nodiscard]] const T* find(GridIndex i) const { return contains(i) ? &cells_[offset(i)] : nullptr; }

  /// The value of the cell that holds a place, or null outside.
  [[nodiscard]] T* find_at(double x_m, double y_m) {
    const auto i = index_of(x_m, y_m);
    return i ? &cells_[offset(*i)] : nullptr;
  }
  [[nodiscard]] const T* find_at(double x_m, double y_m) const {
    const auto i = index_of(x_m, y_m);
    return i ? &cells_[offset(*i)] : nullptr;
  }

  /// Middle of a cell; that of the lattice it belongs to for cells outside.
  [[nodiscard]] double center_x_m(GridIndex i) const { return shape_.origin_x_m + (i.column + 0.5) * shape_.cell_m; }
  [[nodiscard]] double center_y_m(GridIndex i) const { return shape_.origin_y_m + (i.row + 0.5) * shape_.cell_m; }

  /// All values, row by row.
  [[nodiscard]] std::span<T> cells() { return cells_; }
  [[nodiscard]] std::span<const T> cells() const { return cells_; }

  void fill(const T& value) { std::fill(cells_.begin(), cells_.end(), value); }

 private:
  static const GridShape& checked(const GridShape& shape) {
    const bool placed = std::isfinite(shape.origin_x_m) && std::isfinite(shape.origin_y_m);
    const bool sized = std::isfinite(shape.cell_m) && shape.cell_m > 0.0;
    const bool counted = shape.columns >= 0 && shape.rows >= 0 &&
                         (shape.columns == 0 ||
                          static_cast<std::size_t>(shape.rows) <= kMaxCells / static_cast<std::size_t>(shape.columns));
    if (!placed || !sized || !counted) {
      throw Error(ErrorCode::invalid_argument,
                  "grid: " + std::to_string(shape.columns) + " x " + std::to_string(shape.rows) + " cells of " +
                      std::to_string(shape.cell_m) + " m at (" + std::to_string(shape.origin_x_m) + ", " +
                      std::to_string(shape.origin_y_m) + "): expected finite numbers, a positive cell and at most " +
                      std::to_string(kMaxCells) + " cells");
    }
    return shape;
  }

  [[nodiscard]] std::size_t offset(GridIndex i) const {
    return static_cast<std::size_t>(i.row) * static_cast<std::size_t>(shape_.columns) +
           static_cast<std::size_t>(i.column);
  }

  GridShape shape_;
  std::vector<T> cells_;
};

}  // namespace berm
