#include "thinned_series.hpp"

#include <cmath>
#include <utility>

namespace berm {

ThinnedSeries::ThinnedSeries(std::vector<Thinning> columns) : kinds_(std::move(columns)) {}

void ThinnedSeries::put(Cell& cell, double value) {
  Cell one;
  if (!std::isnan(value)) {
    one = {.low = value, .high = value, .sum = value};
  }
  cell = joined(cell, one);
}

ThinnedSeries::Cell ThinnedSeries::joined(const Cell& a, const Cell& b) {
  if (std::isnan(a.low) || std::isnan(b.low)) {
    return std::isnan(a.low) ? b : a;
  }
  const bool low_in_b = b.low < a.low;
  const bool high_in_b = b.high > a.high;
  Cell both = {.low = low_in_b ? b.low : a.low, .high = high_in_b ? b.high : a.high, .sum = a.sum + b.sum};
  both.falls = low_in_b == high_in_b ? (low_in_b ? b.falls : a.falls) : low_in_b;
  return both;
}

void ThinnedSeries::add(double x, std::span<const double> values) {
  if (bins_.empty() || bins_.back().rows == stride_) {
    while (bins_.size() >= (stride_ == 1 ? kValues : kValues / 2)) {
      halve();
    }
  }
  if (bins_.empty() || bins_.back().rows == stride_) {
    bins_.push_back({.first_x = x, .last_x = x});
    cells_.resize(cells_.size() + kinds_.size());
  }
  bins_.back().last_x = x;
  ++bins_.back().rows;
  ++rows_;
  for (std::size_t column = 0; column < kinds_.size(); ++column) {
    put(cell(bins_.size() - 1, column), values[column]);
  }
}

void ThinnedSeries::halve() {
  for (std::size_t bin = 0; bin < bins_.size() / 2; ++bin) {
    const Bin& a = bins_[2 * bin];
    const Bin& b = bins_[2 * bin + 1];
    bins_[bin] = {.first_x = a.first_x, .last_x = b.last_x, .rows = a.rows + b.rows};
    for (std::size_t column = 0; column < kinds_.size(); ++column) {
      cell(bin, column) = joined(cell(2 * bin, column), cell(2 * bin + 1, column));
    }
  }
  bins_.resize(bins_.size() / 2);
  cells_.resize(bins_.size() * kinds_.size());
  stride_ *= 2;
}

Series ThinnedSeries::take() const {
  Series series{.columns = std::vector<std::vector<double>>(kinds_.size()), .rows = rows_, .rows_per_value = stride_};
  for (std::size_t i = 0; i < bins_.size(); ++i) {
    const Bin& bin = bins_[i];
    series.x.push_back(bin.first_x);
    if (stride_ > 1) {
      series.x.push_back((bin.first_x + bin.last_x) / 2.0);
    }
    for (std::size_t column = 0; column < kinds_.size(); ++column) {
      const Cell& of = cell(i, column);
      double first = of.falls ? of.high : of.low;
      double second = of.falls ? of.low : of.high;
      if (kinds_[column] != Thinning::extremes) {
        first = second = kinds_[column] == Thinning::worst || std::isnan(of.low) ? of.high : of.sum;
      }
      series.columns[column].push_back(first);
      if (stride_ > 1) {
        series.columns[column].push_back(second);
      }
    }
  }
  return series;
}

}  // namespace berm
