#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

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
  [[nodiscard]] float range_m(std::size_t i) const { return range_m_[i]; }
  [[nodiscard]] std::uint32_t sector(std::size_t i) const;
  /// How many sectors the returns fill; sectors at the rim of the view count for a part.
  [[nodiscard]] double sectors_seen() const { return sectors_seen_; }

  /// The nine cells around a point, and how many returns of other beams they hold.
  struct Block {
    std::array<std::uint32_t, 9> cells{};  ///< row by row; `nowhere` where there is none
    bool inner = false;                    ///< each row is three cells that follow one another
    std::uint32_t all = 0;
  };
  [[nodiscard]] Block block_of(std::size_t i) const;

  /// How many other near points of the block lie within +-`tolerance_m` of the range of point i; may stop at `limit`.
  [[nodiscard]] std::uint32_t count_like(std::size_t i, const Block& block, float tolerance_m,
                                         std::uint32_t limit) const;

  /// Whether two cells of the block on opposite sides of point i both have, within +-`tolerance_m`, more than
  /// `share` of their returns.
  [[nodiscard]] bool lies_on_line(std::size_t i, const Block& block, float tolerance_m, float share) const;

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
  [[nodiscard]] Band band_of(std::size_t i, float tolerance_m) const;
  /// Near points of the cells first .. last, which follow one another, within the band.
  [[nodiscard]] std::uint32_t count_in(std::uint32_t first, std::uint32_t last, Band band) const;

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
  std::vector<std::uint32_t> begin_;  ///< of the near points of a cell in `sorted_`
  std::vector<std::uint32_t> end_;
  std::vector<std::uint16_t> sorted_;  ///< ranges of near points in steps, by cell
  std::vector<std::uint32_t> index_;
  std::vector<float> range_m_;
  std::vector<std::uint32_t> cell_;
};

}  // namespace berm
