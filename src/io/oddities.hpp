#pragma once

#include <cstddef>
#include <cstdint>

#include "berm/io/recording_info.hpp"

namespace berm {

/// Counts that only matter where they are odd.
struct OddCounts {
  std::size_t empty_scans = 0;
  std::size_t failed_labels = 0;
  std::uint64_t time_steps = 0;       ///< between the times of consecutive points
  std::uint64_t time_steps_back = 0;  ///< of these, to an earlier time
};

/// Adds a sentence to `info.odd` for everything in `info` and `counts` that a user should know before using the data.
void find_oddities(const OddCounts& counts, RecordingInfo& info);

}  // namespace berm
