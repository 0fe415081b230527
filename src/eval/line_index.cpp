#include "line_index.hpp"

#include <algorithm>
#include <cmath>

namespace berm {
namespace {

double distance_to_piece_m(const Eigen::Vector2d& place_m, const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m) {
  const Eigen::Vector2d along_m = to_m - from_m;
  const double length2 = along_m.squaredNorm();
  const double share = length2 > 0.0 ? std::clamp((place_m - from_m).dot(along_m) / length2, 0.0, 1.0) : 0.0;
  return (place_m - from_m - share * along_m).norm();
}

}  // namespace

LineIndex::Cell LineIndex::cell_of(const Eigen::Vector2d& place_m) const {
  // Twice the radius: a piece, which is no longer than that, reaches no farther than the radius from its middle.
  const double side_m = 2.0 * radius_m_;
  return {static_cast<std::int64_t>(std::floor(place_m.x() / side_m)),
          static_cast<std::int64_t>(std::floor(place_m.y() / side_m))};
}

void LineIndex::add(const Eigen::Vector2d& from_m, const Eigen::Vector2d& to_m, std::uint32_t line) {
  const auto parts =
      std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil((to_m - from_m).norm() / (2.0 * radius_m_))));
  for (std::int64_t i = 0; i < parts; ++i) {
    const auto at = [&](std::int64_t part) -> Eigen::Vector2d {
      return from_m + static_cast<double>(part) / static_cast<double>(parts) * (to_m - from_m);
    };
    pieces_.push_back({cell_of(0.5 * (at(i) + at(i + 1))), line, at(i), at(i + 1)});
  }
}

void LineIndex::finish() {
  std::stable_sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) { return a.cell < b.cell; });
}

std::optional<LineIndex::Nearest> LineIndex::nearest(const Eigen::Vector2d& place_m) const {
  std::optional<Nearest> best;
  const Cell middle = cell_of(place_m);
  for (std::int64_t dx = -1; dx <= 1; ++dx) {
    const Cell first{middle.x + dx, middle.y - 1};
    const Cell last{middle.x + dx, middle.y + 1};
    auto piece = std::lower_bound(pieces_.begin(), pieces_.end(), first,
                                  [](const Piece& a, const Cell& cell) { return a.cell < cell; });
    for (; piece != pieces_.end() && piece->cell <= last; ++piece) {
      const double distance_m = distance_to_piece_m(place_m, piece->from_m, piece->to_m);
      if (distance_m > radius_m_) {
        continue;
      }
      if (!best || distance_m < best->distance_m || (distance_m == best->distance_m && piece->line < best->line)) {
        best = {distance_m, piece->line};
      }
    }
  }
  return best;
}

}  // namespace berm
