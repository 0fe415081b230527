#include "surface_map.hpp"

namespace berm {
namespace {

/// The many points on a wide plane err together: a flat road, seen so, would bend as the rings come along.
constexpr double kWideSay = 0.1;

}  // namespace

SurfaceMap::SurfaceMap(const SurfaceOdometryConfig& config)
    : use_shapes_(config.use_shapes),
      fine_(config.fine_voxel_m),
      coarse_(config.coarse_voxel_m),
      wide_(config.wide_voxel_m) {}

void SurfaceMap::add(const Eigen::Vector3d& world_m, bool is_ground) {
  SurfaceCell* fine = fine_.add(world_m);
  standing_ += fine != nullptr && !is_ground && fine->note_standing() ? 1U : 0U;
  coarse_.add(world_m);
  if (is_ground) {
    wide_.add(world_m);
  }
}

SurfaceHit SurfaceMap::find(const Eigen::Vector3d& world_m, bool is_ground) const {
  const SurfaceHit fine = fine_.find(world_m);
  if (fine.cell != nullptr && ((use_shapes_ && !is_ground) || fine.cell->shape() == SurfaceShape::plane)) {
    return fine;
  }
  const SurfaceHit coarse = coarse_.find(world_m);
  if (coarse.cell != nullptr && coarse.cell->shape() == SurfaceShape::plane) {
    return coarse;
  }
  const SurfaceHit wide = is_ground ? wide_.find(world_m) : SurfaceHit{};
  if (wide.cell != nullptr && wide.cell->shape() == SurfaceShape::plane) {
    return {wide.cell, wide.mean_m, kWideSay};
  }
  return {};
}

void SurfaceMap::clear() {
  fine_.clear();
  coarse_.clear();
  wide_.clear();
  standing_ = 0;
}

void SurfaceMap::cut(const Eigen::Vector3d& center_m, double radius_m) {
  standing_ -= fine_.cut(center_m, radius_m);
  coarse_.cut(center_m, radius_m);
  wide_.cut(center_m, radius_m);
}

}  // namespace berm
