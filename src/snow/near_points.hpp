#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "band_count.hpp"
#include "berm/core/point_cloud.hpp"
#include "direction_cells.hpp"

namespace berm {

/// The near points of a scan, sorted by direction, for counting neighbours. Keeps its memory.
class NearPoints {
 public:
  /// Each face of the cube in four by four.
  static constexpr std::size_t kSectors = 96;

  NearPoints();

  /// Sorts the points nearer than `max_range_m`; farther ones are counted. Cells are taken as large as the sensor's
  /// density asks for.
  void build(const PointsView& points, float max_range_m);

  [[nodiscard]] std::size_t size() const { return size_; }
  /// In the scan, of near point i.
  [[nodiscard]] std::uint32_t index(std::size_t i) const { return index_[i]; }
  [[nodiscard]] std::span<const std::uint32_t> indices() const { return std::span(index_).first(size_); }
  [[nodiscard]] float range_m(std::size_t i) const { return range_m_[i]; }
  [[nodiscard]] std::uint32_t sector(std::size_t i) const {
    const std::uint32_t cell = cell_[i];
    const int shift = cells_.bits() - 2;
    return static_cast<std::uint32_t>(16 * cells_.face(cell) + 4 * (cells_.row(cell) >> shift) +
                                      (cells_.column(cell) >> shift));
  }
  /// How many sectors the returns fill; sectors at the rim of the view count for a part.
  [[nodiscard]] double sectors_seen() const { return sectors_seen_; }

  /// Of the returns of other beams in the nine cells around a point.
  struct Around {
    std::uint32_t all;
    std::uint32_t like;  ///< near, and within a tolerance of the range of the point
  };
  [[nodiscard]] Around count_around(std::size_t i, float tolerance_m) const {
    const std::uint32_t cell = cell_[i];
    const Band band = band_of(i, tolerance_m);
    if (!cells_.is_inner(cell)) {
      return count_around_edge(cell, band);
    }
    const auto side = static_cast<std::uint32_t>(cells_.side());
    BandCount like(band.low, band.width);
    std::uint32_t all = 0;
    const auto add_row = [&](std::uint32_t middle) {
      const Counts& first = before_[middle - 1U];
      const Counts& last = before_[middle + 2U];
      all += last.all - first.all;
      like.add(sorted_.data() + first.near, last.near - first.near);
    };
    add_row(cell - side);
    add_row(cell);
    add_row(cell + side);
    return {all - 1U, like.total() - 1U};
  }

  /// Whether cells around that of point i on opposite sides both have, within +-`tolerance_m`, more than `share` of
  /// their returns.
  [[nodiscard]] bool lies_on_line(std::size_t i, float tolerance_m, float share) const;

 private:
  struct Counts {
    std::uint32_t all = 0;   ///< returns
    std::uint32_t near = 0;  ///< near ones
  };
  /// Ranges from `low` to `low + width`, in steps.
  struct Band {
    std::uint16_t low;
    std::uint16_t width;
  };

  void use_cells(int bits);
  void gather(const PointsView& points, float max_range_m);
  void add_up_banks();
  void look_where_returns_are();
  void coarsen(int bits);
  void sort();
  [[nodiscard]] Band band_of(std::size_t i, float tolerance_m) const {
    const float low = std::max(0.0F, (range_m_[i] - tolerance_m) * steps_per_m_);
    const float high = std::min(65535.0F, (range_m_[i] + tolerance_m) * steps_per_m_);
    return {static_cast<std::uint16_t>(low), static_cast<std::uint16_t>(high - low)};
  }
  [[nodiscard]] std::uint32_t count_in(std::uint32_t cell, Band band) const;
  [[nodiscard]] Around count_around_edge(std::uint32_t cell, Band band) const;
  [[nodiscard]] std::array<std::uint32_t, 9> cells_around(std::uint32_t cell) const;

  DirectionCells cells_;
  std::size_t size_ = 0;
  double sectors_seen_ = 1.0;
  double returns_per_block_ = 0.0;
  float steps_per_m_ = 1.0F;
  std::array<bool, DirectionCells::kFaces> face_used_{};
  std::vector<std::uint32_t> cell_of_point_;
  std::vector<float> range_of_point_;
  std::vector<Counts> counts_;  ///< of the points of a cell
  /// Sums of `Counts` while gathering, two of every cell, for points of even and of odd number: neighbours in firing
  /// order often share a cell, and so need not wait for each other's memory.
  std::vector<std::uint64_t> banks_;
  /// Of all cells before one, over the faces that are used; has an entry behind the last cell of each of these, too.
  std::vector<Counts> before_;
  std::vector<std::uint32_t> next_;      ///< while sorting: place in `sorted_` for the next point of a cell
  std::vector<std::uint64_t> has_near_;  ///< of a cell: bit b is 1 if it holds a near point in the b-th 64th of ranges
  std::vector<std::uint16_t> sorted_;    ///< ranges of near points in steps, by cell
  std::vector<std::uint32_t> index_;
  std::vector<float> range_m_;
  std::vector<std::uint32_t> cell_;
};

}  // namespace berm
