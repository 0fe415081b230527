#pragma once

#include <cstdint>

namespace berm {

/// Nanoseconds since the epoch of the recording: exact, unlike seconds in a double.
using Stamp = std::int64_t;

constexpr double kNanosecondsPerSecond = 1e9;

[[nodiscard]] constexpr double to_seconds(Stamp stamp_ns) {
  return static_cast<double>(stamp_ns) / kNanosecondsPerSecond;
}

/// Nearest nanosecond. `seconds` must lie within +-9.2e9 (about 292 years), which readers check.
[[nodiscard]] constexpr Stamp from_seconds(double seconds) {
  const double nanoseconds = seconds * kNanosecondsPerSecond;
  return static_cast<Stamp>(nanoseconds < 0.0 ? nanoseconds - 0.5 : nanoseconds + 0.5);
}

}  // namespace berm
