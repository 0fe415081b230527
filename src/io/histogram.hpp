#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "berm/io/recording_info.hpp"

namespace berm {

/// Spread of any number of values in fixed memory: extremes exact, quantiles rounded down to a bin.
class Histogram {
 public:
  Histogram(double bin_width, double limit)
      : bin_width_(bin_width), bins_(static_cast<std::size_t>(limit / bin_width) + 1, 0) {}

  /// `value` finite; below 0 counts as the first bin, beyond the limit as the last.
  void add(double value) {
    const double bin = std::clamp(value / bin_width_, 0.0, static_cast<double>(bins_.size() - 1));
    ++bins_[static_cast<std::size_t>(bin)];
    ++count_;
    min_ = std::min(min_, value);
    max_ = std::max(max_, value);
  }

  /// None of no values.
  [[nodiscard]] std::optional<Spread> spread() const {
    if (count_ == 0) {
      return std::nullopt;
    }
    return Spread{.min = min_, .median = quantile(0.5), .p95 = quantile(0.95), .max = max_};
  }

 private:
  [[nodiscard]] double quantile(double share) const {
    const auto rank = static_cast<std::uint64_t>(share * static_cast<double>(count_ - 1));
    std::uint64_t below = 0;
    std::size_t bin = 0;
    while (below + bins_[bin] <= rank) {
      below += bins_[bin++];
    }
    return std::clamp(static_cast<double>(bin) * bin_width_, min_, max_);
  }

  double bin_width_;
  std::vector<std::uint64_t> bins_;
  std::uint64_t count_ = 0;
  double min_ = std::numeric_limits<double>::infinity();
  double max_ = -std::numeric_limits<double>::infinity();
};

}  // namespace berm
