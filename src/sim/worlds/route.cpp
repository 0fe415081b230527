#include "berm/sim/route.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <utility>

#include "berm/core/error.hpp"

namespace berm::sim {
namespace {

constexpr std::size_t kSegmentsPerPiece = 8;
constexpr double kCell_m = 4.0;
constexpr double kCoarse_m = 40.0;
/// Places farther from the line than this are searched without the grid.
constexpr double kGridMargin_m = 180.0;
constexpr int kNewtonSteps = 4;
/// A chord is nowhere farther from its arc than this, as long as bends are wider than a few metres.
constexpr double kChordError_m = 0.02;

/// Place and derivatives of the cubic between two points with given tangents, by the share u of the segment.
struct Cubic {
  Eigen::Vector2d place;
  Eigen::Vector2d first;   ///< d/ds
  Eigen::Vector2d second;  ///< d2/ds2
};

Cubic cubic_at(const RoutePoint& a, const RoutePoint& b, const Eigen::Vector2d& ta, const Eigen::Vector2d& tb,
               double u) {
  const double step = b.s_m - a.s_m;
  const Eigen::Vector2d pa(a.x_m, a.y_m);
  const Eigen::Vector2d chord = Eigen::Vector2d(b.x_m, b.y_m) - pa;
  // p(u) = pa + u*step*ta + u^2*c2 + u^3*c3
  const Eigen::Vector2d c2 = 3.0 * chord - step * (2.0 * ta + tb);
  const Eigen::Vector2d c3 = step * (ta + tb) - 2.0 * chord;
  return {pa + u * (step * ta + u * (c2 + u * c3)), ta + u * (2.0 * c2 + 3.0 * u * c3) / step,
          (2.0 * c2 + 6.0 * u * c3) / (step * step)};
}

void check_points(const std::vector<RoutePoint>& points) {
  if (points.size() < 2) {
    throw Error(ErrorCode::invalid_argument,
                "route: expected at least two points, not " + std::to_string(points.size()));
  }
  for (std::size_t i = 1; i < points.size(); ++i) {
    if (!(points[i].s_m > points[i - 1].s_m)) {
      throw Error(ErrorCode::invalid_argument,
                  "route: s_m of point " + std::to_string(i) + " is not greater than that before");
    }
  }
}

/// Slopes of z at the points from the differences to both neighbours.
std::vector<double> slopes_of(const std::vector<RoutePoint>& points) {
  std::vector<double> slopes(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const RoutePoint& a = points[i == 0 ? 0 : i - 1];
    const RoutePoint& b = points[std::min(i + 1, points.size() - 1)];
    slopes[i] = (b.z_m - a.z_m) / (b.s_m - a.s_m);
  }
  return slopes;
}

}  // namespace

Route::Route(std::vector<RoutePoint> points) : points_(std::move(points)) {
  check_points(points_);
  tangents_.reserve(points_.size());
  for (const RoutePoint& p : points_) {
    tangents_.emplace_back(std::cos(p.heading_rad), std::sin(p.heading_rad));
  }
  gradients_ = slopes_of(points_);
  make_grid();
}

double Route::length_m() const {
  return points_.empty() ? 0.0 : points_.back().s_m - points_.front().s_m;
}

std::size_t Route::segment_at(double s_m) const {
  // Points are mostly evenly spaced: start where even spacing would have it.
  const double share = std::clamp((s_m - points_.front().s_m) / length_m(), 0.0, 1.0);
  std::size_t i =
      std::min(static_cast<std::size_t>(share * static_cast<double>(points_.size() - 1)), points_.size() - 2);
  while (i > 0 && s_m < points_[i].s_m) {
    --i;
  }
  while (i + 2 < points_.size() && s_m >= points_[i + 1].s_m) {
    ++i;
  }
  return i;
}

RoutePoint Route::at(double s_m) const {
  const double s = std::clamp(s_m, points_.front().s_m, points_.back().s_m);
  const std::size_t i = segment_at(s);
  const RoutePoint& a = points_[i];
  const RoutePoint& b = points_[i + 1];
  const double step = b.s_m - a.s_m;
  const double u = (s - a.s_m) / step;
  const Cubic cubic = cubic_at(a, b, tangents_[i], tangents_[i + 1], u);
  const double rise = b.z_m - a.z_m;
  const double c2 = 3.0 * rise - step * (2.0 * gradients_[i] + gradients_[i + 1]);
  const double c3 = step * (gradients_[i] + gradients_[i + 1]) - 2.0 * rise;
  return {.s_m = s,
          .x_m = cubic.place.x(),
          .y_m = cubic.place.y(),
          .z_m = a.z_m + u * (step * gradients_[i] + u * (c2 + u * c3)),
          .heading_rad = a.heading_rad + u * (b.heading_rad - a.heading_rad),
          .left_m = a.left_m + u * (b.left_m - a.left_m),
          .right_m = a.right_m + u * (b.right_m - a.right_m)};
}

double Route::gradient(double s_m) const {
  const double s = std::clamp(s_m, points_.front().s_m, points_.back().s_m);
  const std::size_t i = segment_at(s);
  const double u = (s - points_[i].s_m) / (points_[i + 1].s_m - points_[i].s_m);
  return gradients_[i] + u * (gradients_[i + 1] - gradients_[i]);
}

void Route::make_grid() {
  double min_x = points_.front().x_m;
  double min_y = points_.front().y_m;
  double max_x = min_x;
  double max_y = min_y;
  for (const RoutePoint& p : points_) {
    min_x = std::min(min_x, p.x_m);
    min_y = std::min(min_y, p.y_m);
    max_x = std::max(max_x, p.x_m);
    max_y = std::max(max_y, p.y_m);
  }
  make_pieces();
  const auto make_shape = [&](double cell_m) {
    return GridShape{.origin_x_m = min_x - kGridMargin_m,
                     .origin_y_m = min_y - kGridMargin_m,
                     .cell_m = cell_m,
                     .columns = static_cast<int>((max_x - min_x + 2.0 * kGridMargin_m) / cell_m) + 1,
                     .rows = static_cast<int>((max_y - min_y + 2.0 * kGridMargin_m) / cell_m) + 1};
  };
  // Coarse cells first: fine ones then look only at what is near the coarse cell that they lie in.
  std::vector<std::uint32_t> all(pieces_.size());
  std::iota(all.begin(), all.end(), 0U);
  Grid2D<std::vector<std::uint32_t>> coarse(make_shape(kCoarse_m));
  for (int row = 0; row < coarse.shape().rows; ++row) {
    for (int column = 0; column < coarse.shape().columns; ++column) {
      const GridIndex cell{column, row};
      *coarse.find(cell) = pieces_near(all, coarse.center_x_m(cell), coarse.center_y_m(cell), kCoarse_m);
    }
  }
  cells_ = Grid2D<std::array<std::uint32_t, 2>>(make_shape(kCell_m));
  for (int row = 0; row < cells_.shape().rows; ++row) {
    for (int column = 0; column < cells_.shape().columns; ++column) {
      const GridIndex cell{column, row};
      const double x = cells_.center_x_m(cell);
      const double y = cells_.center_y_m(cell);
      const auto* const around = coarse.find_at(x, y);
      const std::vector<std::uint32_t> near = pieces_near(around != nullptr ? *around : all, x, y, kCell_m);
      const auto begin = static_cast<std::uint32_t>(near_.size());
      near_.insert(near_.end(), near.begin(), near.end());
      *cells_.find(cell) = {begin, static_cast<std::uint32_t>(near_.size())};
    }
  }
}

void Route::make_pieces() {
  for (std::size_t first = 0; first + 1 < points_.size(); first += kSegmentsPerPiece) {
    const std::size_t last = std::min(first + kSegmentsPerPiece, points_.size() - 1);
    const RoutePoint& middle = points_[(first + last) / 2];
    Piece piece{middle.x_m, middle.y_m, 0.0, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last)};
    for (std::size_t i = first; i <= last; ++i) {
      piece.radius_m = std::max(piece.radius_m, std::hypot(points_[i].x_m - middle.x_m, points_[i].y_m - middle.y_m));
    }
    pieces_.push_back(piece);
  }
}

