#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base_terrain.hpp"
#include "berm/sim/terrain.hpp"
#include "noise.hpp"
#include "pit_shape.hpp"
#include "road_details.hpp"
#include "run.hpp"

namespace berm::sim {

/// How rough what is, and what it is made of.
struct GroundStyle {
  Surface inside = Surface::groomed_snow;
  Surface outside = Surface::rough_snow;
  Surface wall = Surface::rock;
  double inside_sigma_m = 0.01;
  double inside_wave_m = 5.0;
  double outside_sigma_m = 0.1;
  double outside_wave_m = 3.0;
  double land_sigma_m = 0.5;
  double land_wave_m = 45.0;
};

/// The ground of a world: natural ground, runs graded into it, berms on top, roughness on all.
class BuiltTerrain : public Terrain {
 public:
  BuiltTerrain(std::vector<Run> runs, SmoothRaster natural, const GroundStyle& style, std::uint64_t seed);

  void add_pit(PitShape pit) { pit_ = std::move(pit); }
  void add_details(RoadDetails details) { details_ = std::move(details); }

  [[nodiscard]] GroundSample at(double x_m, double y_m) const override;
  [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }
  [[nodiscard]] const std::optional<PitShape>& pit() const { return pit_; }
  [[nodiscard]] const RoadDetails& details() const { return details_; }

  static constexpr std::size_t kMostRuns = 8;

 private:
  struct Blend {
    double graded_m = 0.0;
    double influence = 0.0;
    double inside_m = 0.0;
    std::size_t run = 0;  ///< the one that is deepest inside
  };
  using Places = std::array<RunPlace, kMostRuns>;

  [[nodiscard]] Blend blend_runs(double x_m, double y_m, Places& places) const;
  [[nodiscard]] double detail_share(const Places& places) const;
  [[nodiscard]] double natural_m(double x_m, double y_m, double left_m) const;
  [[nodiscard]] double berms_m(double x_m, double y_m, const Places& places) const;

  std::vector<Run> runs_;
  SmoothRaster natural_;
  GroundStyle style_;
  PlaneNoise noise_;
  std::optional<PitShape> pit_;
  RoadDetails details_;
};

}  // namespace berm::sim
