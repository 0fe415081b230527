#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "berm/core/pose.hpp"
#include "berm/geometry/level_points.hpp"
#include "berm/piste/boundary_piste.hpp"
#include "piste_surface.hpp"

namespace berm {

/// Slope and cross-fall of the surface straight ahead, from `kSlopeFrom_m` to where the piste ends or P's 40 m; none
/// if that is too short to say, or the surface too little known.
[[nodiscard]] std::optional<SlopeAhead> find_slope_ahead(const PisteSurface& surface, const Pose& T_base_level,
                                                         double piste_ends_m);

/// Finds what stands in the machine's way. Keeps its memory.
class ObstacleAhead {
 public:
  explicit ObstacleAhead(const BoundaryPisteConfig& config);

  /// Distance along x of base_link to the first half metre of the machine's way that holds three obstacle points or
  /// more, with those of the next half metre; none: the way is free as far as is seen. `obstacles`: the points that
  /// are some.
  [[nodiscard]] std::optional<double> find(std::span<const std::uint32_t> obstacles, const LevelPoints& level,
                                           const PisteSurface& surface, const Pose& T_base_level);

 private:
  BoundaryPisteConfig config_;
  std::vector<int> counts_;
};

}  // namespace berm
