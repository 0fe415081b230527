#include "terrain_mesh.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <thread>

#include <fmt/format.h>

#include "berm/core/error.hpp"

namespace berm::sim {
namespace {

/// A sixteenth of what fits the indices of Embree; 2^26 cells take about 8 GB.
constexpr std::size_t kMaxVertices = std::size_t{1} << 26U;
/// The wall between tiles: as far above and below the border as floats of 1 km may be off, and then some.
constexpr float kWallAbove_m = 2e-4F;
constexpr float kWallBelow_m = 0.05F;

/// Runs `work(i)` for 0 <= i < count; the first exception, by number, comes out.
template <typename Work>
void for_all(std::size_t count, int threads, const Work& work) {
  const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t workers = std::min<std::size_t>(count, threads > 0 ? static_cast<unsigned>(threads) : processors);
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> failures(workers);
  const auto run = [&](std::size_t worker) {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        work(i);
      }
    } catch (...) {
      failures[worker] = std::current_exception();
    }
  };
  std::vector<std::thread> pool;
  for (std::size_t worker = 1; worker < workers; ++worker) {
    pool.emplace_back(run, worker);
  }
  if (workers > 0) {
    run(0);
  }
  for (std::thread& thread : pool) {
    thread.join();
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) {
      std::rethrow_exception(failure);
    }
  }
}

std::size_t tiles_along(double min_m, double max_m, double tile_m) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil((max_m - min_m) / tile_m)));
}

}  // namespace

TerrainMesh::TerrainMesh(const World& world, const RayCasterConfig& config) {
  lay_tiles(world, config);
  for_all(tiles_.size(), config.threads,
          [&](std::size_t i) { sample_tile(*world.terrain, i % columns_, i / columns_); });
  join_tiles();
  make_quads();
}

std::uint32_t TerrainMesh::level_at(const Route& route, double x_m, double y_m, double fine_width_m) const {
  if (route.points().size() < 2) {
    return 0;
  }
  const RoutePlace place = route.nearest(x_m, y_m);
  const double half_diagonal_m = cell_m_ * kTileCells * std::sqrt(0.5);
  const double distance_m = std::hypot(place.left_m, place.beyond_m) - half_diagonal_m;
  std::uint32_t level = 0;
  for (double width_m = fine_width_m; distance_m > width_m && level < kMaxLevel; width_m *= 2.0) {
    ++level;
  }
  return level;
}

void TerrainMesh::lay_tiles(const World& world, const RayCasterConfig& config) {
  const Area& area = world.area;
  const auto in = [](double value, double low, double high) { return value >= low && value <= high; };
  if (!world.terrain || !in(config.fine_cell_m, 0.01, 100.0) || !in(config.fine_width_m, 0.1, 1e6) ||
      !in(area.max_x_m - area.min_x_m, 1e-3, 1e6) || !in(area.max_y_m - area.min_y_m, 1e-3, 1e6)) {
    throw Error(ErrorCode::invalid_argument,
                "ray caster: needs a terrain, an area of 1 mm to 1000 km, cells of 0.01 to 100 m and a width of 0.1 m "
                "to 1000 km");
  }
  cell_m_ = config.fine_cell_m;
  per_cell_ = 1.0 / cell_m_;
  const double tile_m = cell_m_ * kTileCells;
  // On multiples of the cell: the usual sizes are then exact in float.
  min_x_m_ = std::floor(area.min_x_m / cell_m_) * cell_m_;
  min_y_m_ = std::floor(area.min_y_m / cell_m_) * cell_m_;
  columns_ = tiles_along(min_x_m_, area.max_x_m, tile_m);
  rows_ = tiles_along(min_y_m_, area.max_y_m, tile_m);
  std::size_t vertices = 0;
  if (columns_ * rows_ <= kMaxVertices) {
    tiles_.resize(columns_ * rows_);
    for_all(tiles_.size(), config.threads, [&](std::size_t i) {
      const double x_m = min_x_m_ + (static_cast<double>(i % columns_) + 0.5) * tile_m;
      const std::size_t row = i / columns_;
      const double y_m = min_y_m_ + (static_cast<double>(row) + 0.5) * tile_m;
      tiles_[i].level = level_at(world.route, x_m, y_m, config.fine_width_m);
      tiles_[i].scale = 1.0F / static_cast<float>(1U << tiles_[i].level);
    });
  }
  for (Tile& tile : tiles_) {
    tile.first_vertex = static_cast<std::uint32_t>(vertices);
    vertices += static_cast<std::size_t>(cells_of(tile) + 1) * (cells_of(tile) + 1);
    if (vertices > kMaxVertices) {
      break;
    }
  }
  if (tiles_.empty() || vertices > kMaxVertices) {
    throw Error(ErrorCode::invalid_argument,
                fmt::format("ray caster: {:.0f} x {:.0f} m of terrain with cells of {} m need more than {} vertices; "
                            "give a smaller area or larger cells",
                            area.max_x_m - area.min_x_m, area.max_y_m - area.min_y_m, cell_m_, kMaxVertices));
  }
  positions_m.resize(3 * vertices);
  samples_.resize(vertices);
}

