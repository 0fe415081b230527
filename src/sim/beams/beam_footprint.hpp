#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "beam_tracer.hpp"
#include "berm/sim/sensor.hpp"

namespace berm::sim {

/// Rays that stand for the light of one beam where its footprint is not of one piece. Two beams fill a packet.
constexpr std::size_t kFootprintRays = RayPacket::kSize / 2;

/// Marks the beams whose footprint may hold an edge: those whose neighbours in angle met something else, or the same
/// thing on another plane. The footprint of a beam that agrees with its neighbours is of one piece, and its middle
/// stands for it. An edge also marks the beams before and after whose footprint may reach it. What lies between two
/// beams and in the footprint of neither marks them in vain; an edge that runs along the scanned line is not seen.
/// `lasers` fire in turn, so that the next beam of the same laser is that many on.
void find_torn(const RayCaster& caster, const Beams& beams, std::size_t lasers, const OpticsConfig& optics,
               std::span<const TracedRay> rays, std::vector<std::uint8_t>& torn);

/// The footprint of a beam, a rectangle as wide as its divergence, as rays of equal energy: one anywhere in each of
/// `kFootprintRays` equal parts. `up` is the z axis of the sensor in the world.
void spread(const TracedRay& middle, const Eigen::Vector3f& up, const OpticsConfig& optics, Random& random,
            std::span<TracedRay> rays);

}  // namespace berm::sim
