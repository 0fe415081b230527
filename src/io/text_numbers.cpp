#include "text_numbers.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <system_error>

namespace berm {
namespace {

constexpr int kDecimalsOfNanoseconds = 9;
/// No stamp has more digits in front of the point, or shifts its point further.
constexpr int kMaxExponent = 100;
/// Enough for -DBL_MAX in fixed notation.
constexpr std::size_t kNumberBuffer = 512;

/// A decimal number as written: digits without the point, and how far left of its place the point stands.
struct Decimal {
  bool negative = false;
  std::string_view whole;
  std::string_view fraction;
  int exponent = 0;
};

std::string_view take_digits(std::string_view& text) {
  const std::size_t count = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string_view digits = text.substr(0, count);
  text.remove_prefix(count);
  return digits;
}

std::optional<int> parse_exponent(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
  }
  int exponent = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), exponent);
  if (error != std::errc() || end != text.data() + text.size() || std::abs(exponent) > kMaxExponent) {
    return std::nullopt;
  }
  return exponent;
}

std::optional<Decimal> split_decimal(std::string_view text) {
  Decimal decimal;
  if (text.starts_with('-')) {
    decimal.negative = true;
    text.remove_prefix(1);
  }
  decimal.whole = take_digits(text);
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    decimal.fraction = take_digits(text);
  }
  if (decimal.whole.empty() && decimal.fraction.empty()) {
    return std::nullopt;
  }
  if (text.starts_with('e') || text.starts_with('E')) {
    const std::optional<int> exponent = parse_exponent(text.substr(1));
    if (!exponent) {
      return std::nullopt;
    }
    decimal.exponent = *exponent;
    return decimal;
  }
  return text.empty() ? std::optional(decimal) : std::nullopt;
}

/// 10 `value` + `digit`, none on overflow.
std::optional<Stamp> shift_in(Stamp value, int digit) {
  constexpr Stamp kMax = std::numeric_limits<Stamp>::max();
  if (value > (kMax - digit) / 10) {
    return std::nullopt;
  }
  return 10 * value + digit;
}

/// The digits of `decimal` in front of the nanosecond point, rounded half up.
std::optional<Stamp> nanoseconds(const Decimal& decimal) {
  const auto digits = static_cast<std::ptrdiff_t>(decimal.whole.size() + decimal.fraction.size());
  const std::ptrdiff_t kept =
      static_cast<std::ptrdiff_t>(decimal.whole.size()) + decimal.exponent + kDecimalsOfNanoseconds;
  const auto digit_at = [&](std::ptrdiff_t place) {
    const auto i = static_cast<std::size_t>(place);
    const std::size_t whole = decimal.whole.size();
    return (i < whole ? decimal.whole[i] : decimal.fraction[i - whole]) - '0';
  };
  Stamp value = 0;
  for (std::ptrdiff_t place = 0; place < kept; ++place) {
    if (place >= digits && value == 0) {
      return 0;
    }
    const std::optional<Stamp> longer = shift_in(value, place < digits ? digit_at(place) : 0);
    if (!longer) {
      return std::nullopt;
    }
    value = *longer;
  }
  const bool up = kept >= 0 && kept < digits && digit_at(kept) >= 5;
  if (up && value == std::numeric_limits<Stamp>::max()) {
    return std::nullopt;
  }
  return value + (up ? 1 : 0);
}

void append_formatted(std::string& text, double value, std::chars_format format, int decimals) {
  std::array<char, kNumberBuffer> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, decimals);
  const std::string_view number(buffer.data(),
                                error == std::errc() ? static_cast<std::size_t>(end - buffer.data()) : 0);
  const std::string_view mantissa = number.substr(0, number.find('e'));
  const bool negative_zero = number.starts_with('-') && mantissa.find_first_not_of("-0.") == std::string_view::npos;
  text += number.substr(negative_zero ? 1 : 0);
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::optional<Stamp> parse_seconds(std::string_view text) {
  const std::optional<Decimal> decimal = split_decimal(text);
  if (!decimal) {
    return std::nullopt;
  }
  const std::optional<Stamp> magnitude = nanoseconds(*decimal);
  return magnitude && decimal->negative ? std::optional(-*magnitude) : magnitude;
}

void append_seconds(std::string& text, Stamp stamp_ns) {
  constexpr std::uint64_t kPerSecond = 1'000'000'000;
  const bool negative = stamp_ns < 0;
  // Unsigned negation, since the smallest stamp has no positive counterpart.
  const auto bits = static_cast<std::uint64_t>(stamp_ns);
  const std::uint64_t magnitude = negative ? std::uint64_t{0} - bits : bits;
  const std::string fraction = std::to_string(magnitude % kPerSecond);
  text += negative ? "-" : "";
  text += std::to_string(magnitude / kPerSecond);
  text += '.';
  text.append(kDecimalsOfNanoseconds - fraction.size(), '0');
  text += fraction;
}

void append_fixed(std::string& text, double value, int decimals) {
  append_formatted(text, value, std::chars_format::fixed, decimals);
}

void append_shortest(std::string& text, double value) {
  std::array<char, kNumberBuffer> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), result.ptr);
}

void append_scientific(std::string& text, double value, int decimals) {
  append_formatted(text, value, std::chars_format::scientific, decimals);
}

}  // namespace berm
