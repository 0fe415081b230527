#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "berm/core/config.hpp"
#include "berm/core/error.hpp"
#include "berm/pipeline/machine.hpp"
#include "field_text.hpp"
#include "setting.hpp"

namespace berm {

/// How a field is described to people.
[[nodiscard]] inline std::string allowed_text(const Range& range) {
  return to_text(range.min) + " to " + to_text(range.max);
}
[[nodiscard]] inline std::string allowed_text(const Choices& choices) {
  std::string text;
  for (const std::string_view name : choices.names) {
    text += (text.empty() ? "" : " | ") + std::string(name);
  }
  return text;
}
[[nodiscard]] inline std::string allowed_text(const TextLimit& /*limit*/) {
  return "text";
}

/// Visitor of `Config::fields` that takes any field as (key, member, allowed text, problem of a value, text).
template <typename Action>
struct EachField {
  Action action;

  template <typename Config, typename Value, typename Allowed>
  void operator()(std::string_view key, Value Config::*member, const Allowed& allowed, std::string_view text) const {
    const auto find = [&allowed](const Value& value) {
      if constexpr (std::is_arithmetic_v<Value>) {
        return find_problem(static_cast<double>(value), allowed);
      } else {
        return find_problem(value, allowed);
      }
    };
    action(key, member, allowed_text(allowed), find, text);
  }
  template <typename Config>
  void operator()(std::string_view key, bool Config::*member, std::string_view text) const {
    action(
        key, member, std::string("true | false"), [](bool) { return std::string(); }, text);
  }
};
template <typename Action>
EachField(Action) -> EachField<Action>;

inline void parse_into(double& value, const Setting& setting) {
  value = parse_number(setting);
}
inline void parse_into(int& value, const Setting& setting) {
  value = parse_integer(setting);
}
inline void parse_into(bool& value, const Setting& setting) {
  value = parse_bool(setting);
}
inline void parse_into(std::string& value, const Setting& setting) {
  value = setting.text;
}

/// Sets the field that `setting` names; returns false if `config` has no such field.
template <typename Config>
[[nodiscard]] bool assign(Config& config, const Setting& setting) {
  bool found = false;
  Config::fields(EachField{[&](std::string_view key, auto member, const std::string& /*allowed*/, const auto& find,
                               std::string_view /*text*/) {
    if (key != setting.key) {
      return;
    }
    auto value = config.*member;
    parse_into(value, setting);
    const std::string problem = find(value);
    if (!problem.empty()) {
      throw ConfigError(setting.where, setting.full_key(), problem);
    }
    config.*member = value;
    found = true;
  }});
  return found;
}

template <typename Config>
[[nodiscard]] std::vector<std::string> field_names() {
  std::vector<std::string> names;
  Config::fields(EachField{[&names](std::string_view key, auto&&...) { names.emplace_back(key); }});
  return names;
}

}  // namespace berm
