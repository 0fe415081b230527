#include "berm/core/config.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "berm/core/error.hpp"

namespace berm {
namespace {

/// As few digits as tell `value` from its neighbours: a value just outside of a range must not print as its end.
std::string number_text(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

}  // namespace

std::string find_problem(double value, const Range& range) {
  if (std::isfinite(value) && value >= range.min && value <= range.max) {
    return {};
  }
  return number_text(value) + " is not allowed, expected " + number_text(range.min) + " to " + number_text(range.max);
}

std::string find_problem(std::string_view value, const Choices& choices) {
  const auto& names = choices.names;
  if (std::find(names.begin(), names.end(), value) != names.end()) {
    return {};
  }
  std::string problem = "'" + std::string(value) + "' is not allowed, expected ";
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) {
      problem += i + 1 == names.size() ? " or " : ", ";
    }
    problem += names[i];
  }
  return problem;
}

std::string find_problem(std::string_view value, const TextLimit& limit) {
  if (value.size() > limit.max_length) {
    return "the text has " + std::to_string(value.size()) + " bytes, expected at most " +
           std::to_string(limit.max_length);
  }
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  if (std::any_of(value.begin(), value.end(), is_control)) {
    return "the text holds control characters, expected one line of plain text";
  }
  return {};
}

void check_problem(std::string_view section, std::string_view key, const std::string& problem) {
  if (!problem.empty()) {
    throw ConfigError(std::string(section) + "." + std::string(key), problem);
  }
}

}  // namespace berm
