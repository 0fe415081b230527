#pragma once

#include <memory>

#include "berm/core/config.hpp"
#include "berm/snow/snow.hpp"

namespace berm {

/// Settings of the default snow method. docs/snow.md shows what each step is worth.
struct SparseSnowConfig {
  double max_range_m = 15.0;
  bool use_intensity = true;
  bool spare_lines = true;
  bool fade_with_range = true;
  bool ask_for_spread = true;
  double window = 0.05;
  double dark_share = 0.3;
  double dark_points = 3.0;
  double bright_share = 0.08;
  double bright_points = 1.0;
  double surface_weight = 0.5;

  static void fields(auto&& field);
  void check() const { check_fields(*this, "snow"); }
};

/// The default snow method (`--method snow=default`): a flake is a dark near point that has few neighbours of its own
/// range, measured in angles, so that the density of the sensor's beams does not matter. What is dark, and whether it
/// snows at all, follows from the scan. Without intensity a flake has to stand quite alone.
///
/// Needs neither firing order nor the mount: marks do not depend on the order of the points.
class SparseSnow final : public SnowFilter {
 public:
  /// Throws ConfigError as `SparseSnowConfig::check`.
  explicit SparseSnow(const SparseSnowConfig& config);
  ~SparseSnow() override;

  [[nodiscard]] SnowResult process(const PointsView& points, const Pose& T_base_sensor) override;

 private:
  struct State;
  SparseSnowConfig config_;
  std::unique_ptr<State> state_;
};

void SparseSnowConfig::fields(auto&& field) {
  using C = SparseSnowConfig;
  field("max_range_m", &C::max_range_m, Range{1.0, 100.0}, "flakes farther away are not looked for");
  field("use_intensity", &C::use_intensity, "no: as for a sensor without");
  field("spare_lines", &C::spare_lines, "what goes on to both sides at one range is no flake: poles, wires, ground");
  field("fade_with_range", &C::fade_with_range, "the farther, the more alone must a flake be");
  field("ask_for_spread", &C::ask_for_spread, "a few marks count only if they are spread over the view, as snow is");
  field("window", &C::window, Range{0.001, 0.5}, "neighbours are like a point up to this share of its range");
  field("dark_share", &C::dark_share, Range{0.0, 1.0}, "share of its neighbours that may be like a dark flake");
  field("dark_points", &C::dark_points, Range{0.0, 100.0}, "how many may be on top of that");
  field("bright_share", &C::bright_share, Range{0.0, 1.0}, "dark_share where intensity does not tell");
  field("bright_points", &C::bright_points, Range{0.0, 100.0}, "dark_points where intensity does not tell");
  field("surface_weight", &C::surface_weight, Range{0.0, 10.0},
        "a level of intensity is dark if it has more flakes than surface points times this");
}

}  // namespace berm
