#pragma once

#include <vector>

#include "berm/sim/weather.hpp"
#include "plume_tree.hpp"

namespace berm::sim {

/// Plumes of dust. Light is lost along a beam as Beer and Lambert say; where a beam loses its light, some comes back.
class Dust {
 public:
  Dust(std::vector<Plume> plumes, const OpticsConfig& optics);

  [[nodiscard]] bool is_empty() const { return tree_.plumes().empty(); }
  /// Adds to `path` what dust does to the beam: less transmission, and an echo if it is nearer than the one there is.
  void pass(const AirBeam& beam, Random& random, AirPath& path) const;

 private:
  PlumeTree tree_;
  std::vector<Eigen::Vector3d> per_sigma_;  ///< one over the sigmas of each plume of the tree
  OpticsConfig optics_;
  double limit_;
};

}  // namespace berm::sim
