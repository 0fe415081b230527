#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace berm {

/// Order of names as people number them: runs of digits compare as numbers of any length, so that "scan2" comes before
/// "scan10". A strict total order: names that number alike ("1", "01") compare as text.
[[nodiscard]] bool natural_less(std::string_view a, std::string_view b);

/// The number at the end of every name, if all have one (at most 18 digits), all text before it is the same, and no two
/// numbers are equal; none otherwise. `names` in natural order give increasing numbers.
[[nodiscard]] std::optional<std::vector<std::uint64_t>> numbers_of(std::span<const std::string> names);

/// Which line of a file with one line per scan belongs to each scan: the i-th where there are as many lines as scans;
/// the one with the scan's number, counted from 0, where there are as many lines as the highest number + 1. None
/// otherwise.
[[nodiscard]] std::optional<std::vector<std::size_t>> match_lines(std::span<const std::string> names,
                                                                  std::size_t lines);

/// What is wrong where `match_lines` finds nothing, and what to do; `what` names the lines: "stamps".
[[nodiscard]] std::string describe_line_mismatch(std::span<const std::string> names, std::size_t lines,
                                                 std::string_view what);

/// A sentence about the numbers that are missing between the first and the last name; none where none are, or where
/// the numbers are so sparse that they cannot count scans (times of day, say).
[[nodiscard]] std::optional<std::string> describe_gaps(std::span<const std::string> names);

/// A sentence where the names start with different words, as if several series lay in one folder; none otherwise.
[[nodiscard]] std::optional<std::string> describe_mixture(std::span<const std::string> names);

}  // namespace berm
