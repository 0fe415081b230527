#include "pit_shape.hpp"

#include <algorithm>
#include <cmath>

namespace berm::sim {
namespace {

constexpr int kBenches = 2;
constexpr double kBenchWidth_m = 7.0;
/// How far rock juts out of a wall, standard deviation, and how wide its blocks are.
constexpr double kJut_m = 0.55;
constexpr double kBlock_m = 5.0;
/// The edge of a bench is not straight.
constexpr double kEdgeWander_m = 1.6;
constexpr double kEdgeWave_m = 28.0;

/// Height of steps of `height_m` with flanks of `slope` and benches between them.
double stairs_m(double beyond_m, double height_m, double slope) {
  if (beyond_m <= 0.0) {
    return 0.0;
  }
  const double flank = height_m / slope;
  const double period = flank + kBenchWidth_m;
  const double step = std::min(std::floor(beyond_m / period), static_cast<double>(kBenches - 1));
  return height_m * (step + std::min(1.0, (beyond_m - step * period) / flank));
}

}  // namespace

double PitShape::height_m(double x_m, double y_m, double left_m, const PlaneNoise& noise) const {
  const bool left = left_m > 0.0;
  const double beyond = std::abs(left_m) - (left ? left_width_m : right_width_m).at(x_m, y_m);
  const bool wall = left == (wall_side > 0.0);
  const double from = wall ? wall_from_m : drop_from_m;
  if (beyond < from - 4.0 * (kEdgeWander_m + kJut_m)) {
    return 0.0;
  }
  // Only outwards: the road keeps its berm and its ditch.
  const double wander = kEdgeWander_m * (1.2 + noise.at(x_m + 313.0, y_m, kEdgeWave_m) * 4.0);
  const double jut = kJut_m * noise.fractal(x_m, y_m + 777.0, kBlock_m, 4, 0.55);
  if (wall) {
    return stairs_m(beyond - from - std::max(0.0, wander) + jut, wall_height_m, wall_slope);
  }
  return -stairs_m(beyond - from - std::max(0.0, wander) + 0.6 * jut, drop_height_m, drop_slope);
}

bool PitShape::is_rock(double x_m, double y_m, double left_m) const {
  const bool left = left_m > 0.0;
  const double beyond = std::abs(left_m) - (left ? left_width_m : right_width_m).at(x_m, y_m);
  return left == (wall_side > 0.0) && beyond > wall_from_m;
}

}  // namespace berm::sim
