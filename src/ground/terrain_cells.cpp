#include "terrain_cells.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "berm/core/multiversion.hpp"

namespace berm {
namespace {

/// Ranges are shifted by this power of two, so that the first octave spans 0 .. 8 m.
constexpr float kShift_m = 8.0F;
constexpr std::int32_t kShiftBits = std::bit_cast<std::int32_t>(kShift_m);
constexpr float kBitsPerOctave = 8388608.0F;  // 2^23: one exponent step of a float

constexpr float kPi = std::numbers::pi_v<float>;

/// Arc tangent of 0 .. 1 within 7e-4 rad, a fiftieth of a sector: the odd polynomial that interpolates it at the
/// Chebyshev nodes of the interval.
constexpr float arc_tangent(float t) {
  const float t2 = t * t;
  return t * (0.9953F + t2 * (-0.2887F + t2 * 0.0793F));
}

/// Everything `locate_points` needs, by value: the compiler must not fear that writing results changes it.
struct Locator {
  LevelFrame frame;
  float max_range_m;
  float bins_per_bit;
  float sectors_per_rad;
  int sectors;
  int last_bin;
  int nowhere;
};

BERM_MULTIVERSION
void locate(const float* __restrict x, const float* __restrict y, const float* __restrict z, std::size_t count,
            Locator l, std::uint16_t* __restrict cell, float* __restrict height_m) {
  for (std::size_t i = 0; i < count; ++i) {
    const float px = x[i];
    const float py = y[i];
    const float pz = z[i];
    const float level_x = l.frame.xx * px + l.frame.xy * py + l.frame.xz * pz;
    const float level_y = l.frame.yx * px + l.frame.yy * py + l.frame.yz * pz;
    const float height = l.frame.zx * px + l.frame.zy * py + l.frame.zz * pz + l.frame.z0;
    height_m[i] = height;

    const float range = std::sqrt(level_x * level_x + level_y * level_y);
    const float rise = std::fabs(height);
    const float extent = std::fabs(px) + std::fabs(py) + std::fabs(pz);
    // Without a branch: "and" that may stop early keeps g++ from using wide registers.
    const bool inside = (range < l.max_range_m) & (rise < l.max_range_m) & (extent > 0.0F);

    const float along = std::fabs(level_x);
    const float across = std::fabs(level_y);
    const float larger = along > across ? along : across;
    const float smaller = along > across ? across : along;
    float azimuth = arc_tangent(smaller / (larger > 1e-9F ? larger : 1e-9F));
    azimuth = across > along ? 0.5F * kPi - azimuth : azimuth;
    azimuth = level_x < 0.0F ? kPi - azimuth : azimuth;
    azimuth = level_y < 0.0F ? -azimuth : azimuth;

    const float turn = inside ? (azimuth + kPi) * l.sectors_per_rad : 0.0F;
    const float shifted_m = (inside ? range : 0.0F) + kShift_m;
    const int sector = static_cast<int>(turn);
    const int bin =
        static_cast<int>(static_cast<float>(std::bit_cast<std::int32_t>(shifted_m) - kShiftBits) * l.bins_per_bit);
    const int wrapped = sector < l.sectors ? sector : 0;
    const int kept = bin < l.last_bin ? bin : l.last_bin;  // rounding at the outermost edge
    cell[i] = static_cast<std::uint16_t>(inside ? kept * l.sectors + wrapped : l.nowhere);
  }
}

}  // namespace

TerrainCells::TerrainCells(int sector_count, double cell_m, double max_range)
    : sectors(sector_count),
      bins_per_octave(std::max(1, static_cast<int>(std::lround(static_cast<double>(kShift_m) / cell_m)))),
      max_range_m(static_cast<float>(max_range)) {
  edges_m.push_back(0.0F);
  for (float octave_m = kShift_m; edges_m.back() < max_range_m; octave_m *= 2.0F) {
    for (int i = 1; i <= bins_per_octave && edges_m.back() < max_range_m; ++i) {
      const float share = static_cast<float>(i) / static_cast<float>(bins_per_octave);
      edges_m.push_back(octave_m * (1.0F + share) - kShift_m);
    }
  }
  bins = static_cast<int>(edges_m.size()) - 1;
}

PolarGrid TerrainCells::grid() const {
  return {sectors, std::vector<double>(edges_m.begin(), edges_m.end())};
}

LevelFrame::LevelFrame(const Pose& T_level_sensor) {
  const Eigen::Matrix3f r = T_level_sensor.rotation().toRotationMatrix().cast<float>();
  xx = r(0, 0), xy = r(0, 1), xz = r(0, 2);
  yx = r(1, 0), yy = r(1, 1), yz = r(1, 2);
  zx = r(2, 0), zy = r(2, 1), zz = r(2, 2);
  z0 = static_cast<float>(T_level_sensor.translation_m().z());
}

void locate_points(const PointsView& points, const LevelFrame& frame, const TerrainCells& cells,
                   std::span<std::uint16_t> cell, std::span<float> height_m) {
  const Locator locator{.frame = frame,
                        .max_range_m = cells.max_range_m,
                        .bins_per_bit = static_cast<float>(cells.bins_per_octave) / kBitsPerOctave,
                        .sectors_per_rad = static_cast<float>(cells.sectors) / (2.0F * kPi),
                        .sectors = cells.sectors,
                        .last_bin = cells.bins - 1,
                        .nowhere = static_cast<int>(cells.size())};
  locate(points.x.data(), points.y.data(), points.z.data(), points.size(), locator, cell.data(), height_m.data());
}

}  // namespace berm
