#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace berm {

/// Closed range of the values that a configuration key may take.
struct Range {
  double min = 0.0;
  double max = 0.0;
};

/// A configuration is a plain struct with defaults that lists its fields once, for everything that needs them
/// (checking, reading YAML, `--set`, printing):
///
///   struct SlopeConfig {
///     double min_range_m = 10.0;
///
///     static void fields(auto&& field) {
///       field("min_range_m", &SlopeConfig::min_range_m, Range{0.0, 200.0}, "nearest point that counts (P section 2.2)");
///     }
///     void check() const { check_fields(*this, "slope"); }
///   };
///
/// Fields are double, int or bool; a bool takes no range: `field(name, member, text)`.

/// Throws ConfigError naming `section.key`, the value and the range, if `value` is not finite or outside `range`.
void check_value(std::string_view section, std::string_view key, double value, const Range& range);

namespace detail {

template <typename Config>
struct FieldChecker {
  const Config& config;
  std::string_view section;

  template <typename Value>
  void operator()(std::string_view key, Value Config::*member, const Range& range, std::string_view /*text*/) const {
    check_value(section, key, static_cast<double>(config.*member), range);
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
