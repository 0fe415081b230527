#pragma once

#include "berm/core/pose_guard.hpp"
#include "berm/core/scan.hpp"
#include "berm/core/trajectory.hpp"
#include "scan_motion.hpp"

namespace berm {

/// Sets `motion` to that of the sensor over the scan, from its first point to its last, and `first_s` to the time of
/// the first since the stamp. Says how far the poses are to be trusted; unless they are, nothing is set.
[[nodiscard]] PoseTrust place_scan(const Scan& scan, const Trajectory& T_world_base, const PoseGuard& guard,
                                   ScanMotion& motion, double& first_s);

}  // namespace berm
