#include "ascii_grid.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/io/height_raster.hpp"
#include "berm/io/trajectory_file.hpp"
#include "line_reader.hpp"
#include "lower_case.hpp"
#include "raster_check.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";

/// The words of a text one by one, and where the last one was.
class WordReader {
 public:
  WordReader(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  /// Empty at the end.
  std::string_view next() {
    start_ = std::min(text_.find_first_not_of(kBlanks, end_), text_.size());
    end_ = std::min(text_.find_first_of(kBlanks, start_), text_.size());
    return text_.substr(start_, end_ - start_);
  }
  [[nodiscard]] std::size_t bytes_left() const { return text_.size() - end_; }
  /// The word that was read last is to be read again.
  void put_back() { end_ = start_; }

  [[nodiscard]] FileError error(ErrorCode code, const std::string& problem) const {
    const auto line = 1 + std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(start_), '\n');
    return {code, name_, start_, fmt::format("line {}: {}", line, problem)};
  }
  [[nodiscard]] FileError error(const std::string& problem) const { return error(ErrorCode::malformed, problem); }

 private:
  std::string_view text_;
  const std::string& name_;
  std::size_t start_ = 0;
  std::size_t end_ = 0;
};

/// What stands in front of the heights.
struct GridHeader {
  std::optional<std::uint64_t> columns;
  std::optional<std::uint64_t> rows;
  std::optional<double> x_m;
  std::optional<double> y_m;
  bool x_is_center = false;
  bool y_is_center = false;
  std::optional<double> cell_m;
  std::optional<double> cell_x_m;  ///< GDAL writes dx and dy where cells are not square
  std::optional<double> cell_y_m;
  std::optional<double> nodata;  ///< may be NaN
};

class HeaderReader {
 public:
  explicit HeaderReader(WordReader& words) : words_(words) {}

  GridHeader read() {
    while (true) {
      const std::string_view word = words_.next();
      const bool is_key = !word.empty() && ((word[0] | 0x20) >= 'a' && (word[0] | 0x20) <= 'z');
      if (!is_key || lower_case(word) == "nan") {
        words_.put_back();
        break;
      }
      take(std::string(word));
    }
    demand(header_.columns.has_value(), "ncols");
    demand(header_.rows.has_value(), "nrows");
    demand(header_.x_m.has_value(), "xllcorner");
    demand(header_.y_m.has_value(), "yllcorner");
    demand(header_.cell_m.has_value() || (header_.cell_x_m && header_.cell_y_m), "cellsize");
    return header_;
  }

 private:
  void take(const std::string& word) {
    const std::string key = lower_case(word);
    if (key == "ncols") {
      take_count(word, header_.columns);
    } else if (key == "nrows") {
      take_count(word, header_.rows);
    } else if (key == "xllcorner" || key == "xllcenter") {
      take_number(word, header_.x_m, kMaxCoordinate_m);
      header_.x_is_center = key == "xllcenter";
    } else if (key == "yllcorner" || key == "yllcenter") {
      take_number(word, header_.y_m, kMaxCoordinate_m);
      header_.y_is_center = key == "yllcenter";
    } else if (key == "cellsize") {
      take_number(word, header_.cell_m, kMaxCoordinate_m);
    } else if (key == "dx") {
      take_number(word, header_.cell_x_m, kMaxCoordinate_m);
    } else if (key == "dy") {
      take_number(word, header_.cell_y_m, kMaxCoordinate_m);
    } else if (key == "nodata_value") {
      take_nodata(word);
    } else {
      throw words_.error(
          fmt::format("{} is no key of an ESRI ASCII grid, expected ncols, nrows, xllcorner, yllcorner, "
                      "cellsize and NODATA_value",
                      berm::quoted(word)));
    }
  }

  template <typename Value>
  void refuse_second(const std::string& key, const std::optional<Value>& value) const {
    if (value) {
      throw words_.error(fmt::format("{} is given twice", berm::quoted(key)));
    }
  }

  void take_count(const std::string& key, std::optional<std::uint64_t>& count) {
    refuse_second(key, count);
    const std::string_view word = words_.next();
    std::uint64_t value = 0;
    const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (problem != std::errc() || end != word.data() + word.size() || value == 0) {
      throw words_.error(
          fmt::format("expected the number of cells after {}, found {}", berm::quoted(key), quoted(word)));
    }
    count = value;
  }

  void take_number(const std::string& key, std::optional<double>& number, double limit) {
    refuse_second(key, number);
    const std::string_view word = words_.next();
    const std::optional<double> value = parse_number(word);
    if (!value || std::abs(*value) > limit) {
      throw words_.error(
          fmt::format("expected a number of metres after {}, found {}", berm::quoted(key), quoted(word)));
    }
    number = value;
  }