std::vector<std::uint32_t> Route::pieces_near(const std::vector<std::uint32_t>& among, double x_m, double y_m,
                                              double cell_m) const {
  const auto distance = [&](const Piece& piece) {
    const double dx = piece.x_m - x_m;
    const double dy = piece.y_m - y_m;
    return std::sqrt(dx * dx + dy * dy);
  };
  double surely_within = std::numeric_limits<double>::infinity();
  for (const std::uint32_t i : among) {
    surely_within = std::min(surely_within, distance(pieces_[i]));
  }
  // A place of the cell is up to half a diagonal away from its middle, to and fro.
  const double diagonal = cell_m * std::sqrt(2.0);
  std::vector<std::uint32_t> near;
  for (const std::uint32_t i : among) {
    if (distance(pieces_[i]) - pieces_[i].radius_m <= surely_within + diagonal) {
      near.push_back(i);
    }
  }
  return near;
}

void Route::search_piece(const Piece& piece, double x_m, double y_m, Candidate& best) const {
  const double to_x = piece.x_m - x_m;
  const double to_y = piece.y_m - y_m;
  const double within = best.distance_m + piece.radius_m;
  if (to_x * to_x + to_y * to_y >= within * within) {
    return;
  }
  const double squared_before = best.squared_m2;
  for (std::size_t i = piece.first; i < piece.last; ++i) {
    const double dx = points_[i + 1].x_m - points_[i].x_m;
    const double dy = points_[i + 1].y_m - points_[i].y_m;
    const double px = x_m - points_[i].x_m;
    const double py = y_m - points_[i].y_m;
    const double u = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    const double squared = (px - u * dx) * (px - u * dx) + (py - u * dy) * (py - u * dy);
    if (squared < best.squared_m2) {
      best.squared_m2 = squared;
      best.segment = i;
      best.share = u;
    }
  }
  if (best.squared_m2 < squared_before) {
    best.distance_m = std::sqrt(best.squared_m2);
  }
}

