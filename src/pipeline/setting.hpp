#pragma once

#include <string>
#include <string_view>
#include <vector>

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
/// no tags, so that a small file stays small. Throws FileError or ConfigError naming file and line.
[[nodiscard]] std::vector<Setting> parse_settings(std::string_view yaml, const std::string& file);

}  // namespace berm
