#pragma once

#include <memory>
#include <string>

#include "berm/core/config.hpp"
#include "berm/odometry/odometry.hpp"

namespace berm {

/// Settings of the published odometry: METHODS section 6. What P does not say is LOAM-Livox' (Lin, Zhang 2020, and the
/// settings that its authors publish for precision, which share P's thresholds).
struct FeatureOdometryConfig {
  // Which of the variants that P compares in its figure 23.
  std::string variant = "four_classes_capped";
  int max_piste_planes = 1500;  ///< P gives no number: a third of what the groomer sees
  // Features.
  int neighbours = 2;               ///< LOAM-Livox
  double edge_curvature = 0.1;      ///< P eq. 10
  double plane_curvature = 0.005;   ///< P eq. 10
  double min_range_m = 1.0;         ///< LOAM-Livox
  double max_edge_range_m = 30.0;   ///< LOAM-Livox
  double min_view_angle_deg = 5.0;  ///< LOAM-Livox
  double edge_spacing_m = 0.1;      ///< LOAM-Livox
  double plane_spacing_m = 0.4;     ///< LOAM-Livox
  int max_class_features = 4000;    ///< ours: bounds the work
  // Motion within the scan.
  std::string deskew = "pieces";  ///< LOAM-Livox
  int pieces = 3;                 ///< LOAM-Livox
  // Matching.
  double max_edge_distance_m = 1.4;    ///< LOAM-Livox: 2 m2
  double max_plane_distance_m = 7.0;   ///< LOAM-Livox: 50 m2
  double huber_m = 0.1;                ///< LOAM-Livox
  double inlier_share = 0.8;           ///< LOAM-Livox
  double inlier_m = 0.02;              ///< LOAM-Livox
  int max_rounds = 15;                 ///< LOAM-Livox
  double max_speed_mps = 30.0;         ///< LOAM-Livox: 9
  double max_turn_rate_degps = 600.0;  ///< LOAM-Livox: 20 deg a piece
  // The map.
  int keep_scans = 133;   ///< LOAM-Livox: 400 pieces
  double keep_m = 100.0;  ///< LOAM-Livox

  static void fields(auto&& field);
  void check() const { check_fields(*this, "odometry_reference"); }
};

/// The odometry as document P publishes it (`--method odometry=reference`): LOAM-Livox with features of four classes,
/// piste or obstacle, plane or edge, each of which is matched against its own class only, and a limit on the planes of
/// the piste. Kept for comparison; its faults are kept too: it knows no motion before the scan and holds nothing where
/// the scan says nothing, it only says so.
///
/// Bounded work per scan and memory; the same scans, the same poses.
class FeatureOdometry final : public Odometry {
 public:
  /// Throws ConfigError as `FeatureOdometryConfig::check`.
  explicit FeatureOdometry(const FeatureOdometryConfig& config);
  ~FeatureOdometry() override;

  [[nodiscard]] OdometryResult process(const OdometryInput& input) override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

void FeatureOdometryConfig::fields(auto&& field) {
  using C = FeatureOdometryConfig;
  field("variant", &C::variant, Choices{{"one_class", "four_classes", "four_classes_capped"}},
        "whether labels tell features apart, and whether the planes of the piste are limited");
  field("max_piste_planes", &C::max_piste_planes, Range{10, 100000},
        "plane features of the piste per scan, those of the smallest curvature");
  field("neighbours", &C::neighbours, Range{1, 20}, "on either side, of which the curvature is taken");
  field("edge_curvature", &C::edge_curvature, Range{0.0, 10.0}, "an edge feature has more");
  field("plane_curvature", &C::plane_curvature, Range{0.0, 10.0}, "a plane feature has less");
  field("min_range_m", &C::min_range_m, Range{0.1, 50.0}, "nearer points are the machine's own");
  field("max_edge_range_m", &C::max_edge_range_m, Range{1.0, 500.0}, "farther points are no edge feature");
  field("min_view_angle_deg", &C::min_view_angle_deg, Range{0.0, 80.0},
        "between the beam and the surface along the trace; flatter ones are no plane feature");
  field("edge_spacing_m", &C::edge_spacing_m, Range{0.01, 5.0},
        "side of the voxels that edge features are thinned with");
  field("plane_spacing_m", &C::plane_spacing_m, Range{0.01, 5.0},
        "side of the voxels that plane features are thinned with");
  field("max_class_features", &C::max_class_features, Range{10, 100000},
        "features of a class that are matched per piece of a scan, at most");
  field("deskew", &C::deskew, Choices{{"pieces", "interpolate"}},
        "each piece of a scan is rigid, or the motion within it is even");
  field("pieces", &C::pieces, Range{1, 20}, "that a scan is cut into; they are matched one after the other");
  field("max_edge_distance_m", &C::max_edge_distance_m, Range{0.01, 50.0}, "of the fifth neighbour of an edge feature");
  field("max_plane_distance_m", &C::max_plane_distance_m, Range{0.01, 50.0},
        "of the fifth neighbour of a plane feature");
  field("huber_m", &C::huber_m, Range{0.001, 10.0}, "residuals beyond this count less");
  field("inlier_share", &C::inlier_share, Range{0.1, 1.0},
        "share of the residuals that are kept after the first steps");
  field("inlier_m", &C::inlier_m, Range{0.0, 10.0}, "smaller residuals are always kept");
  field("max_rounds", &C::max_rounds, Range{1, 100}, "of finding neighbours and solving");
  field("max_speed_mps", &C::max_speed_mps, Range{0.1, 200.0}, "what moved faster is lost");
  field("max_turn_rate_degps", &C::max_turn_rate_degps, Range{1.0, 10000.0}, "what turned faster is lost");
  field("keep_scans", &C::keep_scans, Range{2, 100000}, "what was not seen for so many scans leaves the map");
  field("keep_m", &C::keep_m, Range{10.0, 1000.0}, "the map is cut beyond this distance from the machine");
}

}  // namespace berm
