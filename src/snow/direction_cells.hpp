#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "berm/core/point_cloud.hpp"

namespace berm {

/// Cuts all directions from the sensor into cells of about equal size: a cube around the sensor, each face cut into
/// 2^n x 2^n. No direction is special, as the zenith is for azimuth and elevation, and a point costs one
/// division and no trigonometry. Cells are numbered face by face and row by row.
class DirectionCells {
 public:
  static constexpr int kFaces = 6;
  /// Side of the finest cells, 1.4 deg; coarser ones have a half, a quarter ... of it.
  static constexpr int kFinestBits = 6;
  static constexpr int kFinestSide = 1 << kFinestBits;

  /// `shift`: how often the side of the finest cells is doubled.
  explicit DirectionCells(int shift);

  [[nodiscard]] std::size_t size() const { return kFaces * cells_of_face(); }
  [[nodiscard]] std::size_t cells_of_face() const { return std::size_t{1} << (2 * bits_); }
  /// Cells along the side of a face.
  [[nodiscard]] int side() const { return 1 << bits_; }
  /// Place of a cell along the second and along the first axis of its face.
  [[nodiscard]] int row(std::uint16_t cell) const { return (cell >> bits_) & (side() - 1); }
  [[nodiscard]] int column(std::uint16_t cell) const { return cell & (side() - 1); }
  [[nodiscard]] int face(std::uint16_t cell) const { return cell >> (2 * bits_); }
  /// The cell of points that are not usable.
  [[nodiscard]] std::uint16_t nowhere() const { return static_cast<std::uint16_t>(size()); }

  /// Cell and range of every point; `cell` and `range_m` are as long as `points`. Range is 0 for `nowhere`.
  void locate(const PointsView& points, std::span<std::uint16_t> cell, std::span<float> range_m) const;

  /// Whether the eight cells around `cell` lie on its own face.
  [[nodiscard]] bool is_inner(std::uint16_t cell) const {
    const auto last = static_cast<unsigned>(side() - 2);
    return static_cast<unsigned>(row(cell) - 1) < last && static_cast<unsigned>(column(cell) - 1) < last;
  }

  /// Row by row the nine cells around and including `cell`. At the corners of the cube, where three faces meet, one may
  /// come twice: its second place holds `nowhere`.
  [[nodiscard]] std::array<std::uint16_t, 9> block(std::uint16_t cell) const;

 private:
  [[nodiscard]] std::uint16_t at(int face_of, int row_of, int column_of) const;

  int bits_;  ///< the side is this power of two
};

}  // namespace berm
