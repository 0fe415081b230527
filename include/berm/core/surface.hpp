#pragma once

#include <compare>
#include <cstdint>

#include "berm/core/label.hpp"

namespace berm {

/// A square of a map: floor of the coordinates from the origin of the map divided by its side.
struct TileKey {
  std::int32_t x = 0;
  std::int32_t y = 0;

  friend constexpr bool operator==(const TileKey&, const TileKey&) = default;
  friend constexpr auto operator<=>(const TileKey&, const TileKey&) = default;
};

/// What one voxel of a surface map says.
struct SurfacePoint {
  float x_m = 0.0F;  ///< mean of the points in it, from the origin of the map
  float y_m = 0.0F;
  float z_m = 0.0F;
  float intensity = 0.0F;          ///< their mean, 0..255
  Label label = Label::unlabeled;  ///< what most of them were: drivable, terrain or obstacle
  std::uint32_t count = 0;         ///< points
  std::uint16_t drivable = 0;      ///< points with this label
  std::uint16_t terrain = 0;
  std::uint16_t obstacle = 0;
  std::uint16_t hits = 0;    ///< scans in which there was an obstacle about here; 0 where none ever was
  std::uint16_t passes = 0;  ///< scans that looked through instead

  friend constexpr bool operator==(const SurfacePoint&, const SurfacePoint&) = default;
};

}  // namespace berm
