#include "terrain_part.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace berm {
namespace {

constexpr std::size_t kMostCells = 100'000;
/// Brightness from which to which the picture goes: all but the darkest and the brightest 2 %, so that a slope that
/// looks away from the lamp still shows what is on it; this much at least, so that level ground is not made of noise.
constexpr double kCut = 0.02;
constexpr double kLeastRange = 0.3;
/// Towards the lamp: from the north-west, 45 degrees up, as maps have it. East, north, up.
const Eigen::Vector3d kLamp(-0.5, 0.5, std::sqrt(0.5));

std::size_t divide_up(std::size_t value, std::size_t by) {
  return (value + by - 1) / by;
}

/// Means of squares of `factor` x `factor` cells, NaN where nothing is known.
HeightRaster join_cells(const HeightRaster& raster, std::size_t factor) {
  HeightRaster joined{.origin_x_m = raster.origin_x_m,
                      .origin_y_m = raster.origin_y_m,
                      .cell_m = raster.cell_m * static_cast<double>(factor),
                      .columns = divide_up(raster.columns, factor),
                      .rows = divide_up(raster.rows, factor)};
  std::vector<double> sums(joined.columns * joined.rows);
  std::vector<std::uint32_t> counts(sums.size());
  for (std::size_t row = 0; row < raster.rows; ++row) {
    for (std::size_t column = 0; column < raster.columns; ++column) {
      const float height_m = raster.at(column, row);
      if (!std::isnan(height_m)) {
        const std::size_t place = row / factor * joined.columns + column / factor;
        sums[place] += double{height_m};
        ++counts[place];
      }
    }
  }
  for (std::size_t i = 0; i < sums.size(); ++i) {
    joined.heights_m.push_back(counts[i] > 0 ? static_cast<float>(sums[i] / counts[i]) : std::nanf(""));
  }
  return joined;
}

/// Rise from the cell before to the one behind, or from or to the middle where one of them is not known; level where
/// both are not.
double rise_m(float before_m, float middle_m, float behind_m, double cell_m) {
  const bool has_before = !std::isnan(before_m);
  const bool has_behind = !std::isnan(behind_m);
  const double from_m = double{has_before ? before_m : middle_m};
  const double to_m = double{has_behind ? behind_m : middle_m};
  return (to_m - from_m) / (cell_m * (has_before && has_behind ? 2.0 : 1.0));
}

/// Lambert's law over the gradient: 0 to 1, NaN where the height is not known.
double brightness_of(const HeightRaster& raster, std::size_t column, std::size_t row) {
  const float middle_m = raster.at(column, row);
  if (std::isnan(middle_m)) {
    return std::nan("");
  }
  const auto beside = [&](bool inside, std::size_t c, std::size_t r) {
    return inside ? raster.at(c, r) : std::nanf("");
  };
  const double east = rise_m(beside(column > 0, column - 1, row), middle_m,
                             beside(column + 1 < raster.columns, column + 1, row), raster.cell_m);
  const double north =
      rise_m(beside(row > 0, column, row - 1), middle_m, beside(row + 1 < raster.rows, column, row + 1), raster.cell_m);
  return std::max(0.0, Eigen::Vector3d(-east, -north, 1.0).normalized().dot(kLamp));
}

/// The brightness that is drawn black and the one that is drawn white.
std::pair<double, double> find_range(std::vector<double> known) {
  const auto at = [&known](double share) {
    const auto place = known.begin() + std::lround(share * static_cast<double>(known.size() - 1));
    std::nth_element(known.begin(), place, known.end());
    return *place;
  };
  const double dark = at(kCut);
  const double bright = at(1.0 - kCut);
  const double lacking = std::max(0.0, kLeastRange - (bright - dark));
  return {dark - 0.5 * lacking, bright + 0.5 * lacking};
}

/// A byte for each brightness, 0 where it is not known.
std::string to_bytes(const std::vector<double>& brightness) {
  std::vector<double> known;
  std::copy_if(brightness.begin(), brightness.end(), std::back_inserter(known),
               [](double value) { return !std::isnan(value); });
  const auto [dark, bright] = find_range(std::move(known));
  std::string bytes;
  for (const double value : brightness) {
    const double share = std::clamp((value - dark) / (bright - dark), 0.0, 1.0);
    bytes += std::isnan(value) ? '\0' : static_cast<char>(static_cast<std::uint8_t>(std::lround(1.0 + 254.0 * share)));
  }
  return bytes;
}

/// RFC 4648, section 4.
std::string to_base64(const std::string& bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t there = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      three = three << 8U | (k < there ? static_cast<std::uint8_t>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= there ? kDigits[three >> (18U - 6U * k) & 63U] : '=';
    }
  }
  return text;
}

double terrain_cm(double value_m) {
  return std::round(value_m * 100.0) / 100.0;
}

}  // namespace

nlohmann::ordered_json terrain_part(const HeightRaster& raster, const Eigen::Vector3d& origin_m) {
  std::size_t factor = 1;
  while (divide_up(raster.columns, factor) * divide_up(raster.rows, factor) > kMostCells) {
    ++factor;
  }
  const HeightRaster joined = join_cells(raster, factor);
  std::optional<std::pair<float, float>> range_m;
  std::vector<double> brightness;
  brightness.reserve(joined.heights_m.size());
  for (std::size_t row = joined.rows; row-- > 0;) {
    for (std::size_t column = 0; column < joined.columns; ++column) {
      const float height_m = joined.at(column, row);
      brightness.push_back(brightness_of(joined, column, row));
      if (!std::isnan(height_m)) {
        const auto [low_m, high_m] = range_m.value_or(std::pair(height_m, height_m));
        range_m = std::pair(std::min(low_m, height_m), std::max(high_m, height_m));
      }
    }
  }
  if (!range_m) {
    return {};
  }
  return {{"x_m", terrain_cm(joined.origin_x_m - origin_m.x())},
          {"y_m", terrain_cm(joined.origin_y_m - origin_m.y())},
          {"cell_m", joined.cell_m},
          {"columns", joined.columns},
          {"rows", joined.rows},
          {"low_m", terrain_cm(double{range_m->first} - origin_m.z())},
          {"high_m", terrain_cm(double{range_m->second} - origin_m.z())},
          {"shade", to_base64(to_bytes(brightness))}};
}

}  // namespace berm
