#include "map_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

namespace berm {
namespace {

/// Points of tiles farther away that are taken in with one scan.
constexpr std::size_t kPointsPerCall = 6000;
/// A tile is forgotten so much farther out than it is fetched: one at the border is not to come and go.
constexpr double kLeave_m = 15.0;
/// Tiles have smaller numbers: places that are farther out are those of no tile.
constexpr double kMostTiles = 1e9;
constexpr double kGroundCell_m = 1.0;
/// The ground of a place is that of so many cells at least, from the first of these radii that holds them.
constexpr std::size_t kFewestGroundCells = 8;
constexpr double kGroundRadii_m[] = {2.5, 4.0, 7.0, 12.0};

}  // namespace

MapTiles::MapTiles(const SurfaceOdometryConfig& matching, double reach_m, MapTileSource& source)
    : matching_(matching),
      reach_m_(reach_m),
      source_(source),
      tile_m_(source.tile_m()),
      ground_cells_(static_cast<std::size_t>(std::ceil(tile_m_ / kGroundCell_m))),
      origin_m_(source.origin_m()) {}

TileKey MapTiles::tile_of(double x_m, double y_m) const {
  const auto index_of = [this](double from_origin_m) {
    return static_cast<std::int32_t>(std::clamp(std::floor(from_origin_m / tile_m_), -kMostTiles, kMostTiles));
  };
  return {index_of(x_m - origin_m_.x()), index_of(y_m - origin_m_.y())};
}

double MapTiles::distance_m(const TileKey& key, const Eigen::Vector3d& place_m) const {
  const auto beyond_m = [this](double at_m, std::int32_t index) {
    const double low_m = index * tile_m_;
    return std::max({low_m - at_m, 0.0, at_m - low_m - tile_m_});
  };
  return std::hypot(beyond_m(place_m.x() - origin_m_.x(), key.x), beyond_m(place_m.y() - origin_m_.y(), key.y));
}

std::vector<TileKey> MapTiles::tiles_within(double radius_m, const Eigen::Vector3d& place_m) const {
  std::vector<TileKey> keys;
  const TileKey low = tile_of(place_m.x() - radius_m, place_m.y() - radius_m);
  const TileKey high = tile_of(place_m.x() + radius_m, place_m.y() + radius_m);
  for (std::int32_t y = low.y; y <= high.y; ++y) {
    for (std::int32_t x = low.x; x <= high.x; ++x) {
      const TileKey key{x, y};
      if (distance_m(key, place_m) <= radius_m && source_.has(key)) {
        keys.push_back(key);
      }
    }
  }
  std::stable_sort(keys.begin(), keys.end(),
                   [&](const TileKey& a, const TileKey& b) { return distance_m(a, place_m) < distance_m(b, place_m); });
  return keys;
}

void MapTiles::fetch(const TileKey& key) {
  Tile& tile = tiles_.try_emplace(key, matching_).first->second;
  tile.rest = source_.load(key);
  tile.ground.resize(ground_cells_ * ground_cells_);
  const Eigen::Vector2d corner_m(key.x * tile_m_, key.y * tile_m_);
  const auto cell_of = [this](double from_corner_m) {
    const double cell = std::clamp(from_corner_m / kGroundCell_m, 0.0, static_cast<double>(ground_cells_ - 1));
    return static_cast<std::size_t>(cell);
  };
  for (const SurfacePoint& point : tile.rest) {
    if (point.label != Label::obstacle) {
      const std::size_t column = cell_of(static_cast<double>(point.x_m) - corner_m.x());
      const std::size_t row = cell_of(static_cast<double>(point.y_m) - corner_m.y());
      GroundCell& cell = tile.ground[row * ground_cells_ + column];
      cell.height_sum_m += static_cast<double>(point.z_m);
      ++cell.points;
    }
  }
}

void MapTiles::add(Tile& tile, std::size_t count) const {
  for (std::size_t i = 0; i < count; ++i) {
    const SurfacePoint& point = tile.rest.back();
    tile.map.add(origin_m_ + Eigen::Vector3d(point.x_m, point.y_m, point.z_m), point.label != Label::obstacle);
    tile.rest.pop_back();
  }
  if (tile.rest.empty()) {
    tile.rest.shrink_to_fit();
  }
}

void MapTiles::follow(const Eigen::Vector3d& place_m) {
  std::erase_if(tiles_, [&](const auto& entry) { return distance_m(entry.first, place_m) > reach_m_ + kLeave_m; });
  std::size_t budget = kPointsPerCall;
  for (const TileKey& key : tiles_within(reach_m_, place_m)) {
    const bool is_near = distance_m(key, place_m) <= 0.5 * reach_m_;
    if (budget == 0 && !is_near) {
      break;
    }
    if (!tiles_.contains(key)) {
      fetch(key);
      // Reading the file was work enough for a scan.
      budget = 0;
    }
    Tile& tile = tiles_.at(key);
    const std::size_t count = is_near ? tile.rest.size() : std::min(budget, tile.rest.size());
    add(tile, count);
    budget -= std::min(budget, count);
  }
}

SurfaceHit MapTiles::find(const Eigen::Vector3d& map_m, bool is_ground) const {
  const auto tile = tiles_.find(tile_of(map_m.x(), map_m.y()));
  return tile == tiles_.end() ? SurfaceHit{} : tile->second.map.find(map_m, is_ground);
}

const MapTiles::GroundCell* MapTiles::ground_cell(double x_m, double y_m) const {
  const TileKey key = tile_of(x_m, y_m);
  const auto tile = tiles_.find(key);
  if (tile == tiles_.end()) {
    return nullptr;
  }
  const auto cell_of = [this](double from_corner_m) {
    return std::min(static_cast<std::size_t>(std::max(0.0, from_corner_m / kGroundCell_m)), ground_cells_ - 1);
  };
  const std::size_t column = cell_of(x_m - origin_m_.x() - key.x * tile_m_);
  const std::size_t row = cell_of(y_m - origin_m_.y() - key.y * tile_m_);
  const GroundCell& cell = tile->second.ground[row * ground_cells_ + column];
  return cell.points > 0 ? &cell : nullptr;
}

std::optional<MapGround> MapTiles::ground_at(const Eigen::Vector2d& place_m) const {
  for (const double radius_m : kGroundRadii_m) {
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    Eigen::Vector3d heights = Eigen::Vector3d::Zero();
    std::size_t cells = 0;
    for (double dy_m = -radius_m; dy_m <= radius_m; dy_m += kGroundCell_m) {
      for (double dx_m = -radius_m; dx_m <= radius_m; dx_m += kGroundCell_m) {
        const GroundCell* cell = ground_cell(place_m.x() + dx_m, place_m.y() + dy_m);
        if (dx_m * dx_m + dy_m * dy_m > radius_m * radius_m || cell == nullptr) {
          continue;
        }
        const Eigen::Vector3d row(1.0, dx_m, dy_m);
        squares += row * row.transpose();
        heights += cell->height_sum_m / cell->points * row;
        ++cells;
      }
    }
    // Cells in a row tell no slope across it: what is not told is taken to be level.
    squares.diagonal() += Eigen::Vector3d(0.0, 1.0, 1.0);
    if (cells >= kFewestGroundCells) {
      const Eigen::Vector3d plane = squares.ldlt().solve(heights);
      return MapGround{origin_m_.z() + plane[0], Eigen::Vector3d(-plane[1], -plane[2], 1.0).normalized()};
    }
  }
  return std::nullopt;
}

}  // namespace berm
