#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "berm/sim/ray_caster.hpp"
#include "berm/sim/world.hpp"

namespace berm::sim {

/// What a hit on the terrain needs to know of it.
struct TerrainDetail {
  float inside_m = 0.0F;
  float across_m = 0.0F;
  Eigen::Vector2f across_slope = Eigen::Vector2f::Zero();  ///< change of across_m along x and y
  Surface surface = Surface::rough_snow;
};

/// The terrain as square tiles of quads, each with cells of its own size: fine near the route, coarser by two for every
/// doubling of the distance. Tiles of different levels share their borders: the finer one bends its vertices onto the
/// edges of the coarser one, and a low wall closes what rounding leaves open.
class TerrainMesh {
 public:
  TerrainMesh(const World& world, const RayCasterConfig& config);

  /// x, y, z of all vertices; quads index them. Both may be dropped once Embree has them.
  std::vector<float> positions_m;
  std::vector<std::array<std::uint32_t, 4>> quads;

  /// The cell of a place, of the nearest one outside of the mesh. Has the processor fetch its samples.
  [[nodiscard]] TerrainSpot spot_at(double x_m, double y_m) const;
  /// Interpolated between the samples of the cell.
  [[nodiscard]] TerrainDetail detail(const TerrainSpot& spot) const;
  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  struct Tile {
    std::uint32_t first_vertex = 0;
    std::uint32_t level = 0;
    float scale = 1.0F;  ///< fine cells over those of the tile
  };

  struct Sample {
    float inside_m = 0.0F;
    float across_m = 0.0F;
    Surface surface = Surface::rough_snow;
  };

  [[nodiscard]] std::uint32_t cells_of(const Tile& tile) const { return kTileCells >> tile.level; }
  [[nodiscard]] std::uint32_t level_at(const Route& route, double x_m, double y_m, double fine_width_m) const;
  void lay_tiles(const World& world, const RayCasterConfig& config);
  void sample_tile(const Terrain& terrain, std::size_t column, std::size_t row);
  void join_side(std::size_t column, std::size_t row, int side);
  void join_tiles();
  void make_quads();

  static constexpr std::uint32_t kMaxLevel = 6;
  static constexpr std::uint32_t kTileCells = 1U << kMaxLevel;

  double min_x_m_ = 0.0;
  double min_y_m_ = 0.0;
  double cell_m_ = 0.0;
  double per_cell_ = 0.0;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<Tile> tiles_;
  std::vector<Sample> samples_;
};

}  // namespace berm::sim
