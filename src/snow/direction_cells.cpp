#include "direction_cells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "berm/core/multiversion.hpp"

namespace berm {
namespace {

/// No sensor sees 10 km; coordinates beyond are noise of a broken file.
constexpr float kAbsurd_m = 1e4F;

/// Of a smaller coordinate the reciprocal is infinite.
constexpr float kSmallest_m = std::numeric_limits<float>::min();

/// Takes t = tan of an angle up to 45 deg to -1 .. 1, about evenly in the angle: 4 / pi atan(t) within 0.005.
constexpr float kBend = 0.2732F;

struct Place {
  std::int32_t cell;
  float range_m;
};

/// Without branches, so that the compiler can do eight points at once.
inline Place place_of(float x, float y, float z, std::int32_t side, std::int32_t nowhere) {
  const float ax = std::fabs(x);
  const float ay = std::fabs(y);
  const float az = std::fabs(z);
  const float axy = ax > ay ? ax : ay;
  const float largest = axy > az ? axy : az;
  const bool usable = (largest >= kSmallest_m) & (ax < kAbsurd_m) & (ay < kAbsurd_m) & (az < kAbsurd_m);
  const bool on_z = az > axy;
  const bool on_y = !on_z & (ay > ax);
  const float main = on_z ? z : (on_y ? y : x);
  const float first = (on_z | on_y) ? x : y;
  const float second = on_z ? y : z;
  const float scale = 1.0F / (usable ? largest : 1.0F);
  const float u = (usable ? first : 0.0F) * scale;
  const float v = (usable ? second : 0.0F) * scale;
  const float half = 0.5F * static_cast<float>(side);
  const auto column = static_cast<std::int32_t>((u * (1.0F + kBend - kBend * std::fabs(u)) + 1.0F) * half);
  const auto row = static_cast<std::int32_t>((v * (1.0F + kBend - kBend * std::fabs(v)) + 1.0F) * half);
  const std::int32_t last = side - 1;
  const std::int32_t face = (on_z ? 4 : (on_y ? 2 : 0)) + (main < 0.0F ? 1 : 0);
  const std::int32_t cell = (face * side + (row < last ? row : last)) * side + (column < last ? column : last);
  return {usable ? cell : nowhere, usable ? std::sqrt(x * x + y * y + z * z) : 0.0F};
}

BERM_MULTIVERSION
void locate_all(const float* __restrict x, const float* __restrict y, const float* __restrict z, std::size_t count,
                std::int32_t side, std::int32_t nowhere, std::uint32_t* __restrict cell, float* __restrict range_m) {
  for (std::size_t i = 0; i < count; ++i) {
    const Place place = place_of(x[i], y[i], z[i], side, nowhere);
    cell[i] = static_cast<std::uint32_t>(place.cell);
    range_m[i] = place.range_m;
  }
}

/// Inverse of the bend, also a little beyond 1.
float straighten(float bent) {
  const float b = 1.0F + kBend;
  const float size = (b - std::sqrt(b * b - 4.0F * kBend * std::fabs(bent))) / (2.0F * kBend);
  return std::copysign(size, bent);
}

}  // namespace

void DirectionCells::locate(const PointsView& points, std::span<std::uint32_t> cell, std::span<float> range_m) const {
  locate_all(points.x.data(), points.y.data(), points.z.data(), points.size(), side(),
             static_cast<std::int32_t>(nowhere()), cell.data(), range_m.data());
}

/// A place beyond the edge of a face still has a direction, and that lies on another face.
std::uint32_t DirectionCells::at(int face_of, int row_of, int column_of) const {
  const auto cells = static_cast<float>(side());
  const float u = straighten((2.0F * static_cast<float>(column_of) + 1.0F) / cells - 1.0F);
  const float v = straighten((2.0F * static_cast<float>(row_of) + 1.0F) / cells - 1.0F);
  const float main = face_of % 2 == 0 ? 1.0F : -1.0F;
  const std::array<float, 3> on_x = {main, u, v};
  const std::array<float, 3> on_y = {u, main, v};
  const std::array<float, 3> on_z = {u, v, main};
  const std::array<float, 3>& d = face_of / 2 == 0 ? on_x : (face_of / 2 == 1 ? on_y : on_z);
  return static_cast<std::uint32_t>(place_of(d[0], d[1], d[2], side(), static_cast<std::int32_t>(nowhere())).cell);
}

std::array<std::uint32_t, 9> DirectionCells::block(std::uint32_t cell) const {
  std::array<std::uint32_t, 9> cells{};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const int down = static_cast<int>(i / 3) - 1;
    const int right = static_cast<int>(i % 3) - 1;
    const std::uint32_t found = at(face(cell), row(cell) + down, column(cell) + right);
    const auto end = cells.begin() + static_cast<std::ptrdiff_t>(i);
    cells[i] = std::find(cells.begin(), end, found) == end ? found : nowhere();
  }
  return cells;
}

}  // namespace berm
