#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "berm/core/config.hpp"
#include "berm/core/error.hpp"
#include "berm/io/setting.hpp"

namespace berm {

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

/// Sets the field that `setting` names; returns false if `config` has no such field. Throws ConfigError for a value of
/// another type or outside of what is allowed.
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
