#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace berm {

/// Counts positive values in bins that grow by the same factor; the outermost take what lies beyond.
class LogHistogram {
 public:
  static constexpr double kFirst = 1e-3;     ///< begin of the first bin
  static constexpr int kBinsPerDecade = 10;  ///< a factor of 1.26 from bin to bin
  static constexpr std::size_t kBins = 80;   ///< up to 1e5

  /// NaN is not counted.
  void add(double value) {
    if (std::isnan(value)) {
      return;
    }
    const double place = value > kFirst ? std::log10(value / kFirst) * kBinsPerDecade : 0.0;
    ++bins_[std::min(static_cast<std::size_t>(place), kBins - 1)];
    ++count_;
  }
  [[nodiscard]] const std::vector<std::uint64_t>& bins() const { return bins_; }
  [[nodiscard]] std::uint64_t count() const { return count_; }

 private:
  std::vector<std::uint64_t> bins_ = std::vector<std::uint64_t>(kBins);
  std::uint64_t count_ = 0;
};

}  // namespace berm
