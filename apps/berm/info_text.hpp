#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "berm/io/recording_info.hpp"

namespace berm {

/// What is in a recording, for people: a few aligned lines, angles in degrees; ends with a line end.
[[nodiscard]] std::string to_text(const RecordingInfo& info);

/// The same for programs; "schema" counts up whenever a key changes its meaning. Angles in degrees, keys end with their
/// unit.
[[nodiscard]] nlohmann::ordered_json to_json(const RecordingInfo& info);

}  // namespace berm
