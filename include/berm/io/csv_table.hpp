#pragma once

#include <cstddef>
#include <filesystem>
#include <istream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "berm/core/error.hpp"

namespace berm {

class LineReader;

/// A table of a run (scans.csv, times.csv, ...) row by row, in bounded memory: names of columns first, then a row a
/// line, fields in quotes where they have to be (RFC 4180, but no line ends within). Every problem is a FileError with
/// the number of the line.
class CsvTable {
 public:
  /// Throws FileError if `file` is not there or unreadable, or begins with no header: no column, one without a name,
  /// two of the same.
  explicit CsvTable(const std::filesystem::path& file);
  /// The same from a stream, which must outlive the table; `name` stands for the file in errors.
  CsvTable(std::istream& input, const std::string& name);
  ~CsvTable();
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  /// Place of the column called `name`; none if there is none.
  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;
  [[nodiscard]] const std::vector<std::string>& columns() const { return columns_; }

  /// Goes to the next row; false at the end. Throws if it has not as many fields as the header, or a quote that does
  /// not end.
  [[nodiscard]] bool next();

  /// A field of the current row, valid until `next`.
  [[nodiscard]] std::string_view text(std::size_t column) const { return fields_[column]; }
  /// The same as a number, NaN where it is empty; throws if it is no finite number.
  [[nodiscard]] double number(std::size_t column) const;

 private:
  void read_header();
  void split(std::string_view line);

  std::unique_ptr<LineReader> lines_;
  std::vector<std::string> columns_;
  std::vector<std::string> fields_;  ///< kept from row to row for their memory
};

}  // namespace berm
