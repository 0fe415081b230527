// berm_large_map RUN [MILLIONS]: puts a made map of the surface into a run, to try how `berm view` copes: a haul road
// of 1 km through hills, 200 m from side to side, a point in every voxel of 0.1 m: 20 million.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "berm/io/surface_folder.hpp"

namespace {

constexpr double kVoxel_m = 0.1;
constexpr int kTileVoxels = 200;
constexpr int kTilesAlong = 50;
constexpr double kPointsPerTile = double{kTileVoxels} * kTileVoxels;

/// A number in [0, 1) that is the same for the same place.
double noise(int x, int y) {
  const double value = std::sin(12.9898 * x + 78.233 * y) * 43758.5453;
  return value - std::floor(value);
}

/// Road of 24 m with a berm of 1.6 m to either side, hills beyond.
berm::SurfacePoint surface_at(int x, int y) {
  constexpr double kHalfRoad_m = 12.0;
  constexpr double kBerm_m = 1.6;
  const double x_m = (x + 0.5) * kVoxel_m;
  const double y_m = (y + 0.5) * kVoxel_m;
  const double off_m = std::abs(y_m - 8.0 * std::sin(x_m / 90.0)) - kHalfRoad_m;
  const double grade_m = 12.0 * std::sin(x_m / 240.0);
  const double berm_m = kBerm_m * std::max(0.0, 1.0 - std::abs(off_m - 2.0) / 2.0);
  const double hill_m = off_m > 4.0 ? 0.002 * (off_m - 4.0) * (off_m - 4.0) * (1.0 + std::sin(x_m / 35.0)) : 0.0;
  berm::SurfacePoint point;
  point.x_m = static_cast<float>(x_m);
  point.y_m = static_cast<float>(y_m);
  point.z_m = static_cast<float>(grade_m + berm_m + hill_m + 0.04 * noise(x, y));
  point.intensity = static_cast<float>(30.0 + 60.0 * noise(y, x));
  point.label = off_m < 0.0 ? berm::Label::drivable : berm::Label::terrain;
  point.count = 5;
  return point;
}

std::vector<berm::SurfacePoint> make_tile(const berm::TileKey& key) {
  std::vector<berm::SurfacePoint> points;
  points.reserve(static_cast<std::size_t>(kPointsPerTile));
  for (int y = 0; y < kTileVoxels; ++y) {
    for (int x = 0; x < kTileVoxels; ++x) {
      points.push_back(surface_at(key.x * kTileVoxels + x, key.y * kTileVoxels + y));
    }
  }
  return points;
}

void make_map(const std::filesystem::path& folder, double millions) {
  const int across = std::max(1, static_cast<int>(std::lround(millions * 1e6 / kPointsPerTile / kTilesAlong)));
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  berm::SurfaceFolder map(folder, {.voxel_m = kVoxel_m, .tile_m = kVoxel_m * kTileVoxels});
  for (int x = 0; x < kTilesAlong; ++x) {
    for (int y = 0; y < across; ++y) {
      const berm::TileKey key{x, y - across / 2};
      map.save(key, make_tile(key));
    }
  }
  map.commit();
  fmt::print("{}: {} points in {} tiles\n", folder.string(), map.points(), map.index().tiles.size());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    fmt::print(stderr, "usage: berm_large_map RUN [MILLIONS]\n");
    return 2;
  }
  try {
    make_map(std::filesystem::path(argv[1]) / "map", argc > 2 ? std::atof(argv[2]) : 20.0);
  } catch (const std::exception& error) {
    fmt::print(stderr, "berm_large_map: {}\n", error.what());
    return 1;
  }
  return 0;
}
