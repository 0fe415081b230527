#pragma once

#include <set>
#include <string>
#include <vector>

#include "berm/io/recording.hpp"
#include "berm/pipeline/machine.hpp"

namespace berm {

/// Takes over what the recording's own sheet (sequence.json) says about the mount and the rate: it was written where
/// the recording was made, so it beats the machine file. Keys in `pinned` (those of `--set`) stay as they are.
/// Returns a note for each value that changed. Throws ConfigError for a value that is not allowed.
std::vector<std::string> adopt_sheet(Machine& machine, const SensorSheet& sheet, const std::set<std::string>& pinned);

}  // namespace berm
