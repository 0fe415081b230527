#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "berm/core/config.hpp"

namespace berm {

/// One value that somebody wrote: where, for which key, and its text.
struct Setting {
  std::string where;  ///< file and line, or the argument
  std::string section;
  std::string key;
  std::string text;
  bool quoted = false;  ///< written in quotes, hence text and never a number

  [[nodiscard]] std::string full_key() const { return section + "." + key; }
};

/// The settings of a YAML text that holds sections of `key: value` and nothing else: no lists, no anchors, no aliases,
/// no tags, so that a small file stays small. Throws FileError or ConfigError naming file and line; messages name
/// `example` as a section.
[[nodiscard]] std::vector<Setting> parse_settings(std::string_view yaml, const std::string& file,
                                                  std::string_view example);

/// Splits "SECTION.KEY=VALUE" as it is given to `--set`. Throws ConfigError naming `where` for any other text.
[[nodiscard]] Setting split_assignment(std::string_view assignment, const std::string& where);

/// Parse the text of `setting`; throw ConfigError saying which type was expected if it is no such value.
void parse_into(double& value, const Setting& setting);
void parse_into(int& value, const Setting& setting);
void parse_into(bool& value, const Setting& setting);
void parse_into(std::string& value, const Setting& setting);

/// Values as YAML spells them; numbers with as few digits as bring the same value back.
[[nodiscard]] std::string setting_text(double value);
[[nodiscard]] std::string setting_text(int value);
[[nodiscard]] std::string setting_text(bool value);
[[nodiscard]] std::string setting_text(const std::string& value);

/// What a field may be, as it is described to people.
[[nodiscard]] std::string allowed_text(const Range& range);
[[nodiscard]] std::string allowed_text(const Choices& choices);
[[nodiscard]] std::string allowed_text(const TextLimit& limit);

}  // namespace berm
