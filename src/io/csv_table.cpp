#include "berm/io/csv_table.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "line_reader.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

/// Takes the field at the begin of `rest` and the comma behind it; none if a quote does not end as it should.
/// `more` becomes whether there was a comma.
std::optional<std::string> take_field(std::string_view& rest, bool& more) {
  std::string field;
  if (rest.empty() || rest.front() != '"') {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    field = rest.substr(0, comma);
    rest.remove_prefix(comma);
  } else {
    std::size_t quote = rest.find('"', 1);
    while (quote != std::string_view::npos && quote + 1 < rest.size() && rest[quote + 1] == '"') {
      field += rest.substr(1, quote);
      rest.remove_prefix(quote + 1);
      quote = rest.find('"', 1);
    }
    if (quote == std::string_view::npos) {
      return std::nullopt;
    }
    field += rest.substr(1, quote - 1);
    rest.remove_prefix(quote + 1);
  }
  more = !rest.empty();
  if (more && rest.front() != ',') {
    return std::nullopt;
  }
  rest.remove_prefix(more ? 1 : 0);
  return field;
}

}  // namespace

CsvTable::CsvTable(const std::filesystem::path& file) : lines_(std::make_unique<LineReader>(file)) {
  read_header();
}

CsvTable::CsvTable(std::istream& input, const std::string& name) : lines_(std::make_unique<LineReader>(input, name)) {
  read_header();
}

CsvTable::~CsvTable() = default;

void CsvTable::read_header() {
  std::string_view line;
  if (!lines_->next(line)) {
    throw lines_->error("the file is empty, expected a line with the names of columns");
  }
  split(line);
  columns_ = fields_;
  for (const std::string& name : columns_) {
    if (name.empty() || std::count(columns_.begin(), columns_.end(), name) > 1) {
      throw lines_->error("expected names of columns, each once, found " + quoted(line));
    }
  }
}

void CsvTable::split(std::string_view line) {
  std::size_t count = 0;
  bool more = true;
  for (std::string_view rest = line; more; ++count) {
    std::optional<std::string> field = take_field(rest, more);
    if (!field) {
      throw lines_->error(fmt::format("a quote that does not end in column {}", count + 1));
    }
    if (count == fields_.size()) {
      fields_.emplace_back();
    }
    fields_[count] = std::move(*field);
  }
  fields_.resize(count);
}

std::optional<std::size_t> CsvTable::column(std::string_view name) const {
  const auto found = std::find(columns_.begin(), columns_.end(), name);
  return found == columns_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - columns_.begin()));
}

bool CsvTable::next() {
  std::string_view line;
  if (!lines_->next(line)) {
    return false;
  }
  split(line);
  if (fields_.size() != columns_.size()) {
    throw lines_->error(fmt::format("{} fields where the header has {}", fields_.size(), columns_.size()));
  }
  return true;
}

double CsvTable::number(std::size_t column) const {
  const std::string& field = fields_[column];
  if (field.empty()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const std::optional<double> value = parse_number(field);
  if (!value) {
    throw lines_->error("expected a number in " + columns_[column] + ", found " + berm::quoted(field));
  }
  return *value;
}

}  // namespace berm
