#pragma once

#include <vector>

#include "berm/sim/weather.hpp"
#include "plume_crossings.hpp"
#include "plume_tree.hpp"

namespace berm::sim {

/// Plumes of dust. Light is lost along a beam as Beer and Lambert say; where a beam loses its light, some comes back.
class Dust {
 public:
  Dust(std::vector<Plume> plumes, const OpticsConfig& optics);

  [[nodiscard]] bool is_empty() const { return tree_.is_empty(); }
  /// Adds to `path` what dust does to the beam: less transmission, and an echo if it is nearer than the one there is.
  void pass(const AirBeam& beam, Random& random, AirPath& path) const;

 private:
  [[nodiscard]] double farthest_m(double most_per_m, double left) const;
  /// `left` is how much of the light gets as far as to where some comes back.
  void add_echo(const PlumeCrossings& crossings, double left, double end_m, AirPath& path) const;

  PlumeTree tree_;
  OpticsConfig optics_;
  double limit_;
};

}  // namespace berm::sim
