#pragma once

#include <cstdint>

namespace berm {

/// Nanoseconds since the epoch of the recording: exact, unlike seconds in a double.
using Stamp = std::int64_t;

constexpr double kNanosecondsPerSecond = 1e9;

[[nodiscard]] constexpr double to_seconds(Stamp stamp_ns) {
  return static_cast<double>(stamp_ns) / kNanosecondsPerSecond;
}

/// Nearest nanosecond, halves away from zero. `seconds` must lie within +-9.2e9 (about 292 years), which readers check.
[[nodiscard]] constexpr Stamp from_seconds(double seconds) {
  // Whole seconds apart: the product of today's epoch and 1e9 would be rounded to 256 ns.
  const auto whole_seconds = static_cast<Stamp>(seconds);
  const double nanoseconds = (seconds - static_cast<double>(whole_seconds)) * kNanosecondsPerSecond;
  const auto whole = static_cast<Stamp>(nanoseconds);
  // The rest is exact. Adding 0.5 and cutting off would not be for 0.5 less one digit.
  const double rest = nanoseconds - static_cast<double>(whole);
  const Stamp rounded = rest >= 0.5 ? whole + 1 : (rest <= -0.5 ? whole - 1 : whole);
  return whole_seconds * 1'000'000'000 + rounded;
}

}  // namespace berm
