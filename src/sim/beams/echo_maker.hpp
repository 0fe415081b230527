#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "air/air_lanes.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/weather.hpp"
#include "echo.hpp"
#include "report_lanes.hpp"
#include "surface_lanes.hpp"

namespace berm::sim {

/// What a beam gives: nothing if the range is 0.
struct Return {
  float range_m = 0.0F;
  float reflectivity = 0.0F;
  std::uint32_t label = 0;
};

/// A beam whose rays are settled; they share its energy equally.
struct FiredBeam {
  std::span<const TracedRay> rays;
  Random* random = nullptr;
};

/// Turns what the rays of beams met into what the sensor reports. It takes a block of beams at a time through one step
/// after the other, so that the processor can compute with eight of them at once.
class EchoMaker {
 public:
  /// Beams of a block.
  static constexpr std::size_t kBlock = SurfaceLanes::kBeams;
  static_assert(kBlock <= AirLanes::kMost);

  /// Memory that a block needs on the way.
  struct Lanes {
    SurfaceLanes::Lanes<TerrainSpot> spots;  ///< of all rays
    SurfaceLanes surfaces;
    AirLanes air;
    ReportLanes reports;
  };

  EchoMaker(const RayCaster& caster, const Weather& weather, const OpticsConfig& optics);

  /// What up to `kBlock` beams give; `height_m` is that of the sensor above the ground.
  void returns_of(std::span<const FiredBeam> beams, double height_m, Lanes& lanes, std::span<Return> returns) const;

 private:
  /// What belongs to one beam of a block.
  struct Parts {
    std::size_t first = 0;  ///< of the lanes of its surfaces
    std::size_t count = 0;
    float nearest_m = 0.0F;  ///< where the first of the rays ends
    bool on_ground = false;  ///< whether that is the terrain
    bool is_lost = false;    ///< for no reason
    std::size_t air = 0;     ///< lane of the air
  };
  using Block = std::array<Parts, kBlock>;

  /// `SurfaceOptics` as lanes hold them.
  struct LaneOptics {
    float reflectivity;
    float reflectivity_sigma;
    float relief_m;
    float mirror;
    float roughness;
    float ridges;
  };

  void meet(std::span<const FiredBeam> beams, Lanes& lanes, Block& block) const;
  void add_surface(const TracedRay& ray, const TerrainSpot& spot, float share, Random& random, SurfaceLanes& lanes,
                   Parts& parts) const;
  void pass_air(std::span<const FiredBeam> beams, double height_m, AirLanes& air, Block& block) const;
  void receive(std::span<const FiredBeam> beams, const Block& block, Lanes& lanes) const;
  /// Melts the echoes of a beam and takes one; nullptr if the sensor detects none.
  [[nodiscard]] const Echo* choose(std::span<Echo> echoes, Random& random) const;
  [[nodiscard]] bool finds(const Echo& echo, Random& random) const;

  const RayCaster& caster_;
  const Weather& weather_;
  const OpticsConfig& optics_;
  EchoChoice choice_;
  bool weathers_;
  float per_limit_;  ///< one over the light at which half of the echoes are found
  float min_range_m_;
  float max_range_m_;
  float separation_m_;
  std::array<LaneOptics, kSurfaces> lane_optics_{};
};

}  // namespace berm::sim