  void take_nodata(const std::string& key) {
    refuse_second(key, header_.nodata);
    const std::string_view word = words_.next();
    header_.nodata = lower_case(word) == "nan" ? std::numeric_limits<double>::quiet_NaN() : parse_number(word);
    if (!header_.nodata) {
      throw words_.error(fmt::format("expected a number after {}, found {}", berm::quoted(key), quoted(word)));
    }
  }

  void demand(bool given, std::string_view key) const {
    if (!given) {
      throw words_.error(fmt::format("the header ends here without '{}'; is this an ESRI ASCII grid?", key));
    }
  }

  WordReader& words_;
  GridHeader header_;
};

class GridParser {
 public:
  GridParser(std::string_view text, const std::string& name) : words_(text, name), name_(name) {}

  void read_header() {
    header_ = HeaderReader(words_).read();
    raster_.cell_m = cell_size();
    check_cell_size(name_, raster_.cell_m);
    check_raster_size(name_, *header_.columns, *header_.rows);
    raster_.columns = *header_.columns;
    raster_.rows = *header_.rows;
    raster_.origin_x_m = *header_.x_m - (header_.x_is_center ? 0.5 * raster_.cell_m : 0.0);
    raster_.origin_y_m = *header_.y_m - (header_.y_is_center ? 0.5 * raster_.cell_m : 0.0);
  }

  HeightRaster parse() {
    read_header();
    check_bytes();
    read_heights();
    if (const std::string_view extra = words_.next(); !extra.empty()) {
      throw words_.error(fmt::format("{} follows the last of {} heights", quoted(extra), raster_.heights_m.size()));
    }
    check_has_heights(name_, raster_);
    return std::move(raster_);
  }

 private:
  [[nodiscard]] double cell_size() const {
    if (header_.cell_m) {
      return *header_.cell_m;
    }
    if (*header_.cell_x_m != *header_.cell_y_m) {
      throw FileError(ErrorCode::unsupported, name_, std::nullopt,
                      fmt::format("cells of {} x {} m are not square; resample the model with gdalwarp -tr",
                                  *header_.cell_x_m, *header_.cell_y_m));
    }
    return *header_.cell_x_m;
  }

  /// Every height takes a digit, and a blank between.
  void check_bytes() const {
    const std::uint64_t needed = 2 * raster_.columns * raster_.rows - 1;
    if (words_.bytes_left() < needed) {
      throw words_.error(ErrorCode::truncated, fmt::format("{} x {} heights take at least {} bytes, {} are left",
                                                           raster_.columns, raster_.rows, needed, words_.bytes_left()));
    }
  }

  void read_heights() {
    raster_.heights_m.resize(raster_.columns * raster_.rows);
    for (std::size_t line = 0; line < raster_.rows; ++line) {
      float* row = raster_.heights_m.data() + (raster_.rows - 1 - line) * raster_.columns;
      for (std::size_t column = 0; column < raster_.columns; ++column) {
        row[column] = read_height(line, column);
      }
    }
  }

  float read_height(std::size_t line, std::size_t column) {
    const std::string_view word = words_.next();
    if (word.empty()) {
      throw words_.error(ErrorCode::truncated, fmt::format("the file ends after {} of {} heights",
                                                           line * raster_.columns + column, raster_.heights_m.size()));
    }
    const std::optional<double> value = parse_number(word);
    if (is_nodata(word, value)) {
      return std::numeric_limits<float>::quiet_NaN();
    }
    if (!value || std::abs(*value) > kMaxHeight_m) {
      throw words_.error(
          fmt::format("{} in row {}, column {} is no height in metres", quoted(word), line + 1, column + 1));
    }
    return static_cast<float>(*value);
  }

  [[nodiscard]] bool is_nodata(std::string_view word, const std::optional<double>& value) const {
    if (!header_.nodata) {
      return false;
    }
    if (!value) {
      return std::isnan(*header_.nodata) && lower_case(word) == "nan";
    }
    // -3.4028235e38 is written with more or fewer digits: the same to a part in a million.
    return *value == *header_.nodata || std::abs(*value - *header_.nodata) < 1e-6 * std::abs(*header_.nodata);
  }

  WordReader words_;
  const std::string& name_;
  GridHeader header_;
  HeightRaster raster_;
};

}  // namespace

void check_ascii_grid_header(std::string_view head, const std::string& name) {
  GridParser(head, name).read_header();
}

HeightRaster parse_ascii_grid(std::string_view text, const std::string& name) {
  return GridParser(text, name).parse();
}

}  // namespace berm
