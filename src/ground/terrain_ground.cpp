#include "berm/ground/terrain_ground.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "berm/core/error.hpp"
#include "cell_planes.hpp"
#include "count_classes.hpp"
#include "level_plane.hpp"
#include "terrain_cells.hpp"
#include "terrain_follower.hpp"

namespace berm {
namespace {

/// Cells are numbered with 16 bits, and one number stands for none.
constexpr std::size_t kMaxCells = 65535;

/// Lowest and highest point of every cell. Neighbours in firing order often share a cell: what they say is gathered
/// first and written once, so that points need not wait for each other's memory.
void find_extremes(const std::vector<std::uint16_t>& cell_of_point, const std::vector<float>& heights_m,
                   std::size_t cells, CellExtremes& extremes) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  extremes.lowest_m.assign(cells + 1, kInfinity);
  extremes.highest_m.assign(cells + 1, -kInfinity);
  std::size_t current = cells;
  float lowest_m = kInfinity;
  float highest_m = -kInfinity;
  const auto write = [&extremes, &current, &lowest_m, &highest_m] {
    extremes.lowest_m[current] = std::min(extremes.lowest_m[current], lowest_m);
    extremes.highest_m[current] = std::max(extremes.highest_m[current], highest_m);
  };
  for (std::size_t i = 0; i < cell_of_point.size(); ++i) {
    const float height_m = heights_m[i];
    if (cell_of_point[i] != current) {
      write();
      current = cell_of_point[i];
      lowest_m = height_m;
      highest_m = height_m;
    } else {
      lowest_m = std::min(lowest_m, height_m);
      highest_m = std::max(highest_m, height_m);
    }
  }
  write();
}

/// Points of no cell are not ground; some of them are no points at all. Counts all points.
GroundCounts mark_strays(const PointsView& points, const std::vector<std::uint16_t>& cell_of_point, std::size_t ground,
                         std::uint16_t no_cell, std::vector<GroundClass>& classes) {
  GroundCounts counts{.ground = ground, .not_ground = points.size() - ground};
  auto strays = std::count(cell_of_point.begin(), cell_of_point.end(), no_cell);
  for (std::size_t i = 0; strays > 0; ++i) {
    if (cell_of_point[i] == no_cell) {
      --strays;
      classes[i] = class_of_stray(points.x[i], points.y[i], points.z[i]);
      counts.no_return += classes[i] == GroundClass::no_return ? 1U : 0U;
      counts.invalid += classes[i] == GroundClass::invalid ? 1U : 0U;
    }
  }
  counts.not_ground -= counts.no_return + counts.invalid;
  return counts;
}

}  // namespace

void TerrainGroundConfig::check() const {
  check_fields(*this, "ground");
  const TerrainCells cells(sectors, cell_m, max_range_m);
  if (cells.size() > kMaxCells) {
    throw ConfigError("ground.cell_m", std::to_string(cells.size()) + " cells are too many, at most " +
                                           std::to_string(kMaxCells) +
                                           " fit: take larger cells, fewer sectors or a shorter max_range_m");
  }
}

/// What is kept between scans: memory, and what follows from the configuration.
struct TerrainGround::State {
  explicit State(const TerrainGroundConfig& config)
      : cells(config.sectors, config.cell_m, config.max_range_m),
        follower(config, cells),
        planes(cells),
        surface(cells.grid()),
        has_object(cells.size()) {}

  TerrainCells cells;
  LevelPlaneFinder plane_finder;
  TerrainFollower follower;
  CellPlanes planes;
  HeightGrid surface;

  std::vector<std::uint16_t> cell_of_point;
  std::vector<float> heights_m;
  CellExtremes extremes;
  std::vector<std::uint8_t> has_object;
  std::vector<GroundClass> classes;
};

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
  find_extremes(s.cell_of_point, s.heights_m, s.cells.size(), s.extremes);

  s.surface.set_T_level_sensor(plane.T_level_sensor);
  s.follower.follow(s.extremes, plane.rms_m, plane.nearest_m, s.surface.channels(), s.has_object);

  const auto bare_m = static_cast<float>(config_.tolerance_m);
  const auto object_m = static_cast<float>(config_.object_tolerance_m);
  s.planes.build(s.surface.channels(), s.has_object, frame, bare_m, config_.strict_at_objects ? object_m : bare_m);
  s.classes.resize(points.size());
  const std::size_t ground = s.planes.classify(points, s.cell_of_point, s.classes);
  const GroundCounts counts =
      mark_strays(points, s.cell_of_point, ground, static_cast<std::uint16_t>(s.cells.size()), s.classes);
  return {.classes = s.classes, .surface = &s.surface, .counts = counts};
}

}  // namespace berm
