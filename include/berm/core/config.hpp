#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace berm {

/// Closed range of the values that a configuration key may take.
struct Range {
  double min = 0.0;
  double max = 0.0;
};

/// The names that a text key may take.
struct Choices {
  std::vector<std::string_view> names;
};

/// Free text up to a length, on one line.
struct TextLimit {
  std::size_t max_length = 0;
};

/// A configuration is a plain struct with defaults that lists its fields once, for everything that needs them
/// (checking, reading YAML, `--set`, printing):
///
///   struct SlopeConfig {
///     double min_range_m = 10.0;
///
///     static void fields(auto&& field) {
///       field("min_range_m", &SlopeConfig::min_range_m, Range{0.0, 200.0}, "nearest point that counts (P
///       section 2.2)");
///     }
///     void check() const { check_fields(*this, "slope"); }
///   };
///
/// Fields are double or int with a Range, std::string with Choices or a TextLimit, or bool, which takes neither:
/// `field(name, member, text)`.

/// What is wrong with `value`, and what is allowed; empty if nothing is. NaN and infinities are always wrong.
[[nodiscard]] std::string find_problem(double value, const Range& range);
[[nodiscard]] std::string find_problem(std::string_view value, const Choices& choices);
[[nodiscard]] std::string find_problem(std::string_view value, const TextLimit& limit);

/// Throws ConfigError naming `section.key` and `problem` unless `problem` is empty.
void check_problem(std::string_view section, std::string_view key, const std::string& problem);

namespace detail {

template <typename Config>
struct FieldChecker {
  const Config& config;
  std::string_view section;

  template <typename Value>
  void operator()(std::string_view key, Value Config::*member, const Range& range, std::string_view /*text*/) const {
    check_problem(section, key, find_problem(static_cast<double>(config.*member), range));
  }
  void operator()(std::string_view key, std::string Config::*member, const Choices& choices,
                  std::string_view /*text*/) const {
    check_problem(section, key, find_problem(config.*member, choices));
  }
  void operator()(std::string_view key, std::string Config::*member, const TextLimit& limit,
                  std::string_view /*text*/) const {
    check_problem(section, key, find_problem(config.*member, limit));
  }
  void operator()(std::string_view /*key*/, bool Config::* /*member*/, std::string_view /*text*/) const {}
};

}  // namespace detail

/// Checks every field of `config` against its range; throws ConfigError for the first that is outside.
template <typename Config>
void check_fields(const Config& config, std::string_view section) {
  Config::fields(detail::FieldChecker<Config>{config, section});
}

}  // namespace berm
