#pragma once

#include <vector>

#include "air_lanes.hpp"
#include "plume_crossings.hpp"
#include "plume_tree.hpp"

namespace berm::sim {

/// Plumes of dust. Light is lost along a beam as Beer and Lambert say; where a beam loses its light, some comes back.
class Dust {
 public:
  Dust(std::vector<Plume> plumes, const OpticsConfig& optics);

  [[nodiscard]] bool is_empty() const { return tree_.is_empty(); }
  /// What dust does to every beam: less transmission, and an echo if it is nearer than the one there is.
  void pass(AirLanes& beams) const;

 private:
  using Packet = PlumeCrossings::Packet;
  /// For every beam of a packet, how much of the light gets as far as to where some comes back.
  using Left = std::array<float, AirLanes::kPacket>;
  /// Beams that wait until there is a packet of them.
  struct Waiting {
    PlaceSeekers seekers;
    std::array<std::size_t, AirLanes::kPacket> lane{};
    Left left{};
  };

  void pass_packet(AirLanes& beams, std::size_t first, const PlumeCrossings& crossings, Waiting& waiting) const;
  void dim_flakes(AirLanes& beams, std::size_t first, const PlumeCrossings& crossings) const;
  void seek_echoes(AirLanes& beams, std::size_t first, const PlumeCrossings& crossings, const Left& left,
                   Waiting& waiting) const;
  [[nodiscard]] float farthest_m(float most_per_m, float left) const;
  void add_echoes(AirLanes& beams, Waiting& waiting) const;
  void add_echo(AirLanes& beams, std::size_t lane, double range_m, float extinction_per_m, double left) const;

  PlumeTree tree_;
  OpticsConfig optics_;
  double limit_;
  float bright_per_limit_;  ///< of a dense wall of dust a metre away
};

}  // namespace berm::sim
