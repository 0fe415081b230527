#include "near_points.hpp"

#include <algorithm>
#include <bit>

#include "multiversion.hpp"

namespace berm {
namespace {

constexpr std::size_t kSide = DirectionCells::kFinestSide;
constexpr std::size_t kFaceCells = kSide * kSide;
/// Fewer returns in a block say nothing of how they lie.
constexpr double kLeastReturns = 20.0;
constexpr int kMostShift = 2;
/// Values are compared so many at a time; the memory behind the last one must exist.
constexpr std::size_t kLanes = 8;

BERM_MULTIVERSION
std::uint32_t count_between(const float* values, std::uint32_t count, float low, float high) {
  std::uint32_t found = 0;
  for (std::uint32_t k = 0; k < count; k += kLanes) {
    for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
      const float value = values[k + lane];
      found += (k + lane < count) & (value > low) & (value < high) ? 1U : 0U;
    }
  }
  return found;
}

}  // namespace

NearPoints::NearPoints() : cells_(DirectionCells::kFinestSide) {
  all_.resize(cells_.size() + 1);
  near_.resize(cells_.size() + 1);
  begin_.resize(cells_.size() + 1);
}

void NearPoints::build(const PointsView& points, float max_range_m) {
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

void NearPoints::gather(const PointsView& points, float max_range_m) {
  cells_ = DirectionCells(DirectionCells::kFinestSide);
  const std::size_t size = points.size();
  cell_of_point_.resize(size);
  range_of_point_.resize(size);
  cells_.locate(points, cell_of_point_, range_of_point_);

  std::fill(all_.begin(), all_.end(), 0U);
  std::fill(near_.begin(), near_.end(), 0U);
  index_.resize(size + 1);
  range_m_.resize(size + 1);
  cell_.resize(size + 1);
  std::size_t near = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint16_t cell = cell_of_point_[i];
    const float range_m = range_of_point_[i];
    ++all_[cell];
    // Written in any case and kept if near: cheaper than a branch that nobody can foresee.
    index_[near] = static_cast<std::uint32_t>(i);
    range_m_[near] = range_m;
    cell_[near] = cell;
    const std::uint32_t is_near = (range_m > 0.0F) & (range_m < max_range_m) ? 1U : 0U;
    near_[cell] += is_near;
    near += is_near;
  }
  size_ = near;
}

/// Counts sectors with returns, and how many returns a block holds on average over where the sensor looks: over cells
/// of four by four that hold any.
void NearPoints::look_where_returns_are() {
  constexpr std::size_t kCoarse = kSide / 4;
  std::size_t seen = 0;
  std::size_t returns = 0;
  sectors_seen_ = 0;
  for (std::size_t face = 0; face < DirectionCells::kFaces; ++face) {
    std::array<std::uint32_t, kCoarse * kCoarse> sums{};
    const std::uint32_t* counts = all_.data() + face * kFaceCells;
    for (std::size_t cell = 0; cell < kFaceCells; ++cell) {
      sums[cell / kSide / 4 * kCoarse + cell % kSide / 4] += counts[cell];
    }
    std::uint32_t sectors = 0;
    for (std::size_t k = 0; k < sums.size(); ++k) {
      returns += sums[k];
      seen += sums[k] > 0 ? 1U : 0U;
      sectors |= (sums[k] > 0 ? 1U : 0U) << (k / kCoarse / 4 * 4 + k % kCoarse / 4);
    }
    face_used_[face] = sectors != 0;
    sectors_seen_ += static_cast<std::size_t>(std::popcount(sectors));
  }
  returns_per_block_ = seen > 0 ? 9.0 / 16.0 * static_cast<double>(returns) / static_cast<double>(seen) : 0.0;
}

