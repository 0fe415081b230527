#include "berm/piste/boundary_piste.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "berm/geometry/bearing_grid.hpp"
#include "berm/geometry/level_points.hpp"
#include "berm/geometry/traces.hpp"
#include "boundary_evidence.hpp"
#include "boundary_seam.hpp"
#include "list_points.hpp"
#include "piste_surface.hpp"
#include "trace_windows.hpp"
#include "way_ahead.hpp"

namespace berm {
namespace {

using bearing_grid::kBins;
using bearing_grid::kSectors;

constexpr float kFirstSurface_m = 14.0F;  // the surface is fitted to this before a boundary is known
constexpr int kEdgeBins = 4;              // the sign of a boundary lies within this many bins beyond it
constexpr float kSure = 12.0F;            // evidence that leaves no doubt

/// The levelled frame as the mount has it: base_link, moved to below the sensor.
Pose below(const Pose& T_base_sensor) {
  return {T_base_sensor.rotation(), {0.0, 0.0, T_base_sensor.translation_m().z()}};
}

std::size_t wrap(int sector) {
  return static_cast<std::size_t>((sector % kSectors + kSectors) % kSectors);
}

}  // namespace

struct BoundaryPiste::State {
  explicit State(const BoundaryPisteConfig& settings)
      : config(settings),
        evidence(settings),
        seam(settings.jump_cost, settings.max_jump_bins),
        obstacle_ahead(settings) {}

  const Traces& find_boundary(const PisteInput& input);
  void relabel(std::span<const Label> input, std::span<const std::uint32_t> ground);
  void trace_boundary(const Pose& T_base_level);
  [[nodiscard]] int find_way(const Pose& T_base_level) const;
  void add_vertex(int sector, const Pose& T_base_level, std::vector<BoundaryPoint>& side) const;
  [[nodiscard]] double piste_ends_ahead_m(const Pose& T_base_level) const;

