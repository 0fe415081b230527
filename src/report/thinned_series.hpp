#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace berm {

/// What stays of the values of a bin.
enum class Thinning : std::uint8_t {
  extremes,  ///< the smallest and the largest, in the order in which they came
  total,     ///< the sum, for both values of the bin
  worst,     ///< the largest, for both values of the bin
};

/// Columns over a common x, NaN for what is not known.
struct Series {
  std::vector<double> x;
  std::vector<std::vector<double>> columns;
  std::size_t rows = 0;            ///< that were added
  std::size_t rows_per_value = 1;  ///< 1: nothing was thinned
};

/// Keeps the look of a plot of any number of rows in bounded memory: up to `kValues` as they are, then bins of 2, 4, 8,
/// ... rows, of which each column gives two values. A spike of one row stays a spike.
class ThinnedSeries {
 public:
  static constexpr std::size_t kValues = 2000;

  explicit ThinnedSeries(std::vector<Thinning> columns);
  /// `values` has one per column, NaN for what is not known.
  void add(double x, std::span<const double> values);
  [[nodiscard]] Series take() const;

 private:
  struct Bin {
    double first_x = 0.0;
    double last_x = 0.0;
    std::size_t rows = 0;
  };
  struct Cell {
    double low = std::numeric_limits<double>::quiet_NaN();
    double high = std::numeric_limits<double>::quiet_NaN();
    double sum = 0.0;
    bool falls = false;  ///< the largest came before the smallest
  };

  static void put(Cell& cell, double value);
  static Cell joined(const Cell& a, const Cell& b);
  void halve();
  [[nodiscard]] Cell& cell(std::size_t bin, std::size_t column) { return cells_[bin * kinds_.size() + column]; }
  [[nodiscard]] const Cell& cell(std::size_t bin, std::size_t column) const {
    return cells_[bin * kinds_.size() + column];
  }

  std::vector<Thinning> kinds_;
  std::size_t rows_ = 0;
  std::size_t stride_ = 1;
  std::vector<Bin> bins_;
  std::vector<Cell> cells_;  ///< bin by bin
};

}  // namespace berm