void NearPoints::coarsen(int shift) {
  const DirectionCells fine = cells_;
  cells_ = DirectionCells(DirectionCells::kFinestSide >> shift);
  const auto side = static_cast<std::size_t>(cells_.side());
  // Rows are counted over all faces: a face has a whole number of coarse ones.
  const auto coarse = [shift, side](std::size_t cell) {
    return (cell / kSide >> shift) * side + (cell % kSide >> shift);
  };
  fine_ = all_;
  std::fill(all_.begin(), all_.end(), 0U);
  std::fill(near_.begin(), near_.end(), 0U);
  for (std::size_t cell = 0; cell < fine.size(); ++cell) {
    all_[coarse(cell)] += fine_[cell];
  }
  for (std::size_t i = 0; i < size_; ++i) {
    cell_[i] = static_cast<std::uint16_t>(coarse(cell_[i]));
    ++near_[cell_[i]];
  }
}

void NearPoints::sort() {
  std::uint32_t sum = 0;
  const std::size_t face_cells = cells_.cells_of_face();
  for (std::size_t face = 0; face < DirectionCells::kFaces; ++face) {
    const std::size_t end = (face + 1) * face_cells;
    for (std::size_t c = face * face_cells; face_used_[face] && c < end; ++c) {
      begin_[c] = sum;
      sum += near_[c];
      near_[c] = begin_[c];
    }
  }
  sorted_.resize(size_ + kLanes);
  for (std::size_t i = 0; i < size_; ++i) {
    sorted_[near_[cell_[i]]++] = range_m_[i];
  }
}

std::uint16_t NearPoints::sector(std::size_t i) const {
  const auto side = static_cast<std::size_t>(cells_.side());
  const std::size_t row = cell_[i] / side * 4 / side;  // over all faces, four each
  const std::size_t column = cell_[i] % side * 4 / side;
  return static_cast<std::uint16_t>(row * 4 + column);
}

NearPoints::Block NearPoints::block_of(std::size_t i) const {
  const std::uint16_t cell = cell_[i];
  Block block;
  block.inner = cells_.is_inner(cell);
  if (block.inner) {
    const auto side = static_cast<std::uint16_t>(cells_.side());
    for (std::size_t k = 0; k < 9; ++k) {
      block.cells[k] = static_cast<std::uint16_t>(cell + (k / 3) * side - side + k % 3 - 1U);
      block.all += all_[block.cells[k]];
    }
  } else {
    block.cells = cells_.block(cell);
    for (std::uint16_t& c : block.cells) {
      if (c != cells_.nowhere()) {
        block.all += all_[c];
        c = all_[c] > 0 ? c : cells_.nowhere();
      }
    }
  }
  --block.all;
  return block;
}

/// After sorting, `near_` of a cell is where its points end.
std::uint32_t NearPoints::count_like(std::size_t i, const Block& block, float tolerance_m, std::uint32_t limit) const {
  const float low_m = range_m_[i] - tolerance_m;
  const float high_m = range_m_[i] + tolerance_m;
  std::uint32_t found = 0;
  const auto add = [&](std::uint16_t first, std::uint16_t last) {
    found += count_between(sorted_.data() + begin_[first], near_[last] - begin_[first], low_m, high_m);
  };
  if (block.inner) {
    for (const std::size_t k : {3U, 0U, 6U}) {  // the point's own row first
      if (found <= limit) {
        add(block.cells[k], block.cells[k + 2]);
      }
    }
  } else {
    for (const std::uint16_t c : block.cells) {
      if (c != cells_.nowhere()) {
        add(c, c);
      }
    }
  }
  return found - std::min(found, 1U);  // without the point itself
}

bool NearPoints::lies_on_line(std::size_t i, const Block& block, float tolerance_m, float share) const {
  const float low_m = range_m_[i] - tolerance_m;
  const float high_m = range_m_[i] + tolerance_m;
  const auto holds = [&](std::size_t k) {
    const std::uint16_t c = block.cells[k];
    if (c == cells_.nowhere()) {
      return false;
    }
    const std::uint32_t found = count_between(sorted_.data() + begin_[c], near_[c] - begin_[c], low_m, high_m);
    return found > 0 && static_cast<float>(found) > share * static_cast<float>(all_[c]);
  };
  return (holds(1) && holds(7)) || (holds(3) && holds(5)) || (holds(0) && holds(8)) || (holds(2) && holds(6));
}

}  // namespace berm
