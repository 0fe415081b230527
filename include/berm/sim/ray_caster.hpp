#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

#include <Eigen/Core>

#include "berm/sim/world.hpp"

namespace berm::sim {

/// Where a ray first meets the world.
struct Hit {
  double range_m = 0.0;
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< unit, towards the origin of the ray
  Material material;
  double inside_m = 0.0;     ///< terrain only, as GroundSample
  double across_m = 0.0;     ///< terrain only, as GroundSample
  std::uint32_t object = 0;  ///< 0 terrain, 1 standing things, 2.. movers
};

struct RayCasterConfig {
  double fine_cell_m = 0.25;   ///< mesh of the terrain near the route
  double fine_width_m = 25.0;  ///< how far from the route it is that fine; coarser by two for every doubling
};

/// The world as triangles in an Embree scene. Thread-safe after construction.
class RayCaster {
 public:
  RayCaster(const World& world, const RayCasterConfig& config);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  /// First hit between the ranges; `time_s` places the movers. False: nothing there.
  [[nodiscard]] bool cast(const Eigen::Vector3d& origin_m, const Eigen::Vector3d& direction, double min_range_m,
                          double max_range_m, double time_s, Hit& hit) const;
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace berm::sim
