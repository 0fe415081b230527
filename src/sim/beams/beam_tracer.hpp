#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "berm/sim/random.hpp"
#include "berm/sim/ray_caster.hpp"

namespace berm::sim {

/// Mean way of light into a crown before it meets a needle or leaf: 1 / (0.5 x 3.3 m2 of leaf per m3), as dense as
/// spruces are.
constexpr double kCrownDepth_m = 0.6;
/// Share of the light that meets the cords of a safety net as it crosses it.
constexpr double kNetShare = 0.35;

/// A ray on its way through porous things until it meets something.
struct TracedRay {
  Eigen::Vector3f origin_m = Eigen::Vector3f::Zero();
  Eigen::Vector3f direction = Eigen::Vector3f::UnitX();
  double time_s = 0.0;
  std::uint32_t beam = 0;
  float from_m = 0.0F;             ///< where the next cast begins
  RawHit hit;                      ///< of the last cast; what it met once it is settled
  std::uint32_t crown_object = 0;  ///< where it went into a crown
  std::uint32_t crown_triangle = 0;
  float crown_end_m = std::numeric_limits<float>::infinity();  ///< how deep it gets in the crown
  std::uint16_t crowns = 0;                                    ///< in how many at once
  std::uint16_t casts = 0;
};

/// The first hits of all rays. Rays `step` apart look in nearly the same direction: they are packed together.
void cast_all(const RayCaster& caster, std::span<TracedRay> rays, std::size_t step, float max_range_m);

/// Memory of `settle`: the rays that go on, and room to sort them.
struct PendingRays {
  std::vector<std::uint32_t> rays;
  std::vector<std::uint32_t> sorted;
};

/// Goes on from the hits of `cast_all` until every ray has met what it does not pass. `randoms` is by beam; `pending`
/// is memory.
void settle(const RayCaster& caster, std::span<TracedRay> rays, float max_range_m, std::span<Random> randoms,
            PendingRays& pending);

}  // namespace berm::sim
