#include "berm/map/elevation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>

namespace berm {
namespace {

/// A normal distribution's standard deviation from its median absolute deviation.
constexpr double kSigmaPerMad = 1.4826;
/// Points farther from the plane of their cell than so many sigmas do not shape it.
constexpr double kOutlierSigmas = 3.0;
/// What the sensor cannot tell from level ground.
constexpr double kLeastSigma_m = 0.01;
constexpr int kPlaneRounds = 3;
constexpr std::size_t kLeastPlanePoints = 6;
/// Spread of the points of a cell, as a share of its side, that makes a plane.
constexpr double kLeastSpread = 0.12;
/// Ground is no steeper.
constexpr double kSteepest = 2.0;
/// One point on a cell of a raster weighs at most as much as so many: near the machine they come by the hundred.
constexpr double kMostWeight = 50.0;

bool is_ground(const SurfacePoint& point) {
  return point.label == Label::drivable || point.label == Label::terrain;
}

/// z = height + slope * (xy - middle), by least squares with weights.
struct Plane {
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  double height_m = 0.0;
  bool is_sloped = false;  ///< else `slope` is unknown
};

template <typename Samples>
Plane fit_plane(const Samples& samples, double least_spread_m) {
  double weight = 0.0;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& s : samples) {
    weight += s.weight;
    sum += s.weight * Eigen::Vector3d(s.x_m, s.y_m, s.z_m);
  }
  const Eigen::Vector3d mean = sum / weight;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  Eigen::Vector2d rise = Eigen::Vector2d::Zero();
  for (const auto& s : samples) {
    const Eigen::Vector2d d(s.x_m - mean.x(), s.y_m - mean.y());
    spread += s.weight / weight * d * d.transpose();
    rise += s.weight / weight * (s.z_m - mean.z()) * d;
  }
  Plane plane{.middle_m = mean.head<2>(), .height_m = mean.z()};
  const double half = 0.5 * spread.trace();
  const double least = half - std::sqrt(std::max(half * half - spread.determinant(), 0.0));
  if (least < least_spread_m * least_spread_m) {
    return plane;
  }
  const Eigen::Vector2d slope = spread.ldlt().solve(rise);
  if (slope.norm() <= kSteepest) {
    plane.slope = slope;
    plane.is_sloped = true;
  }
  return plane;
}

/// Of the residuals; sorts the samples by them.
template <typename Samples>
double weighted_median(Samples& samples) {
  std::sort(samples.begin(), samples.end(), [](const auto& a, const auto& b) {
    return std::tie(a.residual_m, a.x_m, a.y_m) < std::tie(b.residual_m, b.x_m, b.y_m);
  });
  double weight = 0.0;
  for (const auto& s : samples) {
    weight += s.weight;
  }
  double below = 0.0;
  for (const auto& s : samples) {
    below += s.weight;
    if (below >= 0.5 * weight) {
      return s.residual_m;
    }
  }
  return 0.0;
}

}  // namespace

ElevationBuilder::ElevationBuilder(double tile_m, double cell_m)
    : cell_m_(tile_m / std::max(1.0, std::ceil(tile_m / cell_m - 1e-9))) {}

void ElevationBuilder::add_tile(std::span<const SurfacePoint> points) {
  struct Place {
    std::int32_t row;
    std::int32_t column;
    std::uint32_t point;
  };
  std::vector<Place> places;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_ground(points[i])) {
      places.push_back({static_cast<std::int32_t>(std::floor(double{points[i].y_m} / cell_m_)),
                        static_cast<std::int32_t>(std::floor(double{points[i].x_m} / cell_m_)),
                        static_cast<std::uint32_t>(i)});
    }
  }
  std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
    return std::tie(a.row, a.column, a.point) < std::tie(b.row, b.column, b.point);
  });
  for (std::size_t begin = 0; begin < places.size();) {
    samples_.clear();
    std::size_t end = begin;
    std::uint64_t count = 0;
    for (; end < places.size() && places[end].row == places[begin].row && places[end].column == places[begin].column;
         ++end) {
      const SurfacePoint& point = points[places[end].point];
      count += point.count;
      samples_.push_back({point.x_m, point.y_m, point.z_m, std::min(double(point.count), kMostWeight), 0.0});
    }
    add_cell(places[begin].column, places[begin].row);
    ground_.back().cell.points = count;
    begin = end;
  }
}

