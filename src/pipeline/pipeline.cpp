#include "berm/pipeline/pipeline.hpp"

#include <algorithm>
#include <cmath>

#include "berm/edge/ring_edges.hpp"
#include "berm/edge/trace_edges.hpp"
#include "berm/ground/polar_ground.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "berm/piste/boundary_piste.hpp"
#include "berm/piste/envelope_piste.hpp"
#include "berm/snow/box_snow.hpp"
#include "berm/snow/sparse_snow.hpp"
#include "scan_quality.hpp"

namespace berm {
namespace {

/// A copy in `memory` with 0 for every flake.
std::span<const float> blank_flakes(std::span<const float> values, std::span<const std::uint8_t> falling,
                                    std::vector<float>& memory) {
  memory.resize(values.size());
  std::transform(values.begin(), values.end(), falling.begin(), memory.begin(),
                 [](float value, std::uint8_t flake) { return flake != 0 ? 0.0F : value; });
  return memory;
}

double tilt_against_mount(const HeightGrid& surface, const Pose& T_base_sensor) {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d normal_sensor = surface.T_level_sensor().rotation().conjugate() * up;
  return std::acos(std::clamp((T_base_sensor.rotation() * normal_sensor).z(), -1.0, 1.0));
}

}  // namespace

std::string_view to_string(Stage stage) {
  switch (stage) {
    case Stage::snow:
      return "snow";
    case Stage::ground:
      return "ground";
    case Stage::repair:
      return "repair";
    case Stage::piste:
      return "piste";
    case Stage::edge:
      return "edge";
    case Stage::check:
      break;
  }
  return "check";
}

std::unique_ptr<SnowFilter> make_snow(const Machine& machine) {
  machine.methods.check();
  if (machine.methods.snow == "none") {
    return nullptr;
  }
  if (machine.methods.snow == "reference") {
    return std::make_unique<BoxSnow>(machine.snow_reference);
  }
  return std::make_unique<SparseSnow>(machine.snow);
}

std::unique_ptr<GroundSegmenter> make_ground(const Machine& machine) {
  machine.methods.check();
  if (machine.methods.ground == "reference") {
    return std::make_unique<PolarGround>(machine.ground_reference);
  }
  return std::make_unique<TerrainGround>(machine.ground);
}

std::unique_ptr<PisteSegmenter> make_piste(const Machine& machine) {
  machine.methods.check();
  if (machine.methods.piste == "none") {
    return nullptr;
  }
  if (machine.methods.piste == "reference") {
    return std::make_unique<EnvelopePiste>(machine.piste_reference);
  }
  return std::make_unique<BoundaryPiste>(machine.piste);
}

std::unique_ptr<EdgeDetector> make_edge(const Machine& machine) {
  machine.methods.check();
  if (machine.methods.edge == "none") {
    return nullptr;
  }
  if (machine.methods.edge == "reference") {
    return std::make_unique<RingEdges>(machine.edge_reference);
  }
  return std::make_unique<TraceEdges>(machine.edge);
}

Pipeline::Pipeline(const Machine& machine)
    : snow_(make_snow(machine)),
      ground_(make_ground(machine)),
      piste_(make_piste(machine)),
      edge_(make_edge(machine)) {}

PointsView Pipeline::without_flakes(const PointsView& points, const SnowResult& snow) {
  if (snow.count == 0) {
    return points;
  }
  PointsView view = points;
  view.x = blank_flakes(points.x, snow.falling, x_);
  view.y = blank_flakes(points.y, snow.falling, y_);
  view.z = blank_flakes(points.z, snow.falling, z_);
  return view;
}

void Pipeline::label(const GroundResult& ground, const SnowResult& snow) {
  labels_.resize(ground.classes.size());
  std::transform(ground.classes.begin(), ground.classes.end(), labels_.begin(), label_of);
  if (snow.count > 0) {
    std::transform(labels_.begin(), labels_.end(), snow.falling.begin(), labels_.begin(),
                   [](Label label, std::uint8_t flake) { return flake != 0 ? Label::falling_snow : label; });
  }
}

ScanResult Pipeline::process(const Scan& scan, const StageListener& on_done) {
  const auto done = [&on_done](Stage stage) {
    if (on_done) {
      on_done(stage);
    }
  };
  const PointsView points = scan.cloud.view();
  ScanResult result;

  SnowResult snow;
  if (snow_) {
    snow = snow_->process(points, scan.T_base_sensor);
    done(Stage::snow);
  } else {
    no_flakes_.assign(points.size(), 0);
    snow.falling = no_flakes_;
  }

  const GroundResult ground = ground_->process(without_flakes(points, snow), scan.T_base_sensor);
  label(ground, snow);
  result.labels = labels_;
  result.surface = ground.surface;
  done(Stage::ground);

  if (piste_) {
    result.series = repair_.process(points, snow.falling);
    done(Stage::repair);
    result.piste = piste_->process({.points = points,
                                    .labels = labels_,
                                    .series = result.series,
                                    .surface = ground.surface,
                                    .T_base_sensor = scan.T_base_sensor});
    result.labels = result.piste.labels;
    done(Stage::piste);
  }

  if (edge_) {
    result.edge = edge_->process(
        {.points = points, .labels = labels_, .surface = ground.surface, .T_base_sensor = scan.T_base_sensor});
    done(Stage::edge);
  }

  result.counts = count_labels(result.labels);
  if (ground.surface != nullptr) {
    result.ground_tilt_rad = tilt_against_mount(*ground.surface, scan.T_base_sensor);
  }
  result.mount = mount_check_.process(points, snow.falling, scan.T_base_sensor);
  result.degraded = find_degradations(points, snow.limits, result);
  done(Stage::check);
  return result;
}

}  // namespace berm