Route::Candidate Route::nearest_chord(double x_m, double y_m) const {
  Candidate best;
  if (const auto* range = cells_.find_at(x_m, y_m)) {
    for (std::uint32_t k = (*range)[0]; k < (*range)[1]; ++k) {
      search_piece(pieces_[near_[k]], x_m, y_m, best);
    }
    return best;
  }
  for (const Piece& piece : pieces_) {
    search_piece(piece, x_m, y_m, best);
  }
  return best;
}

RoutePlace Route::nearest(double x_m, double y_m) const {
  const Candidate start = nearest_chord(x_m, y_m);
  const Eigen::Vector2d p(x_m, y_m);
  std::size_t i = start.segment;
  double u = start.share;
  Cubic cubic = cubic_at(points_[i], points_[i + 1], tangents_[i], tangents_[i + 1], u);
  for (int step = 0; step < kNewtonSteps; ++step) {
    // The foot of the perpendicular: (p - c) . c' = 0. Its derivative is negative up to the centre of the bend.
    const Eigen::Vector2d offset = p - cubic.place;
    const double miss = offset.dot(cubic.first);
    const double change = std::min(offset.dot(cubic.second) - cubic.first.squaredNorm(), -0.05);
    double s = points_[i].s_m + u * (points_[i + 1].s_m - points_[i].s_m) - miss / change;
    s = std::clamp(s, points_.front().s_m, points_.back().s_m);
    while (i > 0 && s < points_[i].s_m) {
      --i;
    }
    while (i + 2 < points_.size() && s > points_[i + 1].s_m) {
      ++i;
    }
    u = (s - points_[i].s_m) / (points_[i + 1].s_m - points_[i].s_m);
    cubic = cubic_at(points_[i], points_[i + 1], tangents_[i], tangents_[i + 1], u);
    if (std::abs(miss) < 1e-7) {
      break;
    }
  }
  if ((p - cubic.place).norm() > start.distance_m + kChordError_m) {
    // Around the centre of a bend the search for the foot can leave the nearest branch.
    i = start.segment;
    u = start.share;
    cubic = cubic_at(points_[i], points_[i + 1], tangents_[i], tangents_[i + 1], u);
  }
  const Eigen::Vector2d offset = p - cubic.place;
  const double s = points_[i].s_m + u * (points_[i + 1].s_m - points_[i].s_m);
  const double along = offset.dot(cubic.first);
  RoutePlace place{.s_m = s};
  const bool before = s <= points_.front().s_m && along < 0.0;
  const bool behind = s >= points_.back().s_m && along > 0.0;
  const double across = cubic.first.x() * offset.y() - cubic.first.y() * offset.x();
  if (before || behind) {
    place.left_m = across;
    place.beyond_m = std::abs(along);
  } else {
    // The distance itself, with the side as its sign: continuous also where the nearest place jumps.
    place.left_m = std::copysign(offset.norm(), across);
  }
  return place;
}

}  // namespace berm::sim
