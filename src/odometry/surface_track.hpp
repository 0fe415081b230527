#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "berm/odometry/odometry.hpp"
#include "scan_matcher.hpp"
#include "scan_points.hpp"
#include "scan_poses.hpp"
#include "surface_map.hpp"

namespace berm {

/// What is assumed of a motion that nothing is known of.
struct StartGuess {
  double speed_mps = 0.0;  ///< forward
  bool is_sure = true;     ///< else any speed up to a few m a second is as likely
};

/// One way to follow the scans: a map, and the machine in it.
class SurfaceTrack {
 public:
  SurfaceTrack(const SurfaceOdometryConfig& config, const StartGuess& guess, const Pose& T_world_base);

  /// Takes the next scan in: the points that are matched, and those that go into the map.
  [[nodiscard]] OdometryResult add(std::span<const ScanPoint> samples, std::span<const ScanPoint> for_map,
                                   double duration_s, Stamp stamp_ns);

  [[nodiscard]] const SurfaceMap& map() const { return map_; }
  [[nodiscard]] const Pose& T_world_base() const { return T_world_end_; }
  /// Of all scans that were added.
  [[nodiscard]] const std::vector<Pose>& begins() const { return begins_; }
  void forget_begins() { begins_.clear(); }
  /// Scans in a row that did not fit.
  [[nodiscard]] std::size_t lost_scans() const { return lost_; }

 private:
  [[nodiscard]] MotionPrior expect(double gap_s, double duration_s) const;
  /// Matches the second scan, which tells how the machine moved during the first: that is put into the map anew.
  [[nodiscard]] ScanMatch match_second(std::span<const ScanPoint> samples, double gap_s, double duration_s);
  [[nodiscard]] Vector6d velocity_to(const ScanPoses& motion, double time_s) const;
  void put_into_map(std::span<const ScanPoint> points, const ScanPoses& motion);
  [[nodiscard]] bool fits(const ScanMatch& match) const;
  [[nodiscard]] bool is_worth_mapping(const ScanPoses& motion) const;

  SurfaceOdometryConfig config_;
  StartGuess guess_;
  SurfaceMap map_;
  ScanMatcher matcher_;
  Pose T_world_end_;
  Vector6d velocity_ = Vector6d::Zero();  ///< per s, frame of the base
  std::optional<Stamp> end_ns_;           ///< of the scan before
  std::optional<Pose> T_world_mapped_;    ///< where the last scan was put into the map
  std::size_t mapped_ = 0;                ///< scans in the map
  std::size_t lost_ = 0;
  std::vector<Pose> begins_;
  std::vector<ScanPoint> first_scan_;  ///< until the second is matched
  Pose T_world_first_;                 ///< at the begin of the first scan
  double first_duration_s_ = 0.0;
};

}  // namespace berm
