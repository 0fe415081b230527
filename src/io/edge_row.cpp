#include "edge_row.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "berm/io/trajectory_file.hpp"
#include "csv_columns.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

constexpr int kRowDecimals = 3;

}  // namespace

void check_edge_header(const LineReader& lines, std::string_view line, std::string_view header) {
  std::string_view rest = line;
  if (take_word(rest) != header || !take_word(rest).empty()) {
    throw lines.error("expected the header " + std::string(header) + ", found " + quoted(line));
  }
}

EdgeSide take_side(const LineReader& lines, std::string_view& rest, int column, std::string_view header) {
  const std::string_view side = take_column(rest);
  if (side != "left" && side != "right") {
    throw lines.error("expected left or right in column " + std::to_string(column) + ", found " + quoted(side) +
                      "; a line holds " + std::string(header));
  }
  return side == "left" ? EdgeSide::left : EdgeSide::right;
}

Eigen::Vector3d take_position_m(const LineReader& lines, std::string_view line, std::string_view& rest, bool is_end) {
  Eigen::Vector3d position_m;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const bool last = rest.find(',') == std::string_view::npos;
    const std::optional<double> value = parse_number(take_column(rest));
    if (last != (i == 2 && is_end) || !value || std::abs(*value) > kMaxCoordinate_m) {
      throw lines.error("expected three coordinates in metres after the side, found " + quoted(line));
    }
    position_m[i] = *value;
  }
  return position_m;
}

void append_position(std::string& text, const Eigen::Vector3d& position_m) {
  for (const double value : {position_m.x(), position_m.y(), position_m.z()}) {
    text += ',';
    append_fixed(text, value, kRowDecimals);
  }
}

}  // namespace berm
