#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/io/setting.hpp"

namespace berm {
namespace {

[[noreturn]] void wrong_type(const Setting& setting, const std::string& expected) {
  const std::string found = setting.text.empty() ? "nothing" : "'" + setting.text.substr(0, 60) + "'";
  throw ConfigError(setting.where, setting.full_key(),
                    "expected " + expected + " and found " + found + (setting.quoted ? " in quotes" : ""));
}

template <typename Value>
bool parse_whole(const std::string& text, Value& value) {
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, value);
  return result.ec == std::errc() && result.ptr == end;
}

}  // namespace

void parse_into(double& value, const Setting& setting) {
  if (setting.quoted || !parse_whole(setting.text, value)) {
    wrong_type(setting, "a number");
  }
}

void parse_into(int& value, const Setting& setting) {
  if (setting.quoted || !parse_whole(setting.text, value)) {
    wrong_type(setting, "a whole number");
  }
}

void parse_into(bool& value, const Setting& setting) {
  if (setting.quoted || (setting.text != "true" && setting.text != "false")) {
    wrong_type(setting, "true or false");
  }
  value = setting.text == "true";
}

void parse_into(std::string& value, const Setting& setting) {
  value = setting.text;
}

std::string setting_text(double value) {
  return fmt::format("{}", value);
}

std::string setting_text(int value) {
  return std::to_string(value);
}

std::string setting_text(bool value) {
  return value ? "true" : "false";
}

std::string setting_text(const std::string& value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') {
      text += '\\';
    }
    text += c;
  }
  return text + '"';
}

std::string allowed_text(const Range& range) {
  return setting_text(range.min) + " to " + setting_text(range.max);
}

std::string allowed_text(const Choices& choices) {
  std::string text;
  for (const std::string_view name : choices.names) {
    text += (text.empty() ? "" : " | ") + std::string(name);
  }
  return text;
}

std::string allowed_text(const TextLimit& /*limit*/) {
  return "text";
}

}  // namespace berm
