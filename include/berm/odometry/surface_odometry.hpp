#pragma once

#include <memory>

#include "berm/core/config.hpp"
#include "berm/odometry/odometry.hpp"

namespace berm {

/// Settings of the default odometry.
struct SurfaceOdometryConfig {
  // What is taken of a scan.
  double min_range_m = 1.0;
  double max_range_m = 80.0;
  double map_spacing_m = 0.12;
  double sample_spacing_m = 0.2;
  double max_samples = 2500.0;
  double max_map_points = 8000.0;
  // The map.
  double fine_voxel_m = 0.5;
  double coarse_voxel_m = 1.5;
  double wide_voxel_m = 4.5;
  double keep_m = 100.0;
  // How it is matched.
  double noise_m = 0.02;
  double points_per_fact = 8.0;
  bool use_shapes = true;
  bool deskew = true;
  bool find_start = true;
  // How the machine moves.
  double acceleration_mps2 = 6.0;
  double turn_acceleration_rps2 = 0.7;

  static void fields(auto&& field);
  void check() const { check_fields(*this, "odometry"); }
};

/// The default odometry: every scan has two poses, at its begin and its end, which are moved until its points lie on
/// the surfaces of a map of voxels: planes where a voxel holds one, its cloud of points where it does not. The motion
/// before counts as much as a machine of limited acceleration allows, so that it decides only where the scan is mute.
/// At the start, when no motion is known, several speeds are followed, and the one that makes the sharpest map stays.
///
/// Bounded work per scan and memory; the same scans, the same poses.
class SurfaceOdometry final : public Odometry {
 public:
  /// Throws ConfigError as `SurfaceOdometryConfig::check`.
  explicit SurfaceOdometry(const SurfaceOdometryConfig& config);
  ~SurfaceOdometry() override;

  [[nodiscard]] OdometryResult process(const OdometryInput& input) override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

void SurfaceOdometryConfig::fields(auto&& field) {
  using C = SurfaceOdometryConfig;
  field("min_range_m", &C::min_range_m, Range{0.1, 50.0}, "nearer points are the machine's own");
  field("max_range_m", &C::max_range_m, Range{5.0, 500.0}, "farther points are not used");
  field("map_spacing_m", &C::map_spacing_m, Range{0.02, 2.0}, "of the points of a scan that go into the map");
  field("sample_spacing_m", &C::sample_spacing_m, Range{0.05, 5.0}, "of the points of a scan that are matched");
  field("max_samples", &C::max_samples, Range{100.0, 20000.0}, "points of a scan that are matched, at most");
  field("max_map_points", &C::max_map_points, Range{100.0, 100000.0}, "points of a scan that go into the map, at most");
  field("fine_voxel_m", &C::fine_voxel_m, Range{0.1, 5.0}, "side of the voxels of the map");
  field("coarse_voxel_m", &C::coarse_voxel_m, Range{0.2, 20.0}, "side of those used where the fine ones know no plane");
  field("keep_m", &C::keep_m, Range{10.0, 1000.0}, "the map is cut beyond this distance from the machine");
  field("noise_m", &C::noise_m, Range{0.001, 0.5}, "of a point across its surface, one sigma");
  field("points_per_fact", &C::points_per_fact, Range{1.0, 1000.0},
        "neighbouring points err together: so many count for one");
  field("use_shapes", &C::use_shapes,
        "match trees, nets and edges, which are no planes, by the spread of their points");
  field("deskew", &C::deskew, "give begin and end of a scan poses of their own");
  field("find_start", &C::find_start, "follow several speeds at the start; off: the machine stands or is well seen");
  field("acceleration_mps2", &C::acceleration_mps2, Range{0.05, 100.0}, "of the machine, one sigma");
  field("turn_acceleration_rps2", &C::turn_acceleration_rps2, Range{0.01, 100.0},
        "of its attitude, heaving included, one sigma");
}

}  // namespace berm
