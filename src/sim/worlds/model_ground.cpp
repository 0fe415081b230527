#include "model_ground.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>

#include "berm/core/error.hpp"

namespace berm::sim {
namespace {

/// Of a finer model only every n-th cell is kept, so that no route asks for more than this.
constexpr double kMostCells = 4e6;

/// Gives every unknown cell the height of a known one near to it: breadth first from all known cells.
void fill_unknown(Grid2D<float>& heights) {
  std::deque<GridIndex> front;
  for (int row = 0; row < heights.shape().rows; ++row) {
    for (int column = 0; column < heights.shape().columns; ++column) {
      if (std::isfinite(*heights.find({column, row}))) {
        front.push_back({column, row});
      }
    }
  }
  while (!front.empty()) {
    const GridIndex from = front.front();
    front.pop_front();
    const float height = *heights.find(from);
    for (const GridIndex step : {GridIndex{1, 0}, GridIndex{-1, 0}, GridIndex{0, 1}, GridIndex{0, -1}}) {
      const GridIndex to{from.column + step.column, from.row + step.row};
      float* const cell = heights.find(to);
      if (cell != nullptr && !std::isfinite(*cell)) {
        *cell = height;
        front.push_back(to);
      }
    }
  }
}

/// Cells of the model from `low` to `high`, both within it.
struct Span {
  int low;
  int high;
};

Span span_of(double middle_cells, double reach_cells, std::size_t count) {
  const double last = static_cast<double>(count - 1);
  return {static_cast<int>(std::clamp(std::floor(middle_cells - reach_cells), 0.0, last)),
          static_cast<int>(std::clamp(std::ceil(middle_cells + reach_cells), 0.0, last))};
}

}  // namespace

ModelGround::ModelGround(const HeightRaster& model, double x_m, double y_m, double reach_m) {
  const Span columns = span_of((x_m - model.origin_x_m) / model.cell_m - 0.5, reach_m / model.cell_m, model.columns);
  const Span rows = span_of((y_m - model.origin_y_m) / model.cell_m - 0.5, reach_m / model.cell_m, model.rows);
  const double cells = (columns.high - columns.low + 1.0) * (rows.high - rows.low + 1.0);
  const int every = std::max(1, static_cast<int>(std::ceil(std::sqrt(cells / kMostCells))));
  const GridShape shape{
      .origin_x_m = model.origin_x_m + columns.low * model.cell_m - x_m - 0.5 * (every - 1) * model.cell_m,
      .origin_y_m = model.origin_y_m + rows.low * model.cell_m - y_m - 0.5 * (every - 1) * model.cell_m,
      .cell_m = every * model.cell_m,
      .columns = (columns.high - columns.low) / every + 1,
      .rows = (rows.high - rows.low) / every + 1};
  Grid2D<float> heights(shape);
  known_ = Grid2D<std::uint8_t>(shape);
  bool any = false;
  for (int row = 0; row < shape.rows; ++row) {
    for (int column = 0; column < shape.columns; ++column) {
      const float height = model.at(static_cast<std::size_t>(columns.low + column * every),
                                    static_cast<std::size_t>(rows.low + row * every));
      *heights.find({column, row}) = height;
      *known_.find({column, row}) = std::isfinite(height) ? 1 : 0;
      any = any || std::isfinite(height);
    }
  }
  if (!any) {
    throw Error(ErrorCode::invalid_argument, "elevation model: no height is known around the start of the route");
  }
  fill_unknown(heights);
  const double half = 0.5 * shape.cell_m;
  const Area area{shape.origin_x_m + half, shape.origin_y_m + half,
                  shape.origin_x_m + half + (shape.columns - 1) * shape.cell_m,
                  shape.origin_y_m + half + (shape.rows - 1) * shape.cell_m};
  heights_ = SmoothRaster(area, shape.cell_m, [&](double x, double y) {
    const int column = static_cast<int>(std::lround((x - area.min_x_m) / shape.cell_m));
    const int row = static_cast<int>(std::lround((y - area.min_y_m) / shape.cell_m));
    return static_cast<double>(*heights.find({std::min(column, shape.columns - 1), std::min(row, shape.rows - 1)}));
  });
}

bool ModelGround::is_known(double x_m, double y_m) const {
  const std::uint8_t* const cell = known_.find_at(x_m, y_m);
  return cell != nullptr && *cell != 0;
}

Eigen::Vector2d ModelGround::slope(double x_m, double y_m, double base_m) const {
  const double half = 0.5 * base_m;
  return {(heights_.at(x_m + half, y_m) - heights_.at(x_m - half, y_m)) / base_m,
          (heights_.at(x_m, y_m + half) - heights_.at(x_m, y_m - half)) / base_m};
}

}  // namespace berm::sim