void ElevationBuilder::add_cell(std::int32_t column, std::int32_t row) {
  Plane plane;
  for (Sample& s : samples_) {
    s.residual_m = s.z_m;
  }
  double height_m = weighted_median(samples_);
  // The first window takes any ground in, the later ones what lies on the plane.
  double window_m = std::max(kSteepest * cell_m_, kLeastSigma_m);
  double sigma_m = 0.0;
  for (int round = 0; round < kPlaneRounds; ++round) {
    std::vector<Sample> on_plane;
    for (const Sample& s : samples_) {
      if (std::abs(s.residual_m - height_m) <= window_m) {
        on_plane.push_back(s);
      }
    }
    plane = fit_plane(on_plane, on_plane.size() < kLeastPlanePoints ? cell_m_ : kLeastSpread * cell_m_);
    for (Sample& s : samples_) {
      s.residual_m = s.z_m - plane.slope.dot(Eigen::Vector2d(s.x_m, s.y_m) - plane.middle_m);
    }
    height_m = weighted_median(samples_);
    std::vector<Sample> deviations = samples_;
    for (Sample& s : deviations) {
      s.residual_m = std::abs(s.residual_m - height_m);
    }
    sigma_m = kSigmaPerMad * weighted_median(deviations);
    window_m = std::max(kOutlierSigmas * sigma_m, kOutlierSigmas * kLeastSigma_m);
  }
  Ground ground{.centroid_x_m = plane.middle_m.x(), .centroid_y_m = plane.middle_m.y(), .is_level = !plane.is_sloped};
  ground.cell.column = column;
  ground.cell.row = row;
  ground.cell.sigma_m = sigma_m;
  const Eigen::Vector2d center_m = cell_m_ * Eigen::Vector2d(column + 0.5, row + 0.5);
  ground.cell.height_m = height_m + (plane.is_sloped ? plane.slope.dot(center_m - plane.middle_m) : 0.0);
  ground_.push_back(ground);
}

std::vector<ElevationCell> ElevationBuilder::finish() {
  const auto by_place = [](const Ground& a, const Ground& b) {
    return std::tie(a.cell.row, a.cell.column) < std::tie(b.cell.row, b.cell.column);
  };
  std::sort(ground_.begin(), ground_.end(), by_place);
  const auto find = [&](std::int32_t column, std::int32_t row) -> const Ground* {
    Ground wanted;
    wanted.cell.column = column;
    wanted.cell.row = row;
    const auto place = std::lower_bound(ground_.begin(), ground_.end(), wanted, by_place);
    return place != ground_.end() && place->cell.row == row && place->cell.column == column ? &*place : nullptr;
  };
  std::vector<ElevationCell> cells;
  cells.reserve(ground_.size());
  std::vector<Sample> around;
  for (const Ground& ground : ground_) {
    around.clear();
    for (std::int32_t row = -1; row <= 1; ++row) {
      for (std::int32_t column = -1; column <= 1; ++column) {
        if (const Ground* near = find(ground.cell.column + column, ground.cell.row + row)) {
          const bool at_centroid = near->is_level;
          around.push_back({at_centroid ? near->centroid_x_m : (near->cell.column + 0.5) * cell_m_,
                            at_centroid ? near->centroid_y_m : (near->cell.row + 0.5) * cell_m_, near->cell.height_m,
                            1.0, 0.0});
        }
      }
    }
    const Plane plane = fit_plane(around, around.size() < 3 ? 4.0 * cell_m_ : 0.4 * cell_m_);
    ElevationCell cell = ground.cell;
    if (plane.is_sloped) {
      cell.slope_rad = std::atan(plane.slope.norm());
      if (ground.is_level) {
        const Eigen::Vector2d center_m = cell_m_ * Eigen::Vector2d(cell.column + 0.5, cell.row + 0.5);
        cell.height_m += plane.slope.dot(center_m - Eigen::Vector2d(ground.centroid_x_m, ground.centroid_y_m));
      }
    }
    cells.push_back(cell);
  }
  return cells;
}

}  // namespace berm
