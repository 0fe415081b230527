#include "near_points.hpp"

#include <algorithm>
#include <bit>

#include "count_between.hpp"

namespace berm {
namespace {

constexpr std::size_t kSide = DirectionCells::kFinestSide;
constexpr std::size_t kFaceCells = kSide * kSide;
/// Fewer returns in a block say nothing of how they lie.
constexpr double kLeastReturns = 20.0;
constexpr int kMostShift = 2;
/// Ranges are kept in 16 bits.
constexpr float kSteps = 65000.0F;

}  // namespace

NearPoints::NearPoints() : cells_(0) {
  counts_.resize(cells_.size());
  banks_.resize(2 * (cells_.size() + 1));
  begin_.resize(cells_.size());
  end_.resize(cells_.size());
}

void NearPoints::build(const PointsView& points, float max_range_m) {
  steps_per_m_ = kSteps / max_range_m;
  gather(points, max_range_m);
  look_where_returns_are();
  int shift = 0;
  for (double returns = returns_per_block_; shift < kMostShift && returns < kLeastReturns; returns *= 4.0) {
    ++shift;
  }
  if (shift > 0) {
    coarsen(shift);
  }
  sort();
}

void NearPoints::clear_counts() {
  for (std::size_t face = 0; face < DirectionCells::kFaces; ++face) {
    if (face_used_[face]) {
      std::fill_n(banks_.begin() + static_cast<std::ptrdiff_t>(2 * face * kFaceCells), 2 * kFaceCells, 0U);
      std::fill_n(counts_.begin() + static_cast<std::ptrdiff_t>(face * kFaceCells), kFaceCells, Counts{});
    }
  }
}

void NearPoints::gather(const PointsView& points, float max_range_m) {
  cells_ = DirectionCells(0);
  const std::size_t size = points.size();
  cell_of_point_.resize(size);
  range_of_point_.resize(size);
  cells_.locate(points, cell_of_point_, range_of_point_);

  clear_counts();
  index_.resize(size + 1);
  range_m_.resize(size + 1);
  cell_.resize(size + 1);
  std::size_t near = 0;
  std::uint32_t faces = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint16_t cell = cell_of_point_[i];
    const float range_m = range_of_point_[i];
    // Written in any case and kept if near: cheaper than a branch that nobody can foresee.
    index_[near] = static_cast<std::uint32_t>(i);
    range_m_[near] = range_m;
    cell_[near] = cell;
    const std::uint32_t is_near = (range_m > 0.0F) & (range_m < max_range_m) ? 1U : 0U;
    banks_[2U * cell + (i & 1U)] += 1U + (std::uint64_t{is_near} << 32U);
    faces |= 1U << cells_.face(cell);
    near += is_near;
  }
  size_ = near;
  for (std::size_t face = 0; face < DirectionCells::kFaces; ++face) {
    face_used_[face] = (faces >> face & 1U) != 0;
    for (std::size_t c = face * kFaceCells; face_used_[face] && c < (face + 1) * kFaceCells; ++c) {
      const std::uint64_t sum = banks_[2 * c] + banks_[2 * c + 1];
      counts_[c] = {static_cast<std::uint32_t>(sum), static_cast<std::uint32_t>(sum >> 32U)};
    }
  }
}

/// Counts sectors with returns, and how many returns a block holds on average over where the sensor looks: over cells
/// of four by four that hold any.
void NearPoints::look_where_returns_are() {
  constexpr std::size_t kCoarse = kSide / 4;
  std::size_t seen = 0;
  std::size_t returns = 0;
  sectors_seen_ = 0;
  for (std::size_t face = 0; face < DirectionCells::kFaces; ++face) {
    if (!face_used_[face]) {
      continue;
    }
    std::array<std::uint32_t, kCoarse * kCoarse> sums{};
    const Counts* counts = counts_.data() + face * kFaceCells;
    for (std::size_t row = 0; row < kSide; ++row, counts += kSide) {
      for (std::size_t k = 0; k < kCoarse; ++k) {
        sums[row / 4 * kCoarse + k] +=
            counts[4 * k].all + counts[4 * k + 1].all + counts[4 * k + 2].all + counts[4 * k + 3].all;
      }
    }
    std::uint32_t sectors = 0;
    for (std::size_t k = 0; k < sums.size(); ++k) {
      returns += sums[k];
      seen += sums[k] > 0 ? 1U : 0U;
      sectors |= (sums[k] > 0 ? 1U : 0U) << (k / kCoarse / 4 * 4 + k % kCoarse / 4);
    }
    sectors_seen_ += static_cast<std::size_t>(std::popcount(sectors));
  }
  returns_per_block_ = seen > 0 ? 9.0 / 16.0 * static_cast<double>(returns) / static_cast<double>(seen) : 0.0;
}

