#include "near_points.hpp"

#include <algorithm>
#include <array>

namespace berm {
namespace {

/// With fewer returns in a block, cells are taken larger: they would say nothing of how they lie.
constexpr double kLeastReturns = 20.0;
constexpr int kLeastBits = 4;
/// With more they are taken smaller, to save time.
constexpr double kMostReturns = 400.0;
constexpr int kMostBits = 8;

int choose_bits(double returns_per_block) {
  int bits = DirectionCells::kUsualBits;
  for (; bits > kLeastBits && returns_per_block < kLeastReturns; returns_per_block *= 4.0) {
    --bits;
  }
  for (; bits < kMostBits && returns_per_block > kMostReturns; returns_per_block /= 4.0) {
    ++bits;
  }
  return bits;
}

/// Fewer returns in a cell leave room for a thin thing to pass unseen.
constexpr std::uint32_t kFewReturns = 10;

/// Ranges are kept in 16 bits.
constexpr float kSteps = 65000.0F;

/// Which 64th of all ranges one is in.
constexpr std::uint32_t part_of(std::uint32_t steps) {
  return steps >> 10U;
}

/// A bit for each of these parts from one range to another.
constexpr std::uint64_t parts_between(std::uint32_t low, std::uint32_t high) {
  return (std::uint64_t{2} << part_of(high)) - (std::uint64_t{1} << part_of(low));
}

/// Of equal parts that would be as even as these are: 1 if one has it all.
double effective_number(const std::array<double, NearPoints::kSectors>& parts) {
  double sum = 0.0;
  double squares = 0.0;
  for (const double part : parts) {
    sum += part;
    squares += part * part;
  }
  return squares > 0.0 ? sum * sum / squares : 1.0;
}

}  // namespace

NearPoints::NearPoints() : cells_(DirectionCells::kUsualBits) {}

void NearPoints::build(const PointsView& points, float max_range_m) {
  steps_per_m_ = kSteps / max_range_m;
  use_cells(DirectionCells::kUsualBits);
  gather(points, max_range_m);
  look_where_returns_are();
  const int bits = choose_bits(returns_per_block_);
  if (bits > cells_.bits()) {
    use_cells(bits);
    gather(points, max_range_m);
  } else if (bits < cells_.bits()) {
    coarsen(bits);
  }
  sort();
}

/// Forgets what was counted. Only faces that were used need to be cleared.
void NearPoints::use_cells(int bits) {
  const std::size_t face_cells = cells_.cells_of_face();
  for (std::size_t face = 0; face < DirectionCells::kFaces; ++face) {
    if (face_used_[face]) {
      std::fill_n(counts_.begin() + static_cast<std::ptrdiff_t>(face * face_cells), face_cells, Counts{});
    }
  }
  face_used_.fill(false);
  cells_ = DirectionCells(bits);
  if (counts_.size() < cells_.size()) {
    counts_.resize(cells_.size());
    before_.resize(cells_.size() + 1);
    next_.resize(cells_.size());
    has_near_.resize(cells_.size() + 1);
    banks_.resize(2 * (cells_.size() + 1));
  }
}

void NearPoints::gather(const PointsView& points, float max_range_m) {
  const std::size_t size = points.size();
  cell_of_point_.resize(size);
  range_of_point_.resize(size);
  cells_.locate(points, cell_of_point_, range_of_point_);

  index_.resize(size + 1);
  range_m_.resize(size + 1);
  cell_.resize(size + 1);
  std::size_t near = 0;
  std::uint32_t faces = 0;
  const DirectionCells cells = cells_;
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint32_t cell = cell_of_point_[i];
    const float range_m = range_of_point_[i];
    // Written in any case and kept if near: cheaper than a branch that nobody can foresee.
    index_[near] = static_cast<std::uint32_t>(i);
    range_m_[near] = range_m;
    cell_[near] = cell;
    const std::uint32_t is_near = ((range_m > 0.0F) & (range_m < max_range_m)) ? 1U : 0U;
    banks_[2U * std::size_t{cell} + (i & 1U)] += 1U + (std::uint64_t{is_near} << 32U);
    faces |= 1U << cells.face(cell);
    near += is_near;
  }
  size_ = near;
  for (std::size_t face = 0; face < DirectionCells::kFaces; ++face) {
    face_used_[face] = (faces >> face & 1U) != 0;
  }
  add_up_banks();
}