void TerrainMesh::sample_tile(const Terrain& terrain, std::size_t column, std::size_t row) {
  const Tile& tile = tiles_[row * columns_ + column];
  const std::size_t cells = cells_of(tile);
  const std::size_t step = kTileCells / cells;
  std::size_t vertex = tile.first_vertex;
  for (std::size_t j = 0; j <= cells; ++j) {
    for (std::size_t i = 0; i <= cells; ++i, ++vertex) {
      const double x_m = min_x_m_ + static_cast<double>(column * kTileCells + i * step) * cell_m_;
      const double y_m = min_y_m_ + static_cast<double>(row * kTileCells + j * step) * cell_m_;
      const GroundSample ground = terrain.at(x_m, y_m);
      if (!std::isfinite(ground.height_m) || !std::isfinite(ground.inside_m) || !std::isfinite(ground.across_m)) {
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("ray caster: the terrain is not finite at x {} m, y {} m", x_m, y_m));
      }
      positions_m[3 * vertex] = static_cast<float>(x_m);
      positions_m[3 * vertex + 1] = static_cast<float>(y_m);
      positions_m[3 * vertex + 2] = static_cast<float>(ground.height_m);
      samples_[vertex] = {static_cast<float>(ground.inside_m), static_cast<float>(ground.across_m), ground.surface};
    }
  }
}

void TerrainMesh::join_side(std::size_t column, std::size_t row, int side) {
  // Left, right, lower, upper side.
  const std::size_t i = row * columns_ + column;
  const bool vertical = side < 2;
  const bool far = side % 2 == 1;
  const std::size_t place = vertical ? column : row;
  if (far ? place + 1 == (vertical ? columns_ : rows_) : place == 0) {
    return;
  }
  const std::size_t apart = vertical ? 1 : columns_;
  const Tile& tile = tiles_[i];
  const Tile& other = tiles_[far ? i + apart : i - apart];
  if (other.level <= tile.level) {
    return;
  }
  const std::uint32_t cells = cells_of(tile);
  const std::uint32_t stride = vertical ? cells + 1 : 1;
  const std::uint32_t first = tile.first_vertex + (far ? (vertical ? cells : cells * (cells + 1)) : 0);
  const std::uint32_t step = 1U << (other.level - tile.level);
  const auto height_m = [&](std::uint32_t k) -> float& {
    return positions_m[3 * static_cast<std::size_t>(first + k * stride) + 2];
  };
  for (std::uint32_t k = 0; k < cells; ++k) {
    if (const std::uint32_t rest = k % step; rest != 0) {
      const float before_m = height_m(k - rest);
      const float after_m = height_m(k - rest + step);
      height_m(k) = before_m + (after_m - before_m) * (static_cast<float>(rest) / static_cast<float>(step));
    }
  }
  // The wall.
  const auto wall = static_cast<std::uint32_t>(positions_m.size() / 3);
  for (std::uint32_t k = 0; k <= cells; ++k) {
    const std::size_t vertex = first + k * stride;
    for (const float up_m : {kWallAbove_m, -kWallBelow_m}) {
      const std::array<float, 3> top{positions_m[3 * vertex], positions_m[3 * vertex + 1],
                                     positions_m[3 * vertex + 2] + up_m};
      positions_m.insert(positions_m.end(), top.begin(), top.end());
    }
  }
  for (std::uint32_t k = 0; k < cells; ++k) {
    const std::uint32_t at = wall + 2 * k;
    quads.push_back({at, at + 1, at + 3, at + 2});
  }
}

