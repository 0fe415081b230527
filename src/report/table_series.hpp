#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "berm/io/csv_table.hpp"
#include "thinned_series.hpp"

namespace berm {

/// A column that the report shows.
struct ShownColumn {
  std::string name;
  Thinning thinning = Thinning::extremes;
  std::vector<std::string> words;  ///< of a column of words, from the best to the worst; empty for numbers
};

/// What is at least known of every row of a table: its place on the common axis.
using RowPlace = std::function<double(const CsvTable&)>;

/// The rows of `table` as `{"rows", "rows_per_value", "x": [...], "columns": {name: [...]}}`.
/// Columns that the table does not have, or that are empty throughout, are left out; a word becomes its place in
/// `words`, null for others.
[[nodiscard]] nlohmann::ordered_json thin_table(CsvTable& table, std::span<const ShownColumn> shown,
                                                const RowPlace& place);

}  // namespace berm