/// Leaves the banks empty: another size of cells may use them next.
void NearPoints::add_up_banks() {
  banks_[2 * std::size_t{cells_.nowhere()}] = 0;
  banks_[2 * std::size_t{cells_.nowhere()} + 1] = 0;
  const std::size_t face_cells = cells_.cells_of_face();
  for (std::size_t face = 0; face < DirectionCells::kFaces; ++face) {
    for (std::size_t c = face * face_cells; face_used_[face] && c < (face + 1) * face_cells; ++c) {
      const std::uint64_t sum = banks_[2 * c] + banks_[2 * c + 1];
      counts_[c] = {static_cast<std::uint32_t>(sum), static_cast<std::uint32_t>(sum >> 32U)};
      banks_[2 * c] = 0;
      banks_[2 * c + 1] = 0;
    }
  }
}

/// How many sectors the returns fill, and how many returns a block holds on average over where the sensor looks: over
/// cells of four by four that hold any.
void NearPoints::look_where_returns_are() {
  constexpr std::size_t kSide = std::size_t{1} << DirectionCells::kUsualBits;
  constexpr std::size_t kCoarse = kSide / 4;
  std::size_t seen = 0;
  std::size_t returns = 0;
  std::array<double, kSectors> of_sector{};
  for (std::size_t face = 0; face < DirectionCells::kFaces; ++face) {
    if (!face_used_[face]) {
      continue;
    }
    std::array<std::uint32_t, kCoarse * kCoarse> sums{};
    const Counts* counts = counts_.data() + face * kSide * kSide;
    for (std::size_t row = 0; row < kSide; ++row, counts += kSide) {
      for (std::size_t k = 0; k < kCoarse; ++k) {
        sums[row / 4 * kCoarse + k] +=
            counts[4 * k].all + counts[4 * k + 1].all + counts[4 * k + 2].all + counts[4 * k + 3].all;
      }
    }
    for (std::size_t k = 0; k < sums.size(); ++k) {
      returns += sums[k];
      seen += sums[k] > 0 ? 1U : 0U;
      of_sector[16 * face + k / kCoarse / 4 * 4 + k % kCoarse / 4] += sums[k];
    }
  }
  sectors_seen_ = effective_number(of_sector);
  returns_per_block_ = seen > 0 ? 9.0 / 16.0 * static_cast<double>(returns) / static_cast<double>(seen) : 0.0;
}

void NearPoints::coarsen(int bits) {
  const DirectionCells fine = cells_;
  const int shift = fine.bits() - bits;
  cells_ = DirectionCells(bits);
  // Rows are counted over all faces: a face has a whole number of coarse ones. A coarse cell is never numbered higher
  // than the first of its fine ones, so that its count may take their place.
  const auto coarse = [fine, shift, bits](std::size_t cell) {
    const std::size_t row = cell >> fine.bits() >> shift;
    const std::size_t column = (cell & static_cast<std::size_t>(fine.side() - 1)) >> shift;
    return (row << bits) + column;
  };
  for (std::size_t cell = 0; cell < fine.size(); ++cell) {
    const Counts moved = counts_[cell];
    counts_[cell] = {};
    counts_[coarse(cell)].all += moved.all;
    counts_[coarse(cell)].near += moved.near;
  }
  for (std::size_t i = 0; i < size_; ++i) {
    cell_[i] = static_cast<std::uint32_t>(coarse(cell_[i]));
  }
}

