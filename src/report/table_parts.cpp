#include "table_parts.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "log_histogram.hpp"
#include "table_series.hpp"

namespace berm {
namespace {

using Json = nlohmann::ordered_json;

/// Seconds since the first row, from the column `stamp`; rows are counted where there is none.
class TimeOfRow {
 public:
  explicit TimeOfRow(const CsvTable& table) : stamp_(table.column("stamp")) {}

  double operator()(const CsvTable& table) {
    const double stamp_s = stamp_ ? table.number(*stamp_) : static_cast<double>(rows_);
    ++rows_;
    if (!first_s_) {
      first_s_ = stamp_s;
    }
    return std::round((stamp_s - *first_s_) * 1e4) / 1e4;
  }

 private:
  std::optional<std::size_t> stamp_;
  std::optional<double> first_s_;
  std::size_t rows_ = 0;
};

}  // namespace

nlohmann::ordered_json scans_part(const std::filesystem::path& file) {
  static const std::vector<ShownColumn> kShown = {
      {"points", Thinning::total, {}},
      {"drivable", Thinning::total, {}},
      {"terrain", Thinning::total, {}},
      {"obstacle", Thinning::total, {}},
      {"falling_snow", Thinning::total, {}},
      {"no_return", Thinning::total, {}},
      {"invalid", Thinning::total, {}},
      {"slope_deg", Thinning::extremes, {}},
      {"slope_sigma_deg", Thinning::worst, {}},
      {"cross_fall_deg", Thinning::extremes, {}},
      {"cross_fall_sigma_deg", Thinning::worst, {}},
      {"obstacle_ahead_m", Thinning::extremes, {}},
      {"left_edge_m", Thinning::extremes, {}},
      {"right_edge_m", Thinning::extremes, {}},
      {"ground_tilt_deg", Thinning::extremes, {}},
  };
  CsvTable table(file);
  return thin_table(table, kShown, TimeOfRow(table));
}

nlohmann::ordered_json times_part(const std::filesystem::path& file) {
  constexpr std::string_view kUnit = "_ms";
  CsvTable table(file);
  std::vector<ShownColumn> shown;
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    const std::string& name = table.columns()[i];
    if (name.ends_with(kUnit)) {
      shown.push_back({name, Thinning::extremes, {}});
      columns.push_back(i);
    }
  }
  std::vector<LogHistogram> histograms(columns.size());
  Json json = thin_table(table, shown, [&, time = TimeOfRow(table)](const CsvTable& row) mutable {
    for (std::size_t i = 0; i < columns.size(); ++i) {
      histograms[i].add(row.number(columns[i]));
    }
    return time(row);
  });
  json["histogram"] = {{"first_ms", LogHistogram::kFirst}, {"bins_per_decade", LogHistogram::kBinsPerDecade}};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (histograms[i].count() > 0) {
      json["histogram"]["scans"][shown[i].name] = histograms[i].bins();
    }
  }
  return json;
}

nlohmann::ordered_json odometry_part(const std::filesystem::path& file) {
  static const std::vector<ShownColumn> kShown = {
      {"health", Thinning::worst, {"good", "starting", "weak", "lost"}},
      {"weakest", Thinning::extremes, {}},
      {"sigma_m", Thinning::extremes, {}},
      {"session", Thinning::worst, {}},
  };
  CsvTable table(file);
  return thin_table(table, kShown, TimeOfRow(table));
}

nlohmann::ordered_json road_part(const std::filesystem::path& file) {
  static const std::vector<std::string> kVerdicts = {"holds", "uncertain", "broken"};
  std::vector<ShownColumn> shown;
  for (const std::string name :
       {"left", "right", "width", "left_berm_height", "right_berm_height", "left_berm_width", "right_berm_width"}) {
    shown.push_back({name + "_m", Thinning::extremes, {}});
    shown.push_back({name + "_sigma_m", Thinning::worst, {}});
  }
  for (const std::string name : {"grade", "cross_fall"}) {
    shown.push_back({name + "_percent", Thinning::extremes, {}});
    shown.push_back({name + "_sigma_percent", Thinning::worst, {}});
  }
  for (const char* rule : {"width_rule", "grade_rule", "left_berm_rule", "right_berm_rule"}) {
    shown.push_back({rule, Thinning::worst, kVerdicts});
  }
  CsvTable table(file);
  const auto chainage = table.column("chainage_m");
  std::size_t rows = 0;
  return thin_table(table, shown, [&](const CsvTable& row) {
    return chainage ? row.number(*chainage) : static_cast<double>(rows++);
  });
}

}  // namespace berm
