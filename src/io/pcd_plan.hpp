#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "pcd_header.hpp"

namespace berm {

enum class PcdChannel : std::uint8_t { x, y, z, intensity, time, ring, label };

/// What the values of a field of time mean. Only name and type decide, see docs/formats.md.
enum class PcdTimeUnit : std::uint8_t { relative_s, relative_ns, absolute_s, absolute_ns };

[[nodiscard]] constexpr bool is_absolute(PcdTimeUnit unit) {
  return unit == PcdTimeUnit::absolute_s || unit == PcdTimeUnit::absolute_ns;
}

struct PcdPlannedChannel {
  PcdChannel channel = PcdChannel::x;
  std::size_t field = 0;  ///< index in the header
};

/// Which field feeds which channel.
struct PcdPlan {
  std::vector<PcdPlannedChannel> channels;  ///< at least x, y, z
  PcdTimeUnit time_unit = PcdTimeUnit::relative_s;
  std::vector<std::string> notes;
};

/// Throws FileError(malformed) if a field that is needed appears twice, (unsupported) if x, y or z is missing.
[[nodiscard]] PcdPlan plan_channels(const PcdHeader& header, const std::string& name);

}  // namespace berm
