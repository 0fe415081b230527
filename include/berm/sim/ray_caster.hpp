#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>

#include <Eigen/Core>

#include "berm/sim/world.hpp"

namespace berm::sim {

/// Where a ray first meets the world.
struct Hit {
  double range_m = 0.0;
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< unit, towards the origin of the ray
  Material material;
  double inside_m = 0.0;                                   ///< terrain only, as GroundSample
  double across_m = 0.0;                                   ///< terrain only, as GroundSample
  std::uint32_t object = 0;                                ///< 0 terrain, 1 standing things, 2.. movers
  Eigen::Vector2f across_slope = Eigen::Vector2f::Zero();  ///< terrain only: change of across_m along x and y
};

/// The same before anyone has asked what it is.
struct RawHit {
  static constexpr std::uint32_t kNothing = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t object = kNothing;  ///< as Hit::object, or kNothing
  std::uint32_t triangle = 0;       ///< of the mesh of the object; without meaning for the terrain
  float range_m = std::numeric_limits<float>::infinity();
  /// Unit, out of the front of the triangle: along the ray if it was met from behind.
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();

  [[nodiscard]] bool is_nothing() const { return object == kNothing; }
};

/// Where on the mesh of the terrain a ray met it.
struct TerrainSpot {
  std::uint32_t lower = 0;  ///< sample at the lower left corner of the cell
  std::uint32_t upper = 0;  ///< at the upper left one
  float share_u = 0.0F;     ///< place within the cell, 0..1
  float share_v = 0.0F;
  float cells_per_m = 0.0F;
};

struct RayCasterConfig {
  double fine_cell_m = 0.25;   ///< mesh of the terrain near the route
  double fine_width_m = 25.0;  ///< how far from the route it is that fine; coarser by two for every doubling
  int threads = 0;  ///< that sample the terrain; 0: as many as there are processors. Same mesh for any number
};

/// Rays that are cast together, which is quicker than one by one where they start and point nearly alike. Lanes whose
/// `max_range_m` is negative are left out.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): every lane is written before it is cast
struct alignas(64) RayPacket {
  static constexpr std::size_t kSize = 8;
  template <typename Value>
  using Lanes = std::array<Value, kSize>;

  Lanes<float> x_m;  ///< origin
  Lanes<float> y_m;
  Lanes<float> z_m;
  Lanes<float> dx;  ///< unit direction
  Lanes<float> dy;
  Lanes<float> dz;
  Lanes<float> min_range_m;
  Lanes<float> max_range_m;
  Lanes<double> time_s;  ///< places the movers
  Lanes<RawHit> hits;    ///< filled by casting

  [[nodiscard]] Eigen::Vector3f origin_m(std::size_t lane) const { return {x_m[lane], y_m[lane], z_m[lane]}; }
  [[nodiscard]] Eigen::Vector3f direction(std::size_t lane) const { return {dx[lane], dy[lane], dz[lane]}; }
};

/// The world as triangles in an Embree scene. Thread-safe after construction.
class RayCaster {
 public:
  /// Keeps what it needs of `world`. Throws Error(invalid_argument) for a mesh with broken indices, a terrain that is
  /// not finite, or an area that would need more than 2^26 cells.
  RayCaster(const World& world, const RayCasterConfig& config);
  ~RayCaster();
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  /// First hit between the ranges; `time_s` places the movers. False: nothing there.
  [[nodiscard]] bool cast(const Eigen::Vector3d& origin_m, const Eigen::Vector3d& direction, double min_range_m,
                          double max_range_m, double time_s, Hit& hit) const;
  /// The same for the rays of a packet.
  void cast(RayPacket& packet) const;
  /// What a ray met; `raw` must not be nothing.
  [[nodiscard]] Hit describe(const Eigen::Vector3f& origin_m, const Eigen::Vector3f& direction,
                             const RawHit& raw) const;
  /// The same in two steps, so that the processor can fetch in the meantime what the second one reads: many times
  /// `spot_of`, then as often `describe`.
  [[nodiscard]] TerrainSpot spot_of(const Eigen::Vector3f& origin_m, const Eigen::Vector3f& direction,
                                    const RawHit& raw) const;
  [[nodiscard]] Hit describe(const Eigen::Vector3f& direction, const RawHit& raw, const TerrainSpot& spot) const;
  /// Only what it is made of, which is cheaper. Not for the terrain.
  [[nodiscard]] Material material_of(const RawHit& hit) const;

  /// Of Embree and of what is kept beside it.
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace berm::sim
