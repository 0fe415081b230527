#include "berm/ground/terrain_ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "berm/core/error.hpp"
#include "count_classes.hpp"
#include "level_plane.hpp"
#include "terrain_cells.hpp"
#include "terrain_follower.hpp"

namespace berm {
namespace {

/// Cells are numbered with 16 bits, and one number stands for none.
constexpr std::size_t kMaxCells = 65535;

/// The tolerance of the point test grows by this per metre of range: footprints widen and grazing returns smear.
constexpr float kToleranceGrowth = 0.003F;

/// The ground of one cell, raised by its tolerance, in the sensor frame: points below it are ground.
struct CellPlane {
  float nx = 0.0F;
  float ny = 0.0F;
  float nz = 0.0F;
  float d = 0.0F;
};

}  // namespace

struct TerrainGround::State {
  explicit State(const TerrainGroundConfig& chosen)
      : config(chosen),
        cells(config.sectors, config.cell_m, config.max_range_m),
        follower(config, cells),
        surface(cells.grid()),
        planes(cells.size() + 1) {
    for (int sector = 0; sector < cells.sectors; ++sector) {
      const double azimuth_rad = surface.grid().center_azimuth_rad(sector);
      directions.push_back({static_cast<float>(std::cos(azimuth_rad)), static_cast<float>(std::sin(azimuth_rad))});
    }
  }

  void bin_points(const PointsView& points);
  void build_planes(const LevelFrame& frame);
  [[nodiscard]] GroundCounts classify_points(const PointsView& points);
  [[nodiscard]] float radial_slope(int bin, std::size_t cell) const;

  struct Direction {
    float x;
    float y;
  };

  TerrainGroundConfig config;
  TerrainCells cells;
  LevelPlaneFinder plane_finder;
  TerrainFollower follower;
  HeightGrid surface;

  std::vector<Direction> directions;  ///< of the middle of each sector
  CellExtremes extremes;
  std::vector<CellPlane> planes;  ///< and behind them one that no point lies below
  std::vector<std::uint16_t> cell_of_point;
  std::vector<float> heights_m;
  std::vector<GroundClass> classes;
};

void TerrainGroundConfig::check() const {
  check_fields(*this, "ground");
  const TerrainCells cells(sectors, cell_m, max_range_m);
  if (cells.size() > kMaxCells) {
    throw ConfigError("ground.cell_m", std::to_string(cells.size()) + " cells are too many, at most " +
                                           std::to_string(kMaxCells) +
                                           " fit: take larger cells, fewer sectors or a shorter max_range_m");
  }
}

/// Lowest and highest point of every cell.
void TerrainGround::State::bin_points(const PointsView& points) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  extremes.lowest_m.assign(cells.size() + 1, kInfinity);
  extremes.highest_m.assign(cells.size() + 1, -kInfinity);
  float* const lowest_m = extremes.lowest_m.data();
  float* const highest_m = extremes.highest_m.data();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t cell = cell_of_point[i];
    lowest_m[cell] = std::min(lowest_m[cell], heights_m[i]);
    highest_m[cell] = std::max(highest_m[cell], heights_m[i]);
  }
}

/// Slope outward, between the middles of the bins before and behind.
float TerrainGround::State::radial_slope(int bin, std::size_t cell) const {
  const auto heights = follower.heights_m();
  const auto sectors = static_cast<std::size_t>(cells.sectors);
  const bool first = bin == 0;
  const bool last = bin + 1 == cells.bins;
  const auto b = static_cast<std::size_t>(bin);
  const std::size_t inner = first ? cell : cell - sectors;
  const std::size_t outer = last ? cell : cell + sectors;
  const float inner_m = cells.edges_m[first ? b : b - 1] + cells.edges_m[first ? b + 1 : b];
  const float outer_m = cells.edges_m[last ? b : b + 1] + cells.edges_m[last ? b + 1 : b + 2];
  return 2.0F * (heights[outer] - heights[inner]) / (outer_m - inner_m);
}

void TerrainGround::State::build_planes(const LevelFrame& frame) {
  const auto heights = follower.heights_m();
  const auto cross_slopes = follower.cross_slopes();
  std::size_t cell = 0;
  for (int bin = 0; bin < cells.bins; ++bin) {
    const float middle_m = 0.5F * (cells.edges_m[static_cast<std::size_t>(bin)] +
                                   cells.edges_m[static_cast<std::size_t>(bin) + 1]);
    const float growth_m = kToleranceGrowth * middle_m;
    const float bare_m = static_cast<float>(config.tolerance_m) + growth_m;
    const float object_m =
        config.strict_at_objects ? std::min(bare_m, static_cast<float>(config.object_tolerance_m)) : bare_m;
    for (int sector = 0; sector < cells.sectors; ++sector, ++cell) {
      const float outward = radial_slope(bin, cell);
      const float leftward = cross_slopes[cell];
      const Direction& d = directions[static_cast<std::size_t>(sector)];
      // Gradient in the levelled frame, and the plane z = gradient . (x, y) + height at its origin.
      const float gx = outward * d.x - leftward * d.y;
      const float gy = outward * d.y + leftward * d.x;
      const float at_origin_m = heights[cell] - outward * middle_m;
      const float tolerance_m = follower.has_object()[cell] != 0 ? object_m : bare_m;
      planes[cell] = {frame.zx - gx * frame.xx - gy * frame.yx, frame.zy - gx * frame.xy - gy * frame.yy,
                      frame.zz - gx * frame.xz - gy * frame.yz, frame.z0 - at_origin_m - tolerance_m};
      HeightGrid::Cell& ground = surface.cell({.sector = sector, .bin = bin});
      ground = {heights[cell], outward, leftward, std::sqrt(follower.variances_m2()[cell]),
                follower.measured()[cell] != 0};
    }
  }
  planes.back() = {0.0F, 0.0F, 0.0F, 1.0F};
}

GroundCounts TerrainGround::State::classify_points(const PointsView& points) {
  classes.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CellPlane& p = planes[cell_of_point[i]];
    const float above_m = p.nx * points.x[i] + p.ny * points.y[i] + p.nz * points.z[i] + p.d;
    classes[i] = above_m < 0.0F ? GroundClass::ground : GroundClass::not_ground;
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (cell_of_point[i] == cells.size()) {
      classes[i] = class_of_stray(points.x[i], points.y[i], points.z[i]);
    }
  }
  return count_classes(classes);
}

TerrainGround::TerrainGround(const TerrainGroundConfig& config) : config_(config) {
  config_.check();
  state_ = std::make_unique<State>(config_);
}

TerrainGround::~TerrainGround() = default;

GroundResult TerrainGround::process(const PointsView& points, const Pose& T_base_sensor) {
  State& s = *state_;
  const LevelPlane plane = s.plane_finder.find(points, T_base_sensor, config_);
  const LevelFrame frame(plane.T_level_sensor);
  s.cell_of_point.resize(points.size());
  s.heights_m.resize(points.size());
  locate_points(points, frame, s.cells, s.cell_of_point, s.heights_m);
  s.bin_points(points);
  s.follower.follow(s.extremes, plane.rms_m, plane.nearest_m);
  s.surface.set_T_level_sensor(plane.T_level_sensor);
  s.build_planes(frame);
  const GroundCounts counts = s.classify_points(points);
  return {.classes = s.classes, .surface = &s.surface, .counts = counts};
}

}  // namespace berm
