#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "berm/odometry/feature_odometry.hpp"
#include "feature.hpp"
#include "voxel_means.hpp"

namespace berm {

/// A plane or line through neighbours in the map, frame world.
struct FeatureSurface {
  Eigen::Vector3d anchor_m;
  Eigen::Vector3d axis;  ///< normal of the plane, direction of the line: unit length
};

/// The plane through the first, middle and last of five neighbours, nearest first, as P eq. 11 has it; the line through
/// the first and last for edges (P eq. 12). None if the eigenvalues of their covariance say that they form none.
[[nodiscard]] std::optional<FeatureSurface> surface_through(const std::array<Eigen::Vector3d, 5>& neighbours_m,
                                                            bool edge);

/// The features of the scans before, each class for itself, and a kd-tree of each.
class FeatureMap {
 public:
  explicit FeatureMap(const FeatureOdometryConfig& config);
  ~FeatureMap();

  void add(const Eigen::Vector3d& world_m, FeatureClass kind, std::size_t scan);
  /// Cuts what is far or long not seen, and builds the trees anew. Until then `find` does not know what was added.
  void update(const Eigen::Vector3d& center_m, std::size_t scan);

  /// The surface of its class at a place. Valid for the state of the last `update`.
  [[nodiscard]] std::optional<FeatureSurface> find(const Eigen::Vector3d& world_m, FeatureClass kind) const;
  [[nodiscard]] std::size_t planes() const;
  [[nodiscard]] std::size_t size() const;

 private:
  struct Layer;
  const FeatureOdometryConfig config_;
  std::vector<std::unique_ptr<Layer>> layers_;
};

}  // namespace berm
