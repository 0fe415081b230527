#include "berm/edge/ring_edges.hpp"

#include <cmath>
#include <vector>

#include <Eigen/Geometry>

#include "berm/core/error.hpp"
#include "ring_cues.hpp"
#include "ring_grid.hpp"
#include "ring_ground.hpp"
#include "road_divide.hpp"

namespace berm {
namespace {

constexpr float kReach_m = 1000.0F;  // no sensor of a machine sees farther

}  // namespace

void RingEdgesConfig::check() const {
  check_fields(*this, "edge_reference");
  if (!(alpha < beta)) {
    throw ConfigError("edge_reference.alpha", "must lie below edge_reference.beta");
  }
}

struct RingEdges::State {
  explicit State(const RingEdgesConfig& settings) : config(settings), grid(settings.sectors, settings.guessed_rings) {}

  void find_solid(const EdgeInput& input);
  void collect_edges(const Pose& T_base_sensor);
  void collect_plain();

  RingEdgesConfig config;
  std::vector<Label> solid;
  RingGrid grid;
  std::vector<std::uint8_t> is_ground;
  std::vector<std::uint8_t> is_edge;
  std::vector<std::uint8_t> sector_has_edge;
  std::vector<EdgePoint> edges;
  std::vector<std::uint32_t> plain;
};

RingEdges::RingEdges(const RingEdgesConfig& config) {
  config.check();
  state_ = std::make_unique<State>(config);
}

RingEdges::~RingEdges() = default;

EdgeResult RingEdges::process(const EdgeInput& input) {
  if (input.labels.size() != input.points.size()) {
    throw Error(ErrorCode::invalid_argument, "edge: points and labels must have one length");
  }
  State& s = *state_;
  s.find_solid(input);
  s.grid.fill(input.points, s.solid, input.T_base_sensor);
  find_ring_ground(s.grid, s.config.t1_m, s.config.t2_m, s.is_ground);
  mark_ring_edges(s.grid, s.is_ground, s.config, s.is_edge);
  s.collect_edges(input.T_base_sensor);
  s.collect_plain();
  return {.edges = s.edges, .plain = s.plain};
}

void RingEdges::State::find_solid(const EdgeInput& input) {
  const PointsView& points = input.points;
  solid.resize(input.labels.size());
  for (std::size_t i = 0; i < solid.size(); ++i) {
    // False for NaN too, whatever its label says.
    const bool in_reach = std::abs(points.x[i]) + std::abs(points.y[i]) + std::abs(points.z[i]) < kReach_m;
    solid[i] = in_reach ? input.labels[i] : Label::unlabeled;
  }
}

void RingEdges::State::collect_edges(const Pose& T_base_sensor) {
  const auto sectors = static_cast<std::size_t>(grid.sectors());
  sector_has_edge.assign(sectors, 0);
  for (std::size_t i = 0; i < is_edge.size(); ++i) {
    sector_has_edge[i % sectors] |= is_edge[i];
  }
  const RoadDivide divide = divide_road(sector_has_edge);
  const Eigen::Matrix3f R_sensor_base = T_base_sensor.rotation().toRotationMatrix().transpose().cast<float>();
  edges.clear();
  for (std::size_t i = 0; i < is_edge.size(); ++i) {
    if (is_edge[i] != 0) {
      const RingGrid::Cell& cell = grid.cells()[i];
      const Eigen::Vector3f place =
          R_sensor_base * Eigen::Vector3f(cell.x_m, cell.y_m, cell.z_m - grid.sensor_height_m());
      edges.push_back({.x_m = place.x(),
                       .y_m = place.y(),
                       .z_m = place.z(),
                       .time_s = cell.time_s,
                       .side = divide.is_left(cell.x_m, cell.y_m) ? EdgeSide::left : EdgeSide::right,
                       .kind = EdgeKind::rise,
                       .confidence = 1.0F});
    }
  }
}

void RingEdges::State::collect_plain() {
  plain.clear();
  const auto cell_of_points = grid.cell_of_points();
  for (std::uint32_t i = 0; i < cell_of_points.size(); ++i) {
    const std::uint32_t at = cell_of_points[i];
    if (at != RingGrid::kNoCell && is_ground[at] != 0 && is_edge[at] == 0) {
      plain.push_back(i);
    }
  }
}

}  // namespace berm
