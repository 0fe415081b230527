#include "berm/io/road_file.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "berm/core/angle.hpp"
#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/trajectory_file.hpp"
#include "csv_columns.hpp"
#include "line_reader.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

constexpr double kPercent = 0.01;

/// The columns of a table, one after the other; `Station` is const where they are written. A measure takes two.
template <typename Station, typename Visitor>
void visit_columns(Station& station, Visitor&& visit) {
  visit.piece("piece", station.piece);
  visit.number("chainage_m", station.chainage_m, 1.0);
  visit.number("x_m", station.position_m.x(), 1.0);
  visit.number("y_m", station.position_m.y(), 1.0);
  visit.number("z_m", station.position_m.z(), 1.0);
  visit.number("heading_deg", station.heading_rad, kRadPerDeg);
  visit.measure("left_m", station.left.edge_m, 1.0);
  visit.measure("right_m", station.right.edge_m, 1.0);
  visit.measure("width_m", station.width_m, 1.0);
  visit.measure("grade_percent", station.grade, kPercent);
  visit.measure("cross_fall_percent", station.cross_fall, kPercent);
  visit.measure("left_berm_height_m", station.left.berm_height_m, 1.0);
  visit.measure("left_berm_width_m", station.left.berm_width_m, 1.0);
  visit.measure("right_berm_height_m", station.right.berm_height_m, 1.0);
  visit.measure("right_berm_width_m", station.right.berm_width_m, 1.0);
  visit.verdict("width_rule", station.width_rule);
  visit.verdict("grade_rule", station.grade_rule);
  visit.verdict("left_berm_rule", station.left.berm_rule);
  visit.verdict("right_berm_rule", station.right.berm_rule);
}

/// "left_m" and "left_sigma_m": the unit stays last.
std::string sigma_name(std::string_view name) {
  const std::size_t unit = name.rfind('_');
  return std::string(name.substr(0, unit)) + "_sigma" + std::string(name.substr(unit));
}

class HeaderWriter {
 public:
  void piece(std::string_view name, std::uint32_t /*value*/) { add(name); }
  void number(std::string_view name, double /*value*/, double /*unit*/) { add(name); }
  void measure(std::string_view name, const std::optional<Measure>& /*value*/, double /*unit*/) {
    add(name);
    add(sigma_name(name));
  }
  void verdict(std::string_view name, RuleVerdict /*value*/) { add(name); }

  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  void add(std::string_view name) {
    text_ += text_.empty() ? "" : ",";
    text_ += name;
  }

  std::string text_;
};

std::string road_header() {
  HeaderWriter writer;
  const RoadStation station;
  visit_columns(station, writer);
  return writer.take();
}

class RowWriter {
 public:
  void piece(std::string_view /*name*/, std::uint32_t value) { text_ += std::to_string(value); }
  void number(std::string_view name, double value, double unit) {
    check(name, std::abs(value / unit) <= kMaxCoordinate_m, value);
    text_ += ',';
    append_fixed(text_, value / unit, kDecimals);
  }
  void measure(std::string_view name, const std::optional<Measure>& value, double unit) {
    if (!value) {
      text_ += ",,";
      return;
    }
    check(name, value->sigma >= 0.0, value->sigma);
    number(name, value->value, unit);
    number(name, value->sigma, unit);
  }
  void verdict(std::string_view /*name*/, RuleVerdict value) {
    text_ += ',';
    text_ += verdict_name(value);
  }

  [[nodiscard]] std::string take() { return std::move(text_); }

 private:
  static constexpr int kDecimals = 3;

  static void check(std::string_view name, bool fits, double value) {
    if (!fits) {
      throw Error(ErrorCode::invalid_argument, fmt::format("road: {} cannot be {}", name, value));
    }
  }

  std::string text_;
};

class RowReader {
 public:
  RowReader(const LineReader& lines, std::string_view row) : lines_(lines), rest_(row) {}

