#include "scan_names.hpp"

#include <algorithm>
#include <charconv>
#include <numeric>
#include <set>

namespace berm {
namespace {

constexpr std::string_view kDigits = "0123456789";
/// More do not fit into 64 bits.
constexpr std::size_t kMaxDigits = 18;
/// Numbers with more holes than this per scan do not count scans.
constexpr std::uint64_t kMaxHolesPerScan = 20;
constexpr std::size_t kMaxListed = 4;

/// Takes the longest run of digits, or else of other characters, off the front of `text`.
std::string_view take_run(std::string_view& text, bool digits) {
  const std::size_t end = digits ? text.find_first_not_of(kDigits) : text.find_first_of(kDigits);
  const std::string_view run = text.substr(0, end);
  text.remove_prefix(run.size());
  return run;
}

/// -1, 0 or 1 as two runs of digits compare as numbers.
int compare_numbers(std::string_view a, std::string_view b) {
  a.remove_prefix(std::min(a.find_first_not_of('0'), a.size()));
  b.remove_prefix(std::min(b.find_first_not_of('0'), b.size()));
  if (a.size() != b.size()) {
    return a.size() < b.size() ? -1 : 1;
  }
  return a.compare(b);
}

std::string_view trailing_digits(std::string_view name) {
  const std::size_t last_other = name.find_last_not_of(kDigits);
  return name.substr(last_other == std::string_view::npos ? 0 : last_other + 1);
}

std::string padded(std::uint64_t number, std::size_t width) {
  const std::string digits = std::to_string(number);
  return std::string(width - std::min(width, digits.size()), '0') + digits;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
  std::string_view rest_a = a;
  std::string_view rest_b = b;
  for (bool digits = false; !rest_a.empty() && !rest_b.empty(); digits = !digits) {
    const std::string_view run_a = take_run(rest_a, digits);
    const std::string_view run_b = take_run(rest_b, digits);
    const int order = digits ? compare_numbers(run_a, run_b) : run_a.compare(run_b);
    if (order != 0) {
      return order < 0;
    }
  }
  if (rest_a.empty() != rest_b.empty()) {
    return rest_a.empty();
  }
  return a < b;
}

std::optional<std::vector<std::uint64_t>> numbers_of(std::span<const std::string> names) {
  std::vector<std::uint64_t> numbers;
  numbers.reserve(names.size());
  for (const std::string& name : names) {
    const std::string_view digits = trailing_digits(name);
    const std::string_view prefix = std::string_view(name).substr(0, name.size() - digits.size());
    const std::string_view first = names.front();
    if (digits.empty() || digits.size() > kMaxDigits ||
        prefix != first.substr(0, first.size() - trailing_digits(first).size())) {
      return std::nullopt;
    }
    std::uint64_t number = 0;
    (void)std::from_chars(digits.data(), digits.data() + digits.size(), number);
    if (!numbers.empty() && number == numbers.back()) {
      return std::nullopt;
    }
    numbers.push_back(number);
  }
  return numbers;
}

std::optional<std::vector<std::size_t>> match_lines(std::span<const std::string> names, std::size_t lines) {
  std::vector<std::size_t> matched(names.size());
  if (lines == names.size()) {
    std::iota(matched.begin(), matched.end(), std::size_t{0});
    return matched;
  }
  const std::optional<std::vector<std::uint64_t>> numbers = numbers_of(names);
  if (!numbers || numbers->empty() || numbers->back() + 1 != lines) {
    return std::nullopt;
  }
  std::copy(numbers->begin(), numbers->end(), matched.begin());
  return matched;
}

std::string describe_line_mismatch(std::span<const std::string> names, std::size_t lines, std::string_view what) {
  std::string text = std::to_string(lines) + " " + std::string(what) + " for " + std::to_string(names.size()) +
                     " scans (" + names.front() + " to " + names.back() + "); expected one line per scan";
  if (const auto numbers = numbers_of(names)) {
    text += ", or " + std::to_string(numbers->back() + 1) + ", one per number from 0";
  }
  return text + "; remove the file to do without it";
}

std::optional<std::string> describe_gaps(std::span<const std::string> names) {
  const std::optional<std::vector<std::uint64_t>> numbers = numbers_of(names);
  if (!numbers || numbers->size() < 2) {
    return std::nullopt;
  }
  const std::uint64_t missing = numbers->back() - numbers->front() + 1 - numbers->size();
  if (missing == 0 || missing > kMaxHolesPerScan * numbers->size()) {
    return std::nullopt;
  }
  const std::size_t width = trailing_digits(names.front()).size();
  std::string list;
  std::size_t listed = 0;
  for (std::size_t i = 1; i < numbers->size(); ++i) {
    const std::uint64_t from = (*numbers)[i - 1] + 1;
    const std::uint64_t to = (*numbers)[i] - 1;
    if (from > to) {
      continue;
    }
    if (listed++ == kMaxListed) {
      list += ", ...";
      break;
    }
    list += (list.empty() ? "" : ", ") + padded(from, width) + (from < to ? ".." + padded(to, width) : "");
  }
  return std::to_string(missing) + (missing == 1 ? " number is" : " numbers are") +
         " missing from the names of the scans: " + list;
}

std::optional<std::string> describe_mixture(std::span<const std::string> names) {
  std::set<std::string, std::less<>> words;
  for (const std::string& name : names) {
    words.emplace(name.substr(0, name.find_first_of(kDigits)));
    if (words.size() > kMaxListed) {
      return std::nullopt;
    }
  }
  if (words.size() < 2) {
    return std::nullopt;
  }
  std::string list;
  for (const std::string& word : words) {
    list += (list.empty() ? "'" : ", '") + word + "'";
  }
  return "names start differently (" + list + "): are these scans of one recording?";
}

}  // namespace berm