void NearPoints::sort() {
  Counts sum;
  const std::size_t face_cells = cells_.cells_of_face();
  for (std::size_t face = 0; face < DirectionCells::kFaces; ++face) {
    if (!face_used_[face]) {
      continue;
    }
    const std::size_t end = (face + 1) * face_cells;
    for (std::size_t c = face * face_cells; c < end; ++c) {
      before_[c] = sum;
      next_[c] = sum.near;
      has_near_[c] = 0;
      sum.all += counts_[c].all;
      sum.near += counts_[c].near;
    }
    before_[end] = sum;
  }
  has_near_[cells_.nowhere()] = 0;
  sorted_.resize(size_ + BandCount::kMargin);
  const std::size_t size = size_;
  const float steps_per_m = steps_per_m_;
  for (std::size_t i = 0; i < size; ++i) {
    const std::uint32_t cell = cell_[i];
    const auto steps = static_cast<std::uint16_t>(range_m_[i] * steps_per_m);
    sorted_[next_[cell]++] = steps;
    has_near_[cell] |= std::uint64_t{1} << part_of(steps);
  }
}

/// Row by row; `nowhere` where there is none, or none that holds a return.
std::array<std::uint32_t, 9> NearPoints::cells_around(std::uint32_t cell) const {
  std::array<std::uint32_t, 9> cells = cells_.block(cell);
  for (std::uint32_t& c : cells) {
    if (c != cells_.nowhere() && counts_[c].all == 0) {
      c = cells_.nowhere();
    }
  }
  return cells;
}

NearPoints::Around NearPoints::count_around_edge(std::uint32_t cell, Band band) const {
  Around around{};
  for (const std::uint32_t c : cells_around(cell)) {
    if (c != cells_.nowhere()) {
      around.all += counts_[c].all;
      around.like += count_in(c, band);
    }
  }
  return {around.all - 1U, around.like - 1U};
}

std::uint32_t NearPoints::count_in(std::uint32_t cell, Band band) const {
  BandCount found(band.low, band.width);
  found.add(sorted_.data() + before_[cell].near, counts_[cell].near);
  return found.total();
}

bool NearPoints::lies_on_line(std::size_t i, float tolerance_m, float share) const {
  const std::uint32_t own = cell_[i];
  const auto side = static_cast<std::uint32_t>(cells_.side());
  const bool inner = cells_.is_inner(own);
  const std::array<std::uint32_t, 9> around = inner ? std::array<std::uint32_t, 9>{} : cells_around(own);
  const Band band = band_of(i, tolerance_m);
  const std::uint64_t parts = parts_between(band.low, std::uint32_t{band.low} + band.width);

  // A cell that few beams met, between two rings or two petals, says nothing: then the one behind it is asked.
  struct Side {
    std::uint32_t cell;
    std::uint32_t behind;
  };
  const bool deep = inner && cells_.is_inner(own - side - 1U) && cells_.is_inner(own + side + 1U);
  const auto side_at = [&](std::uint32_t cell) {
    return Side{cell, deep || (inner && cells_.is_inner(cell)) ? cell + cell - own : cells_.nowhere()};
  };
  const auto may_hold = [&](const Side& s) { return ((has_near_[s.cell] | has_near_[s.behind]) & parts) != 0; };
  const auto cell_holds = [&](std::uint32_t c) {
    if ((has_near_[c] & parts) == 0) {
      return false;
    }
    const std::uint32_t found = count_in(c, band);
    return found > 0 && static_cast<float>(found) > share * static_cast<float>(counts_[c].all);
  };
  const auto holds = [&](const Side& s) {
    return cell_holds(s.cell) ||
           (s.cell != cells_.nowhere() && counts_[s.cell].all < kFewReturns && cell_holds(s.behind));
  };
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t step = k == 3 ? 1U : side + 1U - k;
    const Side before = side_at(inner ? own - step : around[k]);
    const Side after = side_at(inner ? own + step : around[8 - k]);
    if (may_hold(before) && may_hold(after) && holds(before) && holds(after)) {
      return true;
    }
  }
  return false;
}

}  // namespace berm
