#pragma once

#include <memory>

#include "berm/core/config.hpp"
#include "berm/piste/piste.hpp"

namespace berm {

/// Settings of the default piste method. docs/piste.md shows how little the result moves with each of the numbers,
/// and what each step is worth.
struct BoundaryPisteConfig {
  double max_range_m = 100.0;
  double machine_width_m = 5.0;
  double machine_height_m = 4.0;
  // Windows along the traces.
  double window_m = 1.0;
  double range_noise_m = 0.02;
  double roughness_m = 0.002;
  double curvature = 0.005;
  double tremble_mrad = 2.0;
  // What is off the piste.
  bool use_height = true;
  bool use_slope = true;
  bool use_roughness = true;
  bool use_obstacles = true;
  bool adapt = true;
  double height_noise_m = 0.05;
  double slope_noise = 0.06;
  // The seam.
  int passes = 2;
  double jump_cost = 0.15;
  int max_jump_bins = 25;

  static void fields(auto&& field);
  void check() const { check_fields(*this, "piste"); }
};

/// The default piste method (`--method piste=default`): cuts the traces of the beams on the ground into short windows,
/// holds the height, slope and roughness of each against the surface that the machine stands on, and draws the
/// boundary of the piste where, seen all around at once, that speaks for it. Works for a rosette, for rings and for
/// lasers that take turns; without any order it falls back to the profile of each sector.
class BoundaryPiste final : public PisteSegmenter {
 public:
  /// Throws ConfigError as `BoundaryPisteConfig::check`.
  explicit BoundaryPiste(const BoundaryPisteConfig& config);
  ~BoundaryPiste() override;

  [[nodiscard]] bool needs_series() const override { return false; }
  /// Without `input.surface` the mount is trusted for what is level.
  [[nodiscard]] PisteResult process(const PisteInput& input) override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

void BoundaryPisteConfig::fields(auto&& field) {
  using C = BoundaryPisteConfig;
  field("max_range_m", &C::max_range_m, Range{5.0, 500.0}, "obstacles in the way are looked for this far");
  field("machine_width_m", &C::machine_width_m, Range{0.5, 20.0}, "width of the way that has to be free");
  field("machine_height_m", &C::machine_height_m, Range{0.5, 20.0}, "height of the way that has to be free");
  field("window_m", &C::window_m, Range{0.2, 5.0},
        "length of the windows that a trace is cut into; beyond 20 times that in proportion to the range");
  field("range_noise_m", &C::range_noise_m, Range{0.0, 0.5}, "of the sensor, one sigma");
  field("roughness_m", &C::roughness_m, Range{0.0, 0.5}, "of groomed snow within a window, one sigma, at least");
  field("curvature", &C::curvature, Range{0.0, 1.0}, "what the slope of groomed snow turns by within a metre");
  field("tremble_mrad", &C::tremble_mrad, Range{0.0, 100.0},
        "what the machine turns by within a scan; counts where the order of firing is not known");
  field("use_height", &C::use_height, "heights beside the surface speak for the end of the piste");
  field("use_slope", &C::use_slope, "slopes beside that of the surface do");
  field("use_roughness", &C::use_roughness, "rough snow does");
  field("use_obstacles", &C::use_obstacles, "obstacles do: fences, trees");
  field("adapt", &C::adapt, "take the roughness of the snow just ahead for that of the piste");
  field("height_noise_m", &C::height_noise_m, Range{0.001, 1.0}, "of groomed snow about the surface, at least");
  field("slope_noise", &C::slope_noise, Range{0.001, 1.0}, "of groomed snow about that of the surface, at least");
  field("passes", &C::passes, Range{1, 10}, "of fitting the surface and drawing the boundary");
  field("jump_cost", &C::jump_cost, Range{0.0, 100.0},
        "evidence that a jump of the boundary by 4 % of the range between neighbouring bearings needs");
  field("max_jump_bins", &C::max_jump_bins, Range{1, 1000}, "longer jumps cost no more than this many");
}

}  // namespace berm
