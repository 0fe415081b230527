#pragma once

#include <string>

#include "setting.hpp"

namespace berm {

/// Parse the text of `setting`; throw ConfigError saying which type was expected if it is no such value.
[[nodiscard]] double parse_number(const Setting& setting);
[[nodiscard]] int parse_integer(const Setting& setting);
[[nodiscard]] bool parse_bool(const Setting& setting);

/// Values as YAML spells them; numbers with as few digits as bring the same value back.
[[nodiscard]] std::string to_text(double value);
[[nodiscard]] std::string to_text(int value);
[[nodiscard]] std::string to_text(bool value);
[[nodiscard]] std::string to_text(const std::string& value);

}  // namespace berm
