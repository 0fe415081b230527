#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "berm/core/stamp.hpp"

namespace berm {

/// The whole of `text` as a finite decimal number, whatever the locale; none for anything else.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// The whole of `text`, seconds in decimal ("12.5", "1.25e+01"), as the nearest nanosecond without a detour over a
/// double, which at today's epoch would only resolve 240 ns. None if it is no number or outside +-292 years.
[[nodiscard]] std::optional<Stamp> parse_seconds(std::string_view text);

/// Appends seconds with 9 decimals; `parse_seconds` gives the same stamp back.
void append_seconds(std::string& text, Stamp stamp_ns);

/// Appends `value` with `decimals` digits behind the point, never as "-0.000".
void append_fixed(std::string& text, double value, int decimals);

/// Appends `value` with as few digits as bring it back.
void append_shortest(std::string& text, double value);

/// Appends `value` as "-1.234e+00" with `decimals` digits behind the point, never as "-0.000e+00".
void append_scientific(std::string& text, double value, int decimals);

}  // namespace berm
