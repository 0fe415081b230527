#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace berm {

/// A cell of a `PolarGrid`.
struct PolarCell {
  int sector = 0;  ///< by azimuth, counted from straight behind (-x) over the right (-y)
  int bin = 0;     ///< by horizontal distance, from the nearest

  friend constexpr bool operator==(const PolarCell&, const PolarCell&) = default;
};

/// Divides the plane around the sensor by azimuth and distance (G section 5.2). A cell holds its lower edges and not
/// its upper ones; azimuth +pi and -pi are one direction and lie in sector 0.
class PolarGrid {
 public:
  /// Most sectors, and most bins.
  static constexpr int kMaxCount = 1 << 16;

  /// `bins` rings of equal width from `min_range_m` to `max_range_m`. Throws Error(invalid_argument) unless the counts
  /// are 1..kMaxCount and 0 <= min < max, finite.
  PolarGrid(int sectors, int bins, double min_range_m, double max_range_m);
  /// Rings between neighbouring `edges_m`. Throws Error(invalid_argument) unless there are 2..kMaxCount + 1 of them,
  /// finite, not negative and strictly increasing.
  PolarGrid(int sectors, std::vector<double> edges_m);

  [[nodiscard]] int sectors() const { return sectors_; }
  [[nodiscard]] int bins() const { return static_cast<int>(edges_m_.size()) - 1; }
  /// Number of cells.
  [[nodiscard]] std::size_t size() const {
    return static_cast<std::size_t>(sectors_) * static_cast<std::size_t>(bins());
  }
  /// Inner edge of each bin, and behind them the outer edge of the last.
  [[nodiscard]] const std::vector<double>& edges_m() const { return edges_m_; }

  /// Sector of a direction; `azimuth_rad` in [-pi, pi] as std::atan2 gives it. None for NaN and beyond.
  [[nodiscard]] std::optional<int> sector_of(double azimuth_rad) const;
  /// Bin of a horizontal distance; none below the first edge, from the last one on, and for NaN.
  [[nodiscard]] std::optional<int> bin_of(double range_m) const;
  /// Cell of a place in the frame of the sensor; none outside of the rings and for NaN.
  [[nodiscard]] std::optional<PolarCell> cell_of(double x_m, double y_m) const;

  /// Place of a cell in an array of `size()` values: the bins of a sector lie side by side. `cell` must be of this
  /// grid.
  [[nodiscard]] std::size_t offset(PolarCell cell) const {
    return static_cast<std::size_t>(cell.sector) * static_cast<std::size_t>(bins()) +
           static_cast<std::size_t>(cell.bin);
  }

  /// Azimuth at the middle of a sector.
  [[nodiscard]] double center_azimuth_rad(int sector) const;
  /// Distance at the middle of a bin, which must be of this grid.
  [[nodiscard]] double center_range_m(int bin) const;

 private:
  int sectors_;
  std::vector<double> edges_m_;
  double uniform_width_m_ = 0.0;  ///< 0: the edges are the user's own
};

}  // namespace berm
