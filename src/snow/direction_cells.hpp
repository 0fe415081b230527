#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "berm/core/point_cloud.hpp"

namespace berm {

/// Cuts all directions from the sensor into cells of about equal size: a cube around the sensor, each face cut into
/// `side` x `side`. No direction is special, as the zenith is for azimuth and elevation, and a point costs one
/// division and no trigonometry. Cells are numbered face by face and row by row.
class DirectionCells {
 public:
  static constexpr int kFaces = 6;
  /// Side of the finest cells, 1.4 deg; coarser ones have a half, a quarter ... of it.
  static constexpr int kFinestSide = 64;

  explicit DirectionCells(int side);

  [[nodiscard]] std::size_t size() const { return kFaces * cells_of_face(); }
  [[nodiscard]] std::size_t cells_of_face() const {
    return static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_);
  }
  [[nodiscard]] int side() const { return side_; }
  /// The cell of points that are not usable.
  [[nodiscard]] std::uint16_t nowhere() const { return static_cast<std::uint16_t>(size()); }

  /// Cell and range of every point; `cell` and `range_m` are as long as `points`. Range is 0 for `nowhere`.
  void locate(const PointsView& points, std::span<std::uint16_t> cell, std::span<float> range_m) const;

  /// Whether the eight cells around `cell` lie on its own face.
  [[nodiscard]] bool is_inner(std::uint16_t cell) const;

  /// Row by row the nine cells around and including `cell`. At the corners of the cube, where three faces meet, one may
  /// come twice: its second place holds `nowhere`.
  [[nodiscard]] std::array<std::uint16_t, 9> block(std::uint16_t cell) const;

 private:
  [[nodiscard]] std::uint16_t at(int face, int row, int column) const;

  int side_;
};

}  // namespace berm