void TerrainMesh::join_tiles() {
  for (std::size_t row = 0; row < rows_; ++row) {
    for (std::size_t column = 0; column < columns_; ++column) {
      for (int side = 0; side < 4; ++side) {
        join_side(column, row, side);
      }
    }
  }
}

void TerrainMesh::make_quads() {
  quads.reserve(quads.size() + samples_.size());
  for (const Tile& tile : tiles_) {
    const std::uint32_t cells = cells_of(tile);
    for (std::uint32_t j = 0; j < cells; ++j) {
      for (std::uint32_t i = 0; i < cells; ++i) {
        const std::uint32_t corner = tile.first_vertex + j * (cells + 1) + i;
        quads.push_back({corner, corner + 1, corner + cells + 2, corner + cells + 1});
      }
    }
  }
}

TerrainSpot TerrainMesh::spot_at(double x_m, double y_m) const {
  // An area has at most 1e8 cells along a side: signed numbers of 32 bits hold them, and convert the quickest.
  constexpr std::int32_t kCells{kTileCells};
  const auto columns = static_cast<std::int32_t>(columns_);
  const auto rows = static_cast<std::int32_t>(rows_);
  const double u = std::clamp((x_m - min_x_m_) * per_cell_, 0.0, static_cast<double>(columns * kCells));
  const double v = std::clamp((y_m - min_y_m_) * per_cell_, 0.0, static_cast<double>(rows * kCells));
  const std::int32_t column = std::min(columns - 1, static_cast<std::int32_t>(u) >> kMaxLevel);
  const std::int32_t row = std::min(rows - 1, static_cast<std::int32_t>(v) >> kMaxLevel);
  const Tile& tile = tiles_[static_cast<std::size_t>(row) * columns_ + static_cast<std::size_t>(column)];
  const auto cells = static_cast<std::int32_t>(cells_of(tile));
  const float in_u = static_cast<float>(u - static_cast<double>(column * kCells)) * tile.scale;
  const float in_v = static_cast<float>(v - static_cast<double>(row * kCells)) * tile.scale;
  const std::int32_t i = std::min(cells - 1, static_cast<std::int32_t>(in_u));
  const std::int32_t j = std::min(cells - 1, static_cast<std::int32_t>(in_v));
  const std::uint32_t lower = tile.first_vertex + static_cast<std::uint32_t>(j * (cells + 1) + i);
  const std::uint32_t upper = lower + static_cast<std::uint32_t>(cells) + 1;
  __builtin_prefetch(&samples_[lower]);
  __builtin_prefetch(&samples_[upper]);
  return {lower, upper, in_u - static_cast<float>(i), in_v - static_cast<float>(j),
          static_cast<float>(per_cell_) * tile.scale};
}

TerrainDetail TerrainMesh::detail(const TerrainSpot& spot) const {
  const Sample* lower = &samples_[spot.lower];
  const Sample* upper = &samples_[spot.upper];
  const float share_u = spot.share_u;
  const float share_v = spot.share_v;
  const float per_m = spot.cells_per_m;
  const auto mix = [](float share, float from, float to) { return from + share * (to - from); };
  TerrainDetail detail;
  detail.inside_m = mix(share_v, mix(share_u, lower[0].inside_m, lower[1].inside_m),
                        mix(share_u, upper[0].inside_m, upper[1].inside_m));
  const float below_m = mix(share_u, lower[0].across_m, lower[1].across_m);
  const float above_m = mix(share_u, upper[0].across_m, upper[1].across_m);
  detail.across_m = mix(share_v, below_m, above_m);
  detail.across_slope = {
      mix(share_v, lower[1].across_m - lower[0].across_m, upper[1].across_m - upper[0].across_m) * per_m,
      (above_m - below_m) * per_m};
  detail.surface = (share_v < 0.5F ? lower : upper)[share_u < 0.5F ? 0 : 1].surface;
  return detail;
}

std::size_t TerrainMesh::memory_bytes() const {
  return tiles_.capacity() * sizeof(Tile) + samples_.capacity() * sizeof(Sample) +
         positions_m.capacity() * sizeof(float) + quads.capacity() * sizeof(quads[0]);
}

}  // namespace berm::sim