  void piece(std::string_view name, std::uint32_t& value) {
    const std::string_view text = take(name);
    const std::optional<double> number = parse_number(text);
    const bool whole = text.find_first_not_of("0123456789") == std::string_view::npos;
    if (!number || !whole || *number > std::numeric_limits<std::uint32_t>::max()) {
      throw lines_.error("expected a whole number in " + std::string(name) + ", found " + quoted(text));
    }
    value = static_cast<std::uint32_t>(*number);
  }
  void number(std::string_view name, double& value, double unit) {
    const std::string_view text = take(name);
    const std::optional<double> number = parse_number(text);
    if (!number || std::abs(*number) > kMaxCoordinate_m) {
      throw lines_.error("expected a number in " + std::string(name) + ", found " + quoted(text));
    }
    value = *number * unit;
  }
  void measure(std::string_view name, std::optional<Measure>& value, double unit) {
    const bool is_known = !peek().empty();
    if (is_known) {
      Measure found;
      number(name, found.value, unit);
      number(sigma_name(name), found.sigma, unit);
      if (found.sigma < 0.0) {
        throw lines_.error("expected a standard deviation in " + sigma_name(name) + ", found one below 0");
      }
      value = found;
      return;
    }
    static_cast<void>(take(name));
    if (const std::string_view text = take(sigma_name(name)); !text.empty()) {
      throw lines_.error("nothing in " + std::string(name) + ", but " + quoted(text) + " in " + sigma_name(name));
    }
  }
  void verdict(std::string_view name, RuleVerdict& value) {
    const std::string_view text = take(name);
    for (const RuleVerdict known :
         {RuleVerdict::unknown, RuleVerdict::holds, RuleVerdict::uncertain, RuleVerdict::broken}) {
      if (text == verdict_name(known)) {
        value = known;
        return;
      }
    }
    throw lines_.error("expected holds, uncertain, broken or nothing in " + std::string(name) + ", found " +
                       quoted(text));
  }

  void end() const {
    if (!at_end_) {
      throw lines_.error("more columns than the header has: " + quoted(rest_));
    }
  }

 private:
  [[nodiscard]] std::string_view peek() const {
    std::string_view rest = rest_;
    return take_column(rest);
  }

  std::string_view take(std::string_view name) {
    if (at_end_) {
      throw lines_.error("the line ends before " + std::string(name));
    }
    at_end_ = rest_.find(',') == std::string_view::npos;
    return take_column(rest_);
  }

  const LineReader& lines_;
  std::string_view rest_;
  bool at_end_ = false;
};

RoadStation read_row(const LineReader& lines, std::string_view row) {
  RoadStation station;
  RowReader reader(lines, row);
  visit_columns(station, reader);
  reader.end();
  return station;
}

std::vector<RoadStation> read_rows(LineReader& lines) {
  const std::string header = road_header();
  std::string_view line;
  if (!lines.next(line)) {
    throw lines.error("the file is empty, expected the header " + header);
  }
  if (line != header) {
    throw lines.error("expected the header " + header + ", found " + quoted(line));
  }
  std::vector<RoadStation> stations;
  while (lines.next(line)) {
    const RoadStation station = read_row(lines, line);
    if (!stations.empty() &&
        (station.piece < stations.back().piece || station.chainage_m < stations.back().chainage_m)) {
      throw lines.error("pieces and chainages must not fall; were the lines sorted by something else?");
    }
    stations.push_back(station);
  }
  return stations;
}

}  // namespace

std::string_view verdict_name(RuleVerdict verdict) {
  switch (verdict) {
    case RuleVerdict::holds:
      return "holds";
    case RuleVerdict::uncertain:
      return "uncertain";
    case RuleVerdict::broken:
      return "broken";
    case RuleVerdict::unknown:
      break;
  }
  return "";
}

void write_road(const std::filesystem::path& path, std::span<const RoadStation> stations) {
  AtomicFile file(path);
  file.write(road_header() + "\n");
  const RoadStation* last = nullptr;
  for (const RoadStation& station : stations) {
    if (last != nullptr && (station.piece < last->piece || station.chainage_m < last->chainage_m)) {
      throw Error(ErrorCode::invalid_argument, "road: pieces and chainages must not fall");
    }
    RowWriter writer;
    visit_columns(station, writer);
    file.write(writer.take() + "\n");
    last = &station;
  }
  file.commit();
}

std::vector<RoadStation> read_road(const std::filesystem::path& path) {
  LineReader lines(path);
  return read_rows(lines);
}

std::vector<RoadStation> read_road(std::istream& input, const std::string& name) {
  LineReader lines(input, name);
  return read_rows(lines);
}

}  // namespace berm
