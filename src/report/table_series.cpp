#include "table_series.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

namespace berm {
namespace {

using Json = nlohmann::ordered_json;

struct Source {
  const ShownColumn* shown;
  std::size_t column;
};

double value_of(const CsvTable& table, const Source& source) {
  const std::vector<std::string>& words = source.shown->words;
  if (words.empty()) {
    return table.number(source.column);
  }
  const auto word = std::find(words.begin(), words.end(), table.text(source.column));
  return word == words.end() ? std::numeric_limits<double>::quiet_NaN() : static_cast<double>(word - words.begin());
}

}  // namespace

nlohmann::ordered_json thin_table(CsvTable& table, std::span<const ShownColumn> shown, const RowPlace& place) {
  std::vector<Source> sources;
  std::vector<Thinning> kinds;
  for (const ShownColumn& column : shown) {
    if (const auto found = table.column(column.name)) {
      sources.push_back({&column, *found});
      kinds.push_back(column.thinning);
    }
  }
  ThinnedSeries thinned(kinds);
  std::vector<double> values(sources.size());
  while (table.next()) {
    std::transform(sources.begin(), sources.end(), values.begin(),
                   [&table](const Source& source) { return value_of(table, source); });
    thinned.add(place(table), values);
  }
  const Series series = thinned.take();
  Json json = {{"rows", series.rows}, {"rows_per_value", series.rows_per_value}, {"x", series.x}};
  json["columns"] = Json::object();
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::vector<double>& column = series.columns[i];
    if (!std::all_of(column.begin(), column.end(), [](double value) { return std::isnan(value); })) {
      json["columns"][sources[i].shown->name] = column;
    }
  }
  return json;
}

}  // namespace berm
