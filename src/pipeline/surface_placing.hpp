#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "berm/core/label.hpp"
#include "berm/core/pose_guard.hpp"
#include "berm/core/scan.hpp"
#include "berm/map/surface_tiles.hpp"
#include "scan_motion.hpp"

namespace berm {

/// What one scan adds to the map of the surface. Keeps its memory.
struct PlacedSurface {
  PoseTrust trust = PoseTrust::no_pose;  ///< over the time of the scan; nothing below unless trusted
  std::size_t left_out = 0;              ///< points whose time is not known
  SurfaceScan scan;
  // Scratch.
  ScanMotion motion;
  std::vector<Eigen::Vector3d> ends_m;
};

/// Takes a scan to the world, each point with the pose at its own time: `placed.motion` says how the sensor moved, the
/// first point was taken at `first_s` since the stamp. Points that are drivable, terrain or obstacle within
/// `max_range_m` of the sensor are to be mapped; all returns, flakes too, tell what was looked through.
void place_surface(const Scan& scan, std::span<const Label> labels, double first_s, double max_range_m,
                   PlacedSurface& placed);

}  // namespace berm
