#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "berm/geometry/voxel_hash.hpp"

namespace berm {

/// The surface in a voxel.
struct PlaceSurface {
  Eigen::Vector3d mean_m = Eigen::Vector3d::Zero();
  /// Of the place of a point of it, per m^2: along the normal alone for a plane.
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< zero unless it is a plane
};

/// The surfaces of one place, as the points of a few scans show them.
class PlaceSurfaces {
 public:
  PlaceSurfaces();

  void add(const Eigen::Vector3d& point_m);
  /// After the last point, before the first look.
  void fit();
  /// The fine surface at a place, or else the coarse one; null where there is none.
  [[nodiscard]] const PlaceSurface* find(const Eigen::Vector3d& point_m) const;
  /// The lowest height above the xy plane of the frame around a place; none where nothing was seen.
  [[nodiscard]] std::optional<double> ground_m(double x_m, double y_m) const;

 private:
  struct Cell {
    double count = 0.0;
    Eigen::Vector3d sum_m = Eigen::Vector3d::Zero();  ///< from the middle of the voxel
    Eigen::Matrix3d squares_m2 = Eigen::Matrix3d::Zero();
    PlaceSurface surface;
    bool is_known = false;
  };
  struct Lowest {
    double height_m = 0.0;
    bool is_seen = false;
  };
  static void add_to(VoxelHash<Cell>& voxels, const Eigen::Vector3d& point_m);
  static void fit_all(VoxelHash<Cell>& voxels);

  VoxelHash<Cell> fine_;
  VoxelHash<Cell> coarse_;
  VoxelHash<Lowest> ground_;
};

}  // namespace berm
