#include "berm/geometry/height_grid.hpp"

#include <cmath>
#include <utility>

namespace berm {

HeightGrid::HeightGrid(PolarGrid grid) : grid_(std::move(grid)) {
  const std::size_t cells = grid_.size();
  channels_.height_m.resize(cells);
  channels_.radial_slope.resize(cells);
  channels_.variance_m2.resize(cells);
  channels_.measured.resize(cells);
}

HeightGrid::Cell HeightGrid::cell(PolarCell cell) const {
  const std::size_t i = offset(cell);
  return {.height_m = channels_.height_m[i],
          .radial_slope = channels_.radial_slope[i],
          .sigma_m = std::sqrt(channels_.variance_m2[i]),
          .measured = channels_.measured[i] != 0};
}

std::optional<HeightEstimate> HeightGrid::at(double x_m, double y_m) const {
  const std::optional<PolarCell> where = grid_.cell_of(x_m, y_m);
  if (!where) {
    return std::nullopt;
  }
  const Cell ground = cell(*where);
  const double azimuth_rad = grid_.center_azimuth_rad(where->sector);
  const double outward_m = x_m * std::cos(azimuth_rad) + y_m * std::sin(azimuth_rad);
  const double from_middle_m = outward_m - grid_.center_range_m(where->bin);
  return HeightEstimate{static_cast<double>(ground.height_m) + static_cast<double>(ground.radial_slope) * from_middle_m,
                        static_cast<double>(ground.sigma_m)};
}

std::optional<HeightEstimate> HeightGrid::height_above(const Eigen::Vector3d& point_sensor_m) const {
  const Eigen::Vector3d point_m = T_level_sensor_ * point_sensor_m;
  std::optional<HeightEstimate> ground = at(point_m.x(), point_m.y());
  if (ground) {
    ground->height_m = point_m.z() - ground->height_m;
  }
  return ground;
}

}  // namespace berm
