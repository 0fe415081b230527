#include "berm/io/edge_lines_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "berm/io/atomic_file.hpp"
#include "berm/io/trajectory_file.hpp"
#include "csv_columns.hpp"
#include "edge_row.hpp"
#include "geo_lines.hpp"
#include "line_reader.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

constexpr std::string_view kHeader = "line,side,x,y,z,confidence,berm_height_m";
/// Before lines had heights.
constexpr std::string_view kBareHeader = "line,side,x,y,z,confidence";
constexpr int kDecimals = 3;
/// Numbers are whole up to here in a double.
constexpr double kMaxNumber = 9e15;

class EdgeLinesReader {
 public:
  explicit EdgeLinesReader(LineReader& lines) : lines_(lines) {}

  std::vector<EdgeLine> read() {
    std::string_view line;
    if (!lines_.next(line)) {
      throw lines_.error("the file is empty, expected the header " + std::string(kHeader));
    }
    has_heights_ = line.find(kHeader.substr(kBareHeader.size())) != std::string_view::npos;
    check_edge_header(lines_, line, has_heights_ ? kHeader : kBareHeader);
    while (lines_.next(line)) {
      take_vertex(line);
    }
    end_line();
    return std::move(edges_);
  }

 private:
  void take_vertex(std::string_view line) {
    std::string_view rest = line;
    const std::uint64_t number = take_number(rest);
    const EdgeSide side = take_side(lines_, rest, 2, kHeader);
    const Eigen::Vector3d position_m = take_position_m(lines_, line, rest, false);
    const auto commas = std::count(rest.begin(), rest.end(), ',');
    const std::string_view text = take_column(rest);
    const std::optional<double> confidence = parse_number(text);
    if (commas != (has_heights_ ? 1 : 0) || !confidence || !(*confidence >= 0.0 && *confidence <= 1.0)) {
      throw lines_.error("expected a confidence of 0 to 1 in column 6 of " + std::to_string(has_heights_ ? 7 : 6) +
                         ", found " + quoted(text));
    }
    const std::optional<double> height_m = has_heights_ ? take_height_m(rest) : std::nullopt;
    if (number_ != number) {
      begin_line(number, side);
    }
    if (edges_.back().side != side) {
      throw lines_.error("the side changes within line " + std::to_string(number));
    }
    edges_.back().vertices.push_back({position_m, *confidence, height_m});
  }

  [[nodiscard]] std::uint64_t take_number(std::string_view& rest) const {
    const std::string_view text = take_column(rest);
    const std::optional<double> number = parse_number(text);
    const bool whole = text.find_first_not_of("0123456789") == std::string_view::npos;
    if (!number || !whole || *number > kMaxNumber) {
      throw lines_.error("expected the number of the line in column 1, found " + quoted(text));
    }
    return static_cast<std::uint64_t>(*number);
  }

  [[nodiscard]] std::optional<double> take_height_m(std::string_view& rest) const {
    const std::string_view text = take_column(rest);
    if (text.empty()) {
      return std::nullopt;
    }
    const std::optional<double> height_m = parse_number(text);
    if (!height_m || !(std::abs(*height_m) <= kMaxCoordinate_m)) {
      throw lines_.error("expected the height of the berm in metres or nothing in column 7, found " + quoted(text));
    }
    return height_m;
  }

  void begin_line(std::uint64_t number, EdgeSide side) {
    end_line();
    if (number_ && number < *number_) {
      throw lines_.error("line " + std::to_string(number) + " comes after line " + std::to_string(*number_) +
                         "; sort the rows by the number of the line");
    }
    number_ = number;
    edges_.push_back({side, {}});
  }

  void end_line() const {
    if (number_ && edges_.back().vertices.size() < 2) {
      throw lines_.error("line " + std::to_string(*number_) + " has one vertex, expected at least two");
    }
  }

  LineReader& lines_;
  bool has_heights_ = false;
  std::vector<EdgeLine> edges_;
  std::optional<std::uint64_t> number_;
};

}  // namespace

std::vector<EdgeLine> read_edge_lines(const std::filesystem::path& path) {
  LineReader lines(path);
  return EdgeLinesReader(lines).read();
}

std::vector<EdgeLine> read_edge_lines(std::istream& input, const std::string& name) {
  LineReader lines(input, name);
  return EdgeLinesReader(lines).read();
}

void write_edge_lines(const std::filesystem::path& path, std::span<const EdgeLine> lines) {
  check_edge_lines(lines);
  AtomicFile file(path);
  file.write(std::string(kHeader) + "\n");
  std::string row;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::string begin = std::to_string(i) + "," + std::string(side_name(lines[i].side));
    for (const EdgeLine::Vertex& vertex : lines[i].vertices) {
      row = begin;
      append_position(row, vertex.position_m);
      row += ',';
      append_fixed(row, vertex.confidence, kDecimals);
      row += ',';
      if (vertex.berm_height_m) {
        append_fixed(row, *vertex.berm_height_m, kDecimals);
      }
      file.write(row + "\n");
    }
  }
  file.commit();
}

}  // namespace berm
