#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "berm/core/point_cloud.hpp"

namespace berm {

/// Cuts all directions from the sensor into cells of about equal size: a cube around the sensor, each face cut into
/// 2^bits x 2^bits. No direction is special, as the zenith is for azimuth and elevation, and a point costs one division
/// and no trigonometry. Cells are numbered face by face and row by row.
class DirectionCells {
 public:
  static constexpr int kFaces = 6;
  /// 2^6 cells along the side of a face are 1.4 deg wide.
  static constexpr int kUsualBits = 6;

  explicit DirectionCells(int bits) : bits_(bits) {}

  [[nodiscard]] std::size_t size() const { return kFaces * cells_of_face(); }
  [[nodiscard]] std::size_t cells_of_face() const { return std::size_t{1} << (2 * bits_); }
  [[nodiscard]] int bits() const { return bits_; }
  /// Cells along the side of a face.
  [[nodiscard]] int side() const { return 1 << bits_; }
  /// Place of a cell along the second and along the first axis of its face.
  [[nodiscard]] int row(std::uint32_t cell) const { return static_cast<int>(cell >> bits_) & (side() - 1); }
  [[nodiscard]] int column(std::uint32_t cell) const { return static_cast<int>(cell) & (side() - 1); }
  [[nodiscard]] int face(std::uint32_t cell) const { return static_cast<int>(cell >> (2 * bits_)); }
  /// The cell of points that are not usable.
  [[nodiscard]] std::uint32_t nowhere() const { return static_cast<std::uint32_t>(size()); }

  /// Cell and range of every point; `cell` and `range_m` are as long as `points`. Range is 0 for `nowhere`.
  void locate(const PointsView& points, std::span<std::uint32_t> cell, std::span<float> range_m) const;

  /// Whether the eight cells around `cell` lie on its own face.
  [[nodiscard]] bool is_inner(std::uint32_t cell) const {
    const auto last = static_cast<unsigned>(side() - 2);
    return static_cast<unsigned>(row(cell) - 1) < last && static_cast<unsigned>(column(cell) - 1) < last;
  }

  /// Row by row the nine cells around and including `cell`. At the corners of the cube, where three faces meet, one may
  /// come twice: its second place holds `nowhere`.
  [[nodiscard]] std::array<std::uint32_t, 9> block(std::uint32_t cell) const;

 private:
  [[nodiscard]] std::uint32_t at(int face_of, int row_of, int column_of) const;

  int bits_;
};

}  // namespace berm