void NearPoints::coarsen(int shift) {
  cells_ = DirectionCells(shift);
  const auto side = static_cast<std::size_t>(cells_.side());
  // Rows are counted over all faces: a face has a whole number of coarse ones. A coarse cell is never numbered higher
  // than the first of its fine ones, so that its count may take their place.
  for (std::size_t cell = 0; cell < DirectionCells::kFaces * kFaceCells; ++cell) {
    const std::size_t coarse = (cell / kSide >> shift) * side + (cell % kSide >> shift);
    const Counts fine = counts_[cell];
    counts_[cell] = {};
    counts_[coarse].all += fine.all;
    counts_[coarse].near += fine.near;
  }
  for (std::size_t i = 0; i < size_; ++i) {
    const std::size_t cell = cell_[i];
    cell_[i] = static_cast<std::uint16_t>((cell / kSide >> shift) * side + (cell % kSide >> shift));
  }
}

void NearPoints::sort() {
  std::uint32_t sum = 0;
  const std::size_t face_cells = cells_.cells_of_face();
  for (std::size_t face = 0; face < DirectionCells::kFaces; ++face) {
    const std::size_t end = (face + 1) * face_cells;
    for (std::size_t c = face * face_cells; face_used_[face] && c < end; ++c) {
      begin_[c] = sum;
      end_[c] = sum;
      sum += counts_[c].near;
    }
  }
  sorted_.resize(size_ + kCountLanes);
  for (std::size_t i = 0; i < size_; ++i) {
    sorted_[end_[cell_[i]]++] = static_cast<std::uint16_t>(range_m_[i] * steps_per_m_);
  }
}

std::uint16_t NearPoints::sector(std::size_t i) const {
  const std::uint16_t cell = cell_[i];
  const int row = cells_.row(cell) * 4 / cells_.side();
  const int column = cells_.column(cell) * 4 / cells_.side();
  return static_cast<std::uint16_t>(16 * cells_.face(cell) + 4 * row + column);
}

NearPoints::Block NearPoints::block_of(std::size_t i) const {
  const std::uint16_t cell = cell_[i];
  Block block;
  block.inner = cells_.is_inner(cell);
  if (block.inner) {
    const auto side = static_cast<std::uint16_t>(cells_.side());
    for (std::size_t k = 0; k < 9; ++k) {
      block.cells[k] = static_cast<std::uint16_t>(cell + (k / 3) * side - side + k % 3 - 1U);
      block.all += counts_[block.cells[k]].all;
    }
  } else {
    block.cells = cells_.block(cell);
    for (std::uint16_t& c : block.cells) {
      if (c != cells_.nowhere()) {
        block.all += counts_[c].all;
        c = counts_[c].all > 0 ? c : cells_.nowhere();
      }
    }
  }
  --block.all;
  return block;
}

NearPoints::Band NearPoints::band_of(std::size_t i, float tolerance_m) const {
  const float low = std::max(0.0F, (range_m_[i] - tolerance_m) * steps_per_m_);
  const float high = std::min(65535.0F, (range_m_[i] + tolerance_m) * steps_per_m_);
  return {static_cast<std::uint16_t>(low), static_cast<std::uint16_t>(high - low)};
}

std::uint32_t NearPoints::count_in(std::uint16_t first, std::uint16_t last, Band band) const {
  return count_between(sorted_.data() + begin_[first], end_[last] - begin_[first], band.low, band.width);
}

std::uint32_t NearPoints::count_like(std::size_t i, const Block& block, float tolerance_m, std::uint32_t limit) const {
  const Band band = band_of(i, tolerance_m);
  std::uint32_t found = 0;
  if (block.inner) {
    for (const std::size_t k : {3U, 0U, 6U}) {  // the point's own row first
      if (found <= limit) {
        found += count_in(block.cells[k], block.cells[k + 2], band);
      }
    }
  } else {
    for (const std::uint16_t c : block.cells) {
      found += c != cells_.nowhere() ? count_in(c, c, band) : 0U;
    }
  }
  return found - 1U;  // the point itself
}

bool NearPoints::lies_on_line(std::size_t i, const Block& block, float tolerance_m, float share) const {
  const Band band = band_of(i, tolerance_m);
  const auto holds = [&](std::size_t k) {
    const std::uint16_t c = block.cells[k];
    if (c == cells_.nowhere()) {
      return false;
    }
    const std::uint32_t found = count_in(c, c, band);
    return found > 0 && static_cast<float>(found) > share * static_cast<float>(counts_[c].all);
  };
  return (holds(1) && holds(7)) || (holds(3) && holds(5)) || (holds(0) && holds(8)) || (holds(2) && holds(6));
}

}  // namespace berm
