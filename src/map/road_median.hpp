#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "berm/core/road.hpp"

namespace berm {

/// Values that were seen in looks; those of one look share their error.
class LookedValues {
 public:
  void add(double value, unsigned look) {
    values_.push_back(value);
    looks_ |= std::uint32_t{1} << look;
  }
  [[nodiscard]] bool empty() const { return values_.empty(); }
  [[nodiscard]] std::size_t size() const { return values_.size(); }

  /// The median. Its sigma is that of the median of as many values as there were looks, each with the scatter that is
  /// seen, but at least `least_scatter`; and `floor`, which no number of looks takes away. None without values.
  [[nodiscard]] std::optional<Measure> median(double least_scatter, double floor) const;

 private:
  std::vector<double> values_;
  std::uint32_t looks_ = 0;
};

/// Median of values in any order, the mean of the middle two of an even number; 0 of none.
[[nodiscard]] double median_of(std::vector<double> values);

}  // namespace berm