  BoundaryPisteConfig config;
  bearing_grid::SectorTable sectors;
  LevelPoints level;
  TraceFinder traces;
  TraceWindows windows;
  PisteSurface surface;
  BoundaryEvidence evidence;
  BoundarySeam seam;
  ObstacleAhead obstacle_ahead;
  std::span<const int> bound;
  std::array<float, kSectors> bound_squared_m2{};
  std::vector<std::uint32_t> obstacles;  ///< points
  std::vector<Label> labels;
  std::vector<BoundaryPoint> left;
  std::vector<BoundaryPoint> right;
};

BoundaryPiste::BoundaryPiste(const BoundaryPisteConfig& config) {
  config.check();
  state_ = std::make_unique<State>(config);
}

BoundaryPiste::~BoundaryPiste() = default;

PisteResult BoundaryPiste::process(const PisteInput& input) {
  State& state = *state_;
  const Pose T_level_sensor = input.surface != nullptr ? input.surface->T_level_sensor() : below(input.T_base_sensor);
  const Pose T_base_level = input.T_base_sensor * T_level_sensor.inverse();
  state.level.fill(input.points, T_level_sensor);
  const Traces& traces = state.find_boundary(input);
  state.relabel(input.labels, traces.index);
  state.trace_boundary(T_base_level);
  PisteResult result;
  result.labels = state.labels;
  result.left = state.left;
  result.right = state.right;
  result.slope = find_slope_ahead(state.surface, T_base_level, state.piste_ends_ahead_m(T_base_level));
  result.obstacle_ahead_m = state.obstacle_ahead.find(state.obstacles, state.level, state.surface, T_base_level);
  return result;
}

/// The surface and the boundary need each other: the first surface is that of what lies just ahead.
const Traces& BoundaryPiste::State::find_boundary(const PisteInput& input) {
  const Traces& found = traces.process(input.points, input.labels, level, sectors);
  cut_windows(found, config.window_m, windows);
  evidence.set_windows(windows, level, found.kind == TraceKind::radial, sectors);
  list_points(input.labels, Label::obstacle, obstacles);
  evidence.set_obstacles(obstacles, level, sectors);
  for (int pass = 0; pass < config.passes; ++pass) {
    if (pass == 0) {
      evidence.fit_near(windows, kFirstSurface_m, surface);
    } else {
      evidence.fit_inside(windows, bound, surface);
    }
    evidence.weigh(windows, surface);
    bound = seam.find(evidence.cells(), evidence.arc());
  }
  return found;
}

void BoundaryPiste::State::relabel(std::span<const Label> input, std::span<const std::uint32_t> ground) {
  for (std::size_t sector = 0; sector < kSectors; ++sector) {
    const float range_m = bearing_grid::range_of(bound[sector]);
    const bool is_found = bound[sector] < kBins;
    bound_squared_m2[sector] = is_found ? range_m * range_m : std::numeric_limits<float>::infinity();
  }
  labels.assign(input.begin(), input.end());
  for (const std::uint32_t i : ground) {
    const bool is_beyond = level.range2[i] >= bound_squared_m2[sectors[level.turn[i]]];
    labels[i] = is_beyond ? Label::terrain : Label::drivable;
  }
}

/// What lies within a quarter turn to the left of where the piste leaves the view is the left side.
void BoundaryPiste::State::trace_boundary(const Pose& T_base_level) {
  left.clear();
  right.clear();
  if (evidence.arc().count == 0) {
    return;
  }
  const int way = find_way(T_base_level);
  for (int aside = kSectors / 4; aside > 0; --aside) {
    add_vertex(way - aside, T_base_level, right);
    add_vertex(way + aside, T_base_level, left);
  }
}

/// The sector in which the piste leaves the view: where its boundary is far away, and not far from straight ahead. A
/// side that shows no boundary is open as well, and so is the way back.
int BoundaryPiste::State::find_way(const Pose& T_base_level) const {
  constexpr float kBinsPerSector = 1.0F;  // a straight boundary comes nearer by as much 45 degrees from ahead
  constexpr float kTurn_rad = 2.0F * std::numbers::pi_v<float>;
  const bearing_grid::Arc& arc = evidence.arc();
  const Eigen::Matrix3d R_base_level = T_base_level.rotation().toRotationMatrix();
  auto ahead_rad = static_cast<float>(std::atan2(R_base_level(0, 1), R_base_level(0, 0)));
  if (!arc.holds(sectors.of(std::cos(ahead_rad), std::sin(ahead_rad)))) {  // a sensor that looks elsewhere
    ahead_rad = bearing_grid::bearing_of(static_cast<int>(arc.sector(arc.count / 2)));
  }
  int way = arc.first;
  float best = -std::numeric_limits<float>::infinity();
  for (int i = 0; i < arc.count; ++i) {
    const auto sector = static_cast<int>(arc.sector(i));
    const float aside_rad = std::abs(std::remainder(bearing_grid::bearing_of(sector) - ahead_rad, kTurn_rad));
    const float score = static_cast<float>(bound[wrap(sector)]) - kBinsPerSector * aside_rad * kSectors / kTurn_rad;
    if (score > best) {
      best = score;
      way = sector;
    }
  }
  return way;
}

/// Only where something marks the boundary: elsewhere the seam spans a gap, or the end of what is seen.
void BoundaryPiste::State::add_vertex(int sector, const Pose& T_base_level, std::vector<BoundaryPoint>& side) const {
  const std::size_t place = wrap(sector);
  if (!evidence.arc().holds(static_cast<int>(place))) {
    return;
  }
  const int bin = bound[place];
  float sign = 0.0F;
  for (int i = bin; i < std::min(bin + kEdgeBins, kBins); ++i) {
    sign += std::max(evidence.cells()[place * kBins + static_cast<std::size_t>(i)], 0.0F);
  }
  if (sign <= 0.0F) {
    return;
  }
  const float range_m = bearing_grid::range_of(bin);
  const float bearing_rad = bearing_grid::bearing_of(static_cast<int>(place));
  const float x = range_m * std::cos(bearing_rad);
  const float y = range_m * std::sin(bearing_rad);
  const Eigen::Vector3d vertex = T_base_level * Eigen::Vector3d(double{x}, double{y}, double{surface.height_m(x, y)});
  side.push_back({.x_m = static_cast<float>(vertex.x()),
                  .y_m = static_cast<float>(vertex.y()),
                  .z_m = static_cast<float>(vertex.z()),
                  .confidence = std::min(sign / kSure, 1.0F)});
}

/// Nearest end of the piste within P's 7 degrees of straight ahead.
double BoundaryPiste::State::piste_ends_ahead_m(const Pose& T_base_level) const {
  constexpr int kSectorsAside = 3;
  if (windows.size() == 0) {
    return 0.0;
  }
  const Eigen::Matrix3d R_base_level = T_base_level.rotation().toRotationMatrix();
  const int ahead = sectors.of(static_cast<float>(R_base_level(0, 0)), static_cast<float>(R_base_level(0, 1)));
  int end = kBins;
  for (int sector = ahead - kSectorsAside; sector <= ahead + kSectorsAside; ++sector) {
    end = std::min(end, bound[wrap(sector)]);
  }
  return double{bearing_grid::range_of(end)};
}

}  // namespace berm
