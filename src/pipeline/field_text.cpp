#include "field_text.hpp"

#include <charconv>
#include <system_error>

#include <fmt/format.h>

#include "berm/core/error.hpp"

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

double parse_number(const Setting& setting) {
  double value = 0.0;
  if (setting.quoted || !parse_whole(setting.text, value)) {
    wrong_type(setting, "a number");
  }
  return value;
}

int parse_integer(const Setting& setting) {
  int value = 0;
  if (setting.quoted || !parse_whole(setting.text, value)) {
    wrong_type(setting, "a whole number");
  }
  return value;
}

bool parse_bool(const Setting& setting) {
  if (setting.quoted || (setting.text != "true" && setting.text != "false")) {
    wrong_type(setting, "true or false");
  }
  return setting.text == "true";
}

std::string to_text(double value) {
  return fmt::format("{}", value);
}

std::string to_text(int value) {
  return std::to_string(value);
}

std::string to_text(bool value) {
  return value ? "true" : "false";
}

std::string to_text(const std::string& value) {
  std::string text = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') {
      text += '\\';
    }
    text += c;
  }
  return text + '"';
}

}  // namespace berm
