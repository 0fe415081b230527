#include "surface_elevation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <fmt/format.h>

#include "berm/io/height_raster.hpp"
#include "berm/io/raster_file.hpp"
#include "berm/map/elevation.hpp"

namespace berm {
namespace {

constexpr double kDegreesPerRad = 180.0 / std::numbers::pi;

struct CellBox {
  std::int32_t left = 0;
  std::int32_t right = 0;
  std::int32_t low = 0;
  std::int32_t high = 0;
};

CellBox box_of(const std::vector<ElevationCell>& cells) {
  CellBox box{cells.front().column, cells.front().column, cells.front().row, cells.back().row};
  for (const ElevationCell& cell : cells) {
    box.left = std::min(box.left, cell.column);
    box.right = std::max(box.right, cell.column);
  }
  return box;
}

/// A band that takes `value(cell)`, NaN where it is not known, from the cells of a row.
template <typename Value>
RasterBand band_of(const char* name, const char* unit, int decimals, const std::vector<ElevationCell>& cells,
                   const CellBox& box, Value value) {
  return {name, unit, decimals, [&cells, box, value](std::size_t row, std::span<float> values) {
            const std::int32_t wanted = box.low + static_cast<std::int32_t>(row);
            auto cell = std::lower_bound(cells.begin(), cells.end(), wanted,
                                         [](const ElevationCell& a, std::int32_t b) { return a.row < b; });
            for (; cell != cells.end() && cell->row == wanted; ++cell) {
              values[static_cast<std::size_t>(cell->column - box.left)] =
                  static_cast<float>(value(static_cast<std::size_t>(cell - cells.begin())));
            }
          }};
}

std::vector<double> depths_m(const std::vector<ElevationCell>& cells, double cell_m, const Eigen::Vector3d& origin_m,
                             const TerrainModel& terrain) {
  std::vector<double> depths;
  depths.reserve(cells.size());
  for (const ElevationCell& cell : cells) {
    const Eigen::Vector3d place_m =
        origin_m + Eigen::Vector3d((cell.column + 0.5) * cell_m, (cell.row + 0.5) * cell_m, cell.height_m);
    const auto ground_m = terrain.height_m(place_m);
    depths.push_back(ground_m ? place_m.z() - *ground_m : std::nan(""));
  }
  return depths;
}

void count_depths(std::vector<double> depths, ElevationFigures& figures) {
  depths.erase(std::remove_if(depths.begin(), depths.end(), [](double depth) { return std::isnan(depth); }),
               depths.end());
  figures.depth_cells = depths.size();
  if (!depths.empty()) {
    const auto middle = depths.begin() + static_cast<std::ptrdiff_t>(depths.size() / 2);
    std::nth_element(depths.begin(), middle, depths.end());
    figures.median_depth_m = *middle;
  }
}

}  // namespace

std::optional<ElevationFigures> write_elevation(const std::filesystem::path& folder, const SurfaceFolder& map,
                                                double cell_m, const std::optional<Geodetic>& datum,
                                                const TerrainModel* terrain, std::string& problem) {
  ElevationBuilder builder(map.index().frame.tile_m, cell_m);
  for (const auto& [key, entry] : map.index().tiles) {
    builder.add_tile(map.load(key));
  }
  const std::vector<ElevationCell> cells = builder.finish();
  if (cells.empty()) {
    problem = "no ground was mapped";
    return std::nullopt;
  }
  const CellBox box = box_of(cells);
  const Eigen::Vector3d& origin_m = map.index().frame.origin_m;
  const RasterFrame frame{.origin_x_m = origin_m.x() + box.left * builder.cell_m(),
                          .origin_y_m = origin_m.y() + box.low * builder.cell_m(),
                          .cell_m = builder.cell_m(),
                          .columns = static_cast<std::size_t>(std::int64_t{box.right} - box.left + 1),
                          .rows = static_cast<std::size_t>(std::int64_t{box.high} - box.low + 1),
                          .datum = datum};
  if (frame.columns > kMaxRasterCells / frame.rows) {
    problem = fmt::format("it would have {} x {} cells, {} are the most; set a larger mapping.cell_m", frame.columns,
                          frame.rows, kMaxRasterCells);
    return std::nullopt;
  }
  std::vector<RasterBand> bands = {
      band_of("height", "m", 3, cells, box, [&](std::size_t i) { return origin_m.z() + cells[i].height_m; }),
      band_of("slope", "deg", 2, cells, box,
              [&](std::size_t i) { return cells[i].slope_rad ? *cells[i].slope_rad * kDegreesPerRad : std::nan(""); }),
      band_of("sigma", "m", 3, cells, box, [&](std::size_t i) { return cells[i].sigma_m; }),
      band_of("count", "", 0, cells, box, [&](std::size_t i) { return static_cast<double>(cells[i].points); })};
  ElevationFigures figures{.cells = cells.size()};
  std::vector<double> depths;
  if (terrain != nullptr) {
    depths = depths_m(cells, builder.cell_m(), origin_m, *terrain);
    count_depths(depths, figures);
    bands.push_back(band_of("depth", "m", 3, cells, box, [&](std::size_t i) { return depths[i]; }));
  }
  figures.files = write_raster(folder, "elevation", frame, bands);
  return figures;
}

}  // namespace berm
