#include "berm_height.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace berm::bench {
namespace {

constexpr double kBermReach_m = 4.0;  // across the berms of the scenarios

}  // namespace

double height_at(const HeightRaster& terrain, const Eigen::Vector2d& p) {
  const double column = (p.x() - terrain.origin_x_m) / terrain.cell_m - 0.5;
  const double row = (p.y() - terrain.origin_y_m) / terrain.cell_m - 0.5;
  if (!(column >= 0.0 && row >= 0.0 && column < static_cast<double>(terrain.columns - 1) &&
        row < static_cast<double>(terrain.rows - 1))) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto c = static_cast<std::size_t>(column);
  const auto r = static_cast<std::size_t>(row);
  const double u = column - static_cast<double>(c);
  const double v = row - static_cast<double>(r);
  return (1 - v) * ((1 - u) * double{terrain.at(c, r)} + u * double{terrain.at(c + 1, r)}) +
         v * ((1 - u) * double{terrain.at(c, r + 1)} + u * double{terrain.at(c + 1, r + 1)});
}

std::optional<double> true_berm_height_m(const HeightRaster& terrain, const Eigen::Vector2d& toe_m,
                                         const Eigen::Vector2d& along) {
  const Eigen::Vector2d left(-along.y(), along.x());
  std::optional<double> best;
  for (const double sign : {1.0, -1.0}) {
    const double foot = height_at(terrain, toe_m);
    double top = foot;
    for (double s = 0.25; s <= kBermReach_m; s += 0.25) {
      const double z = height_at(terrain, toe_m + sign * s * left);
      if (!(z > top - 0.1)) {
        if (top - foot > 0.2 && (!best || top - foot > *best)) {
          best = top - foot;
        }
        break;
      }
      top = std::max(top, z);
    }
  }
  return best;
}

}  // namespace berm::bench
