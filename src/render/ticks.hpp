#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace berm {

/// The smallest of 1, 2 or 5 times a power of ten that goes into `span` at most `at_most` times (at least once).
/// 1 if `span` is not a positive number.
[[nodiscard]] double nice_step(double span, int at_most);

/// The multiples of `step` (> 0) in [low, high], at most 1000 of them.
[[nodiscard]] std::vector<double> multiples(double low, double high, double step);

/// `value` with as many decimals as `step` needs; never "-0".
[[nodiscard]] std::string number_text(double value, double step);

/// `count` with a comma between thousands.
[[nodiscard]] std::string count_text(std::size_t count);

}  // namespace berm
