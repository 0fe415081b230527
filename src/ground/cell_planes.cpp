#include "cell_planes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "berm/core/multiversion.hpp"

namespace berm {
namespace {

/// The tolerance grows by this per metre of range: footprints widen and grazing returns smear.
constexpr float kToleranceGrowth = 0.003F;

/// The ground of the cells of one bin.
struct BinGround {
  const float* height_m;
  const float* radial_slope;
  const std::uint8_t* has_object;
  float middle_m;
  float bare_m;
  float object_m;
};

/// Writes four floats per sector: nx, ny, nz, d.
BERM_MULTIVERSION
void build_bin(std::size_t sectors, BinGround ground, LevelFrame f, const float* __restrict cos_azimuth,
               const float* __restrict sin_azimuth, float* __restrict planes) {
  for (std::size_t s = 0; s < sectors; ++s) {
    const float outward = ground.radial_slope[s];
    // The ground is z = gx x + gy y + at_origin in the levelled frame.
    const float gx = outward * cos_azimuth[s];
    const float gy = outward * sin_azimuth[s];
    const float at_origin_m = ground.height_m[s] - outward * ground.middle_m;
    const float tolerance_m = ground.has_object[s] != 0 ? ground.object_m : ground.bare_m;
    planes[4 * s] = f.zx - gx * f.xx - gy * f.yx;
    planes[4 * s + 1] = f.zy - gx * f.xy - gy * f.yy;
    planes[4 * s + 2] = f.zz - gx * f.xz - gy * f.yz;
    planes[4 * s + 3] = f.z0 - at_origin_m - tolerance_m;
  }
}

}  // namespace

CellPlanes::CellPlanes(const TerrainCells& cells)
    : sectors_(static_cast<std::size_t>(cells.sectors)), planes_(cells.size() + 1, Plane{0.0F, 0.0F, 0.0F, 1.0F}) {
  for (std::size_t b = 0; b + 1 < cells.edges_m.size(); ++b) {
    middles_m_.push_back(0.5F * (cells.edges_m[b] + cells.edges_m[b + 1]));
  }
  for (std::size_t s = 0; s < sectors_; ++s) {
    const double turn = (static_cast<double>(s) + 0.5) / static_cast<double>(sectors_);
    const double azimuth_rad = (2.0 * turn - 1.0) * std::numbers::pi;
    cos_.push_back(static_cast<float>(std::cos(azimuth_rad)));
    sin_.push_back(static_cast<float>(std::sin(azimuth_rad)));
  }
}

void CellPlanes::build(const HeightGrid::Channels& surface, std::span<const std::uint8_t> has_object,
                       const LevelFrame& frame, float bare_m, float object_m) {
  for (std::size_t bin = 0; bin < middles_m_.size(); ++bin) {
    const std::size_t first = bin * sectors_;
    const float grown_m = bare_m + kToleranceGrowth * middles_m_[bin];
    const BinGround ground{.height_m = surface.height_m.data() + first,
                           .radial_slope = surface.radial_slope.data() + first,
                           .has_object = has_object.data() + first,
                           .middle_m = middles_m_[bin],
                           .bare_m = grown_m,
                           .object_m = std::min(grown_m, object_m)};
    build_bin(sectors_, ground, frame, cos_.data(), sin_.data(), &planes_[first].nx);
  }
}

std::size_t CellPlanes::classify(const PointsView& points, std::span<const std::uint16_t> cell_of_point,
                                 std::span<GroundClass> classes) const {
  static_assert(static_cast<int>(GroundClass::not_ground) == 0 && static_cast<int>(GroundClass::ground) == 1);
  const float* const x = points.x.data();
  const float* const y = points.y.data();
  const float* const z = points.z.data();
  std::size_t ground = 0;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    const Plane& p = planes_[cell_of_point[i]];
    const float above_m = p.nx * x[i] + p.ny * y[i] + p.nz * z[i] + p.d;
    const int below = above_m < 0.0F ? 1 : 0;
    classes[i] = static_cast<GroundClass>(below);
    ground += static_cast<std::size_t>(below);
  }
  return ground;
}

}  // namespace berm
