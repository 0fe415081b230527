#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "berm/core/error.hpp"
#include "berm/io/field_access.hpp"
#include "berm/io/file_reader.hpp"
#include "berm/io/setting.hpp"

/// Settings are plain structs of configurations (berm/core/config.hpp), one a section, which list them once:
///
///   struct Machine {
///     MountConfig mount;
///
///     static void sections(auto&& section) { section("mount", &Machine::mount); }
///     void check() const;  // throws ConfigError
///   };
///
/// Machines, sensors and scenarios are such structs, and a YAML file each.
namespace berm {

/// Larger files are refused: ten times the largest sensible one.
constexpr std::uint64_t kMaxSettingsBytes = 65'536;

template <typename Settings>
[[nodiscard]] std::vector<std::string> section_names() {
  std::vector<std::string> names;
  Settings::sections([&names](std::string_view name, auto) { names.emplace_back(name); });
  return names;
}

namespace detail {

/// Throws ConfigError: `kind` ("key", "section") `written` is none of `names`.
[[noreturn]] void refuse_unknown(const std::string& where, const std::string& key, const std::string& kind,
                                 const std::string& written, const std::vector<std::string>& names);

template <typename Settings>
void assign_setting(Settings& settings, const Setting& setting) {
  bool section_found = false;
  Settings::sections([&](std::string_view name, auto member) {
    if (name != setting.section) {
      return;
    }
    section_found = true;
    auto& config = settings.*member;
    if (!assign(config, setting)) {
      refuse_unknown(setting.where, setting.full_key(), "key", setting.key,
                     field_names<std::remove_reference_t<decltype(config)>>());
    }
  });
  if (!section_found) {
    refuse_unknown(setting.where, setting.section, "section", setting.section, section_names<Settings>());
  }
}

}  // namespace detail

/// Reads settings from the text of a YAML file: sections of `key: value`, every key optional but those of `required`
/// ("section.key"). `file` is for messages. Throws FileError if the text is no such file, and ConfigError with line and
/// key for an unknown or repeated key, a wrong type, or a value that is not allowed.
template <typename Settings>
[[nodiscard]] Settings parse_yaml(std::string_view yaml, const std::string& file,
                                  const std::vector<std::string>& required = {}) {
  Settings settings;
  std::set<std::string> given;
  for (const Setting& setting : parse_settings(yaml, file, section_names<Settings>().front())) {
    detail::assign_setting(settings, setting);
    given.insert(setting.full_key());
  }
  for (const std::string& key : required) {
    if (!given.contains(key)) {
      throw ConfigError(file, key, "is missing, add it: it has no default");
    }
  }
  try {
    settings.check();
  } catch (const ConfigError& error) {
    throw ConfigError(file, error.key(), error.problem());
  }
  return settings;
}

/// `parse_yaml` of the file's content. Throws FileError as `read_file` for more than `kMaxSettingsBytes`.
template <typename Settings>
[[nodiscard]] Settings read_yaml(const std::filesystem::path& file, const std::vector<std::string>& required = {}) {
  FileBuffer buffer;
  read_file(file, buffer, kMaxSettingsBytes);
  return parse_yaml<Settings>(buffer.text(), file.string(), required);
}

/// Sets one value from text like "ground.min_range_m=3", as strictly as a file would; returns the key that was set.
/// `where` names the origin in messages, such as "--set ground.min_range_m=3". Whether the values fit each other is
/// left to `Settings::check`, since more may follow.
template <typename Settings>
std::string set_value(Settings& settings, std::string_view assignment, const std::string& where) {
  const Setting setting = split_assignment(assignment, where);
  detail::assign_setting(settings, setting);
  return setting.full_key();
}

/// The settings as a YAML file with every key, its meaning and what is allowed; `parse_yaml` reads it back.
template <typename Settings>
[[nodiscard]] std::string to_yaml(const Settings& settings) {
  std::string yaml;
  Settings::sections([&](std::string_view name, auto member) {
    const auto& config = settings.*member;
    using Config = std::remove_cvref_t<decltype(config)>;
    yaml += (yaml.empty() ? "" : "\n") + std::string(name) + ":\n";
    Config::fields(EachField{
        [&](std::string_view key, auto field, const std::string& allowed, const auto& /*find*/, std::string_view text) {
          yaml += "  " + std::string(key) + ": " + setting_text(config.*field) + "  # " + std::string(text) + " (" +
                  allowed + ")\n";
        }});
  });
  return yaml;
}

}  // namespace berm
