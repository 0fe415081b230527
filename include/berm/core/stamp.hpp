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
  const double nanoseconds = seconds * kNanosecondsPerSecond;
  const auto whole = static_cast<Stamp>(nanoseconds);
  // The rest is exact. Adding 0.5 and cutting off would not be: neither for 0.5 less one digit nor beyond 2^52 ns.
  const double rest = nanoseconds - static_cast<double>(whole);
  if (rest >= 0.5) {
    return whole + 1;
  }
  return rest <= -0.5 ? whole - 1 : whole;
}

}  // namespace berm
