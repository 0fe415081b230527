#include "berm/io/closest_name.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace berm {
namespace {

/// Levenshtein's distance: how many letters must be inserted, dropped or replaced.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string did_you_mean(std::string_view text, const std::vector<std::string>& names) {
  const std::string* best = nullptr;
  std::size_t best_distance = text.size() / 2 + 1;  // a name further away shares hardly a letter
  for (const std::string& name : names) {
    const bool hopeless = name.size() > 2 * text.size() + 2 || text.size() > 2 * name.size() + 2;
    const bool extends = !text.empty() && (name.starts_with(text) || text.starts_with(name));
    const std::size_t distance = hopeless ? best_distance : extends ? 0 : edit_distance(text, name);
    if (distance < best_distance) {
      best_distance = distance;
      best = &name;
    }
  }
  return best == nullptr ? "." : ", did you mean '" + *best + "'?";
}

std::string enumerate(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) {
      text += i + 1 == names.size() ? " or " : ", ";
    }
    text += names[i];
  }
  return text;
}

}  // namespace berm
