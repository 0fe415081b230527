#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "berm/view/shown_run.hpp"

namespace berm::app {

/// What the piste method of a run makes of a scan, worked out anew: JSON as docs/view_api.md has it. Throws FileError
/// for a run.json or scan that is broken, ConfigError for settings that this program does not know.
[[nodiscard]] std::optional<std::string> describe_piste(const ShownRun& run, std::size_t scan);

}  // namespace berm::app
