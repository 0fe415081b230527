#pragma once

#include <memory>

#include "berm/core/config.hpp"
#include "berm/ground/ground.hpp"

namespace berm {

/// Settings of the default ground method. The numbers were chosen on real street scans and on made hills, bowls and
/// crests together; docs/ground.md shows how little the result moves with each of them.
struct TerrainGroundConfig {
  // The grid.
  int sectors = 180;
  double cell_m = 0.25;
  double min_range_m = 2.0;
  double max_range_m = 120.0;
  // The plane that the scan is levelled by.
  bool level = true;
  double max_tilt_deg = 50.0;
  // Following the terrain outward.
  bool follow = true;
  bool smooth = true;
  bool strict_at_objects = true;
  bool reject_reflections = true;
  double step_up_m = 0.15;
  double step_down_m = 1.0;
  double gate_sigmas = 2.0;
  double height_noise_m = 0.03;
  double roughness_m = 0.063;
  double curvature = 0.055;
  // The point test.
  double tolerance_m = 0.2;
  double object_tolerance_m = 0.06;
  double object_height_m = 0.4;

  static void fields(auto&& field);
  void check() const;
};

/// The default ground method (`--method ground=default`): levels the scan by the plane around the sensor, follows the
/// lowest points outward on a polar grid, all sectors abreast, and tests every point against the small plane that its
/// cell has got. Needs neither rings nor a full turn, and of the mount only the rough direction of "up".
class TerrainGround final : public GroundSegmenter {
 public:
  /// Throws ConfigError as `TerrainGroundConfig::check`.
  explicit TerrainGround(const TerrainGroundConfig& config);
  ~TerrainGround() override;

  /// `T_base_sensor`: up may be wrong by `max_tilt_deg`, slope of the ground included; the height above the ground by
  /// half of itself, and it may be 0 for unknown.
  [[nodiscard]] GroundResult process(const PointsView& points, const Pose& T_base_sensor) override;

 private:
  struct State;
  TerrainGroundConfig config_;
  std::unique_ptr<State> state_;
};

void TerrainGroundConfig::fields(auto&& field) {
  using C = TerrainGroundConfig;
  field("sectors", &C::sectors, Range{16, 1024}, "sectors of the polar grid over a full turn");
  field("cell_m", &C::cell_m, Range{0.1, 2.0},
        "length of a cell up to 8 m from the sensor; twice that up to 24 m, four times up to 56 m and so on");
  field("min_range_m", &C::min_range_m, Range{0.0, 50.0},
        "nearer points do not shape the ground: they may be the machine itself");
  field("max_range_m", &C::max_range_m, Range{5.0, 500.0}, "farther points are not ground");
  field("level", &C::level, "find the plane around the sensor; off: trust the mount");
  field("max_tilt_deg", &C::max_tilt_deg, Range{1.0, 80.0}, "most that the plane may lean from the mount's up");
  field("follow", &C::follow, "follow the terrain outward; off: the plane is the ground");
  field("smooth", &C::smooth, "let neighbouring sectors share what they know");
  field("strict_at_objects", &C::strict_at_objects,
        "where a cell holds something high, take its lowest point for ground only without a step, and nothing above "
        "object_tolerance_m");
  field("reject_reflections", &C::reject_reflections, "do not follow a drop that no neighbouring sector shares");
  field("step_up_m", &C::step_up_m, Range{0.0, 2.0},
        "rise over the expected height that is ground still, as a kerb is");
  field("step_down_m", &C::step_down_m, Range{0.0, 10.0}, "drop below the expected height that is ground still");
  field("gate_sigmas", &C::gate_sigmas, Range{0.0, 10.0},
        "widens both steps by the uncertainty of the expected height");
  field("height_noise_m", &C::height_noise_m, Range{0.001, 1.0}, "noise of the lowest point of a cell");
  field("roughness_m", &C::roughness_m, Range{0.0, 1.0}, "what the height wanders at random within a metre");
  field("curvature", &C::curvature, Range{0.0, 1.0}, "what the slope wanders at random within a metre");
  field("tolerance_m", &C::tolerance_m, Range{0.01, 2.0}, "points up to this above the ground belong to it");
  field("object_tolerance_m", &C::object_tolerance_m, Range{0.01, 2.0}, "the same in a cell with an object");
  field("object_height_m", &C::object_height_m, Range{0.05, 10.0},
        "a cell that reaches this far above its lowest point holds an object");
}

}  // namespace berm
