#include "berm/io/settings.hpp"

#include <map>
#include <sstream>
#include <utility>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "berm/core/error.hpp"
#include "berm/io/closest_name.hpp"
#include "berm/io/setting.hpp"

namespace berm {
namespace {

/// Takes the events of the parser and stops at the first that a settings file does not have. Nothing is built that
/// an alias could multiply.
class SettingReader final : public YAML::EventHandler {
 public:
  SettingReader(std::string file, std::string_view example)
      : file_(std::move(file)), expected_("expected sections such as '" + std::string(example) + ":' and found ") {}

  [[nodiscard]] std::vector<Setting> take() { return std::move(settings_); }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (std::exchange(started_, true)) {
      fail(mark, "a second document starts here, expected one");
    }
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override {
    if (depth_ == 0) {
      fail(mark, expected_ + "nothing");
    }
    if (!awaits_value_) {
      fail(mark, "expected a key and found nothing");
    }
    if (depth_ == 2) {
      throw ConfigError(place(key_mark_), section_ + "." + key_, "has no value");
    }
    awaits_value_ = false;  // an empty section keeps the defaults
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t /*anchor*/) override {
    fail(mark, "aliases (*name) are not allowed, write the value out");
  }

  void OnAnchor(const YAML::Mark& mark, const std::string& /*name*/) override {
    fail(mark, "anchors (&name) are not allowed, write the value out");
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t /*anchor*/,
                const std::string& value) override {
    if (tag != "?" && tag != "!" && !tag.empty()) {
      fail(mark, "tags (!name) are not allowed");
    }
    if (depth_ == 0) {
      fail(mark, expected_ + "'" + value.substr(0, 40) + "'");
    }
    if (!awaits_value_) {
      start_key(mark, value);
      return;
    }
    if (depth_ == 1) {
      throw ConfigError(place(mark), section_, "expected a section of 'key: value' lines and found one value");
    }
    settings_.push_back({place(mark), section_, key_, value, tag == "!"});
    awaits_value_ = false;
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                       YAML::EmitterStyle::value /*style*/) override {
    refuse_nested(mark, "a list");
  }
  void OnSequenceEnd() override {}

  void OnMapStart(const YAML::Mark& mark, const std::string& /*tag*/, YAML::anchor_t /*anchor*/,
                  YAML::EmitterStyle::value /*style*/) override {
    if (depth_ == 2 || (depth_ == 1 && !awaits_value_)) {
      refuse_nested(mark, "a section");
    }
    ++depth_;
    awaits_value_ = false;
  }

  void OnMapEnd() override {
    --depth_;
    awaits_value_ = false;
  }

 private:
  void start_key(const YAML::Mark& mark, const std::string& name) {
    std::string& current = depth_ == 1 ? section_ : key_;
    current = name;
    key_mark_ = mark;
    const std::string full = depth_ == 1 ? name : section_ + "." + name;
    const auto [seen, is_new] = lines_.emplace(full, mark.line + 1);
    if (!is_new) {
      throw ConfigError(place(mark), full, "is given twice, first in line " + std::to_string(seen->second));
    }
    awaits_value_ = true;
  }

  [[noreturn]] void refuse_nested(const YAML::Mark& mark, const std::string& found) const {
    if (awaits_value_) {
      const std::string expected = depth_ == 1 ? "a section of 'key: value' lines" : "one value";
      throw ConfigError(place(mark), depth_ == 1 ? section_ : section_ + "." + key_,
                        "expected " + expected + " and found " + found);
    }
    fail(mark, expected_ + found);
  }

  [[nodiscard]] std::string place(const YAML::Mark& mark) const {
    return file_ + ": line " + std::to_string(mark.line + 1);
  }

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& problem) const {
    throw FileError(ErrorCode::malformed, place(mark), std::nullopt, problem);
  }

  std::string file_;
  std::string expected_;
  std::vector<Setting> settings_;
  std::map<std::string, int> lines_;
  std::string section_;
  std::string key_;
  YAML::Mark key_mark_;  ///< the parser reports a missing value where the next line begins
  int depth_ = 0;
  bool awaits_value_ = false;
  bool started_ = false;
};

}  // namespace

std::vector<Setting> parse_settings(std::string_view yaml, const std::string& file, std::string_view example) {
  SettingReader reader(file, example);
  std::istringstream stream{std::string(yaml)};
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(reader)) {
    }
  } catch (const YAML::Exception& error) {
    const std::string place = error.mark.is_null() ? file : file + ": line " + std::to_string(error.mark.line + 1);
    throw FileError(ErrorCode::malformed, place, std::nullopt, "no valid YAML: " + error.msg);
  }
  return reader.take();
}

Setting split_assignment(std::string_view assignment, const std::string& where) {
  const std::size_t equals = assignment.find('=');
  const std::size_t dot = assignment.find('.');
  if (equals == std::string_view::npos || dot == std::string_view::npos || dot > equals) {
    throw ConfigError(where, std::string(assignment.substr(0, equals)),
                      "expected SECTION.KEY=VALUE, such as mount.height_m=2.3");
  }
  return {where, std::string(assignment.substr(0, dot)), std::string(assignment.substr(dot + 1, equals - dot - 1)),
          std::string(assignment.substr(equals + 1)), false};
}

void detail::refuse_unknown(const std::string& where, const std::string& key, const std::string& kind,
                            const std::string& written, const std::vector<std::string>& names) {
  throw ConfigError(where, key, "unknown " + kind + did_you_mean(written, names) + " Allowed: " + enumerate(names));
}

}  // namespace berm
