// berm_surface_accuracy RECORDING OUT [OUT_WITHOUT_REMOVAL]: the surface map of a run on a simulated recording against
// its truth: sharpness, heights of the ground, flakes that were mapped, and what became of moving machines.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/eval/sharpness.hpp"
#include "berm/geometry/voxel_hash.hpp"
#include "berm/io/height_raster.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/pcd.hpp"
#include "berm/io/recording.hpp"
#include "berm/io/sensor_sheet.hpp"
#include "berm/io/surface_folder.hpp"
#include "berm/map/elevation.hpp"

namespace berm::bench {
namespace {

namespace fs = std::filesystem;

/// Classes of SemanticKITTI for what moves; the upper half of a label says which one it is.
constexpr std::uint32_t kFirstMoving = 252;
constexpr std::uint32_t kLastMoving = 259;
constexpr std::uint32_t kClassMask = 0xffff;
constexpr std::uint32_t kFlake = 110;
constexpr double kCell_m = 0.5;

/// What the points in a voxel truly are.
struct TruthVoxel {
  std::uint32_t moving = 0;
  std::uint32_t flake = 0;
  std::uint32_t other = 0;

  [[nodiscard]] bool is_moving() const { return moving > other; }
  [[nodiscard]] bool is_flake() const { return flake > other + moving; }
};

VoxelHash<TruthVoxel> read_truth(const fs::path& folder, double voxel_m) {
  const Recording recording = Recording::open(folder);
  const auto poses = recording.read_truth_poses();
  if (!poses) {
    throw Error(ErrorCode::invalid_argument, folder.string() + " is no simulated recording");
  }
  const SensorSheet& sheet = recording.sheet();
  const Pose T_base_sensor =
      Pose::from_yaw_pitch_roll(0.0, sheet.pitch_rad.value_or(0.0), 0.0, {0.0, 0.0, sheet.height_m.value_or(0.0)});
  VoxelHash<TruthVoxel> voxels(voxel_m);
  Scan scan;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    recording.read(i, scan);
    const PointsView points = scan.cloud.view();
    const auto labels = read_labels(recording.scan(i).truth_labels.value(), points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double time_s = points.time.empty() ? 0.0 : double{points.time[k]};
      const auto pose = poses->at(scan.stamp_ns + from_seconds(time_s));
      const auto key =
          pose && labels[k] != 0
              ? voxels.key_of(*pose * T_base_sensor * Eigen::Vector3d(points.x[k], points.y[k], points.z[k]))
              : std::nullopt;
      if (key) {
        TruthVoxel& voxel = voxels.at_or_new(*key);
        const std::uint32_t label = labels[k] & kClassMask;
        ++(label >= kFirstMoving && label <= kLastMoving ? voxel.moving : label == kFlake ? voxel.flake : voxel.other);
      }
    }
  }
  return voxels;
}

/// Voxels of a map by what they truly are.
struct MapContent {
  std::size_t moving = 0;
  std::size_t moving_as_ground = 0;  ///< of `moving`
  std::size_t flake = 0;
  std::size_t obstacle = 0;  ///< that stands
  std::size_t ground = 0;
};

MapContent content_of(const SurfaceFolder& map, const VoxelHash<TruthVoxel>& truth) {
  MapContent content;
  for (const auto& [key, entry] : map.index().tiles) {
    for (const SurfacePoint& point : map.load(key)) {
      const Eigen::Vector3d place_m = map.index().frame.origin_m + Eigen::Vector3d(point.x_m, point.y_m, point.z_m);
      const auto voxel_key = truth.key_of(place_m);
      const TruthVoxel* voxel = voxel_key ? truth.find(*voxel_key) : nullptr;
      if (voxel != nullptr && voxel->is_moving()) {
        ++content.moving;
        content.moving_as_ground += point.label == Label::obstacle ? 0U : 1U;
      } else if (voxel != nullptr && voxel->is_flake()) {
        ++content.flake;
      } else {
        ++(point.label == Label::obstacle ? content.obstacle : content.ground);
      }
    }
  }
  return content;
}

double quantile(std::vector<double>& values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// Heights against the true ground at the middles of its own cells, since it is no finer than the map's.
void print_heights(const SurfaceFolder& map, const fs::path& recording) {
  const HeightRaster ground = read_height_raster(recording / "terrain.asc");
  ElevationBuilder builder(map.index().frame.tile_m, kCell_m);
  for (const auto& [key, entry] : map.index().tiles) {
    builder.add_tile(map.load(key));
  }
  std::vector<double> errors_m;
  for (const ElevationCell& cell : builder.finish()) {
    // The middle of a cell of the map is that of one of the ground, where both have cells of half a metre.
    const double column = (cell.column + 0.5) * builder.cell_m() + map.index().frame.origin_m.x() - ground.origin_x_m;
    const double row = (cell.row + 0.5) * builder.cell_m() + map.index().frame.origin_m.y() - ground.origin_y_m;
    const double c = std::floor(column / ground.cell_m);
    const double r = std::floor(row / ground.cell_m);
    if (c >= 0.0 && r >= 0.0 && c < static_cast<double>(ground.columns) && r < static_cast<double>(ground.rows)) {
      const double truth_m = ground.at(static_cast<std::size_t>(c), static_cast<std::size_t>(r));
      if (!std::isnan(truth_m)) {
        errors_m.push_back(std::abs(map.index().frame.origin_m.z() + cell.height_m - truth_m));
      }
    }
  }
  if (!errors_m.empty()) {
    fmt::print("  ground: {} cells, error median {:.3f} m, 90 % {:.3f} m, 99 % {:.3f} m\n", errors_m.size(),
               quantile(errors_m, 0.5), quantile(errors_m, 0.9), quantile(errors_m, 0.99));
  }
}

void print_map(const char* title, const SurfaceFolder& map, const MapContent& content, const fs::path& cloud) {
  const PointCloud points(read_pcd(cloud).channels);
  const PointsView view = points.view();
  const Sharpness sharpness = measure_sharpness(view.x, view.y, view.z);
  fmt::print("{}: {} voxels: {} ground, {} obstacle, {} of what moves ({} as ground), {} flakes\n", title, map.points(),
             content.ground, content.obstacle, content.moving, content.moving_as_ground, content.flake);
  fmt::print("  thickness mean {:.4f} m, median {:.4f} m over {} patches\n", sharpness.mean_thickness_m,
             sharpness.median_thickness_m, sharpness.patches);
}

double lost_percent(std::size_t with, std::size_t without) {
  return without == 0 ? 0.0 : 100.0 * (1.0 - static_cast<double>(with) / static_cast<double>(without));
}

int measure(const fs::path& recording, const fs::path& out, const fs::path& without) {
  const SurfaceFolder map = SurfaceFolder::open(out / "map");
  const VoxelHash<TruthVoxel> truth = read_truth(recording, map.index().frame.voxel_m);
  const MapContent content = content_of(map, truth);
  print_map("map", map, content, out / "map.pcd");
  print_heights(map, recording);
  if (!without.empty()) {
    const SurfaceFolder all = SurfaceFolder::open(without / "map");
    const MapContent before = content_of(all, truth);
    print_map("without removal", all, before, without / "map.pcd");
    fmt::print("taken out: {:.1f} % of what moves, {:.1f} % of flakes, {:.1f} % of obstacles that stand\n",
               lost_percent(content.moving, before.moving), lost_percent(content.flake, before.flake),
               lost_percent(content.obstacle, before.obstacle));
  }
  return 0;
}

}  // namespace
}  // namespace berm::bench

int main(int argc, char** argv) {
  if (argc != 3 && argc != 4) {
    fmt::print(stderr, "usage: berm_surface_accuracy RECORDING OUT [OUT_WITHOUT_REMOVAL]\n");
    return 2;
  }
  try {
    return berm::bench::measure(argv[1], argv[2], argc == 4 ? argv[3] : "");
  } catch (const std::exception& error) {
    fmt::print(stderr, "error: {}\n", error.what());
    return 1;
  }
}
