#pragma once

#include <memory>

#include "berm/core/config.hpp"
#include "berm/piste/piste.hpp"

namespace berm {

/// Settings of the published piste method: METHODS sections 2 and 3, P eqs. 2-9. What is not P's is said to be ours.
struct EnvelopePisteConfig {
  // Slope ahead.
  double fan_min_m = 10.0;          ///< P section 2.2
  double fan_max_m = 40.0;          ///< P section 2.2
  double fan_half_angle_deg = 7.0;  ///< P section 2.2
  double fan_cell_m = 2.0;          ///< P section 2.2: 15 cells
  // Steps of the waveform.
  double z_step_m = 0.05;  ///< z_th, P eq. 3
  int z_neighbours = 6;    ///< P eqs. 3 and 4
  int z_votes = 4;         ///< P eq. 5
  double x_step_m = 0.05;  ///< x_th, P eq. 6
  int x_neighbours = 4;    ///< P eq. 6: j in 1..4
  int x_votes = 6;         ///< P eq. 8
  // Petals and what is made of them.
  double petal_rise_deg = 3.0;  ///< ours
  double corridor_m = 3.0;      ///< ours

  static void fields(auto&& field);
  /// Throws ConfigError for a value outside its range, or if the fan ends before it begins.
  void check() const;
};

/// The piste as document P finds it (`--method piste=reference`): within a petal everything from the first to the
/// last step of the waveform is an obstacle, all else piste. Kept for comparison; its faults are kept too.
///
/// It knows no terrain class, no boundary and no cross-fall, and uses neither the ground's labels nor its surface: a
/// point that is a return becomes drivable or obstacle. Falling snow, no-returns and invalid points stay what they are;
/// a return that the series has replaced all the same is unlabeled. Where the slope is unknown the thresholds are those
/// of level ground. A neighbour beyond an end of the scan casts no vote: the first and the last point are never an x
/// step.
class EnvelopePiste final : public PisteSegmenter {
 public:
  /// Throws ConfigError as `EnvelopePisteConfig::check`.
  explicit EnvelopePiste(const EnvelopePisteConfig& config);
  ~EnvelopePiste() override;

  /// Throws Error(invalid_argument) unless points, labels and series have one length.
  [[nodiscard]] bool needs_series() const override { return true; }
  [[nodiscard]] PisteResult process(const PisteInput& input) override;

 private:
  struct State;
  EnvelopePisteConfig config_;
  std::unique_ptr<State> state_;
};

void EnvelopePisteConfig::fields(auto&& field) {
  using C = EnvelopePisteConfig;
  field("fan_min_m", &C::fan_min_m, Range{0.0, 200.0}, "the slope is measured from this far ahead on");
  field("fan_max_m", &C::fan_max_m, Range{1.0, 500.0}, "and to here");
  field("fan_half_angle_deg", &C::fan_half_angle_deg, Range{0.1, 89.0}, "within this angle to either side");
  field("fan_cell_m", &C::fan_cell_m, Range{0.1, 100.0}, "length of a cell of that fan");
  field("z_step_m", &C::z_step_m, Range{0.001, 10.0}, "difference of height that is a vote for a step (z_th)");
  field("z_neighbours", &C::z_neighbours, Range{1, 16}, "neighbours on either side that may vote");
  field("z_votes", &C::z_votes, Range{0, 16}, "more votes than this on one side make a z step");
  field("x_step_m", &C::x_step_m, Range{0.001, 10.0}, "distance ahead of a neighbour that is a vote (x_th)");
  field("x_neighbours", &C::x_neighbours, Range{1, 5}, "neighbours on either side that may vote: at 1, 2, 4, 8, 16");
  field("x_votes", &C::x_votes, Range{0, 10}, "more votes than this, of both sides, make a turning point an x step");
  field("petal_rise_deg", &C::petal_rise_deg, Range{0.01, 90.0},
        "the beam must turn this far from the boresight and back for a petal to be one");
  field("corridor_m", &C::corridor_m, Range{0.1, 50.0}, "width of the way ahead that is searched for obstacles");
}

}  // namespace berm
