#pragma once

#include <array>
#include <cstddef>

#include "air_lanes.hpp"
#include "plume_tree.hpp"

namespace berm::sim {

/// Sigmas from its middle to where a plume ends.
constexpr double kPlumeReach = 4.0;
/// Plumes that the beams of a packet can be in at once; more of them add nothing that could be seen.
constexpr std::size_t kMostCrossings = 64;

/// The plumes that the beams of a packet pass: Gaussians along each beam, whose depths are error functions. Up to a
/// range the depth is the sum of half_depth * (erf(range * rate - middle) + erf(middle)).
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): as many are written as are read
struct PlumeCrossings {
  using Packet = std::array<float, AirLanes::kPacket>;
  struct alignas(32) Crossing {
    Packet half_depth;
    Packet rate_per_m;
    Packet middle;
  };

  std::array<Crossing, kMostCrossings> crossings;
  std::size_t count = 0;            ///< of plumes that any beam crosses; 0: nothing else is known
  alignas(32) Packet before;        ///< sum of half_depth * erf(middle)
  alignas(32) Packet total;         ///< one-way optical depth of the whole beam
  alignas(32) Packet transmission;  ///< what is left of the light on the way there and back
  alignas(32) Packet most_per_m;    ///< no place on the line of the beam has more extinction
};

/// Fills in what the beams from lane `first` on, a packet of them, cross.
void find_crossings(const PlumeTree& tree, const AirLanes& beams, std::size_t first, PlumeCrossings& found);

/// One-way optical depth from the sensor to a range of every beam.
void depths_at(const PlumeCrossings& crossings, const PlumeCrossings::Packet& range_m, PlumeCrossings::Packet& depth);

/// Beams of any packets that seek places by the depth up to them, put together to a packet of their own.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): the constructor calls `clear`
struct PlaceSeekers {
  using Packet = PlumeCrossings::Packet;

  PlaceSeekers() { clear(); }
  void clear();
  [[nodiscard]] bool is_full() const { return count == AirLanes::kPacket; }
  /// Beam `lane` of a packet seeks the place between 0 and `to_m` where the depth is `depth`; that at the end is no
  /// less.
  void add(const PlumeCrossings& packet, std::size_t lane, float to_m, float depth, float depth_at_end);
  /// Fills in `range_m` and `extinction_per_m`.
  void find();

  PlumeCrossings crossings;
  std::size_t count = 0;
  alignas(32) Packet end_m{};
  alignas(32) Packet sought{};
  alignas(32) Packet end_depth{};
  alignas(32) Packet range_m{};
  alignas(32) Packet extinction_per_m{};
};

}  // namespace berm::sim
