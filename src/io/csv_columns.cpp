#include "csv_columns.hpp"

#include <cstddef>

namespace berm {

std::string_view take_column(std::string_view& line) {
  constexpr std::string_view kBlanks = " \t";
  const std::size_t comma = line.find(',');
  std::string_view column = line.substr(0, comma);
  line = comma == std::string_view::npos ? std::string_view() : line.substr(comma + 1);
  const std::size_t begin = column.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) {
    return {};
  }
  column.remove_prefix(begin);
  return column.substr(0, column.find_last_not_of(kBlanks) + 1);
}

}  // namespace berm
