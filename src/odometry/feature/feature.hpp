#pragma once

#include <cstddef>
#include <cstdint>

#include <Eigen/Core>

namespace berm {

/// What a feature is matched against. With one class alone, planes and edges of obstacles stand for all.
enum class FeatureClass : std::uint8_t { piste_plane, piste_edge, obstacle_plane, obstacle_edge };
inline constexpr std::size_t kFeatureClasses = 4;

[[nodiscard]] constexpr bool is_edge(FeatureClass kind) {
  return kind == FeatureClass::piste_edge || kind == FeatureClass::obstacle_edge;
}

struct Feature {
  Eigen::Vector3d base_m;  ///< frame base, at its time
  double time_s = 0.0;     ///< since the stamp of the scan
  double curvature = 0.0;
  FeatureClass kind = FeatureClass::obstacle_plane;
};

}  // namespace berm
