#include "run_surface.hpp"

#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/io/surface_folder.hpp"
#include "scan_placing.hpp"
#include "surface_elevation.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "map";

/// Floats of coordinates up to here are exact to 0.5 mm.
constexpr double kNearOrigin_m = 8000.0;
/// Round, so that maps of one world fit together.
constexpr double kOriginStep_m = 1000.0;

/// The origin of the world where the first pose is not far from it.
Eigen::Vector3d origin_near(const Eigen::Vector3d& place_m) {
  if (place_m.cwiseAbs().maxCoeff() <= kNearOrigin_m) {
    return Eigen::Vector3d::Zero();
  }
  return kOriginStep_m * (place_m / kOriginStep_m).array().round();
}

}  // namespace

/// The map at work, and its files.
class RunSurface::Tiles final : public SurfaceStore {
 public:
  Tiles(const SurfaceMapConfig& config, const Eigen::Vector3d& origin_m, const fs::path& folder)
      : tiles_(config, origin_m, *this), folder_(folder, {config.voxel_m, tiles_.tile_m(), origin_m}) {}

  [[nodiscard]] SurfaceTiles& tiles() { return tiles_; }
  [[nodiscard]] const SurfaceFolder& folder() const { return folder_; }

  std::vector<SurfacePoint> load(const TileKey& key) override { return folder_.load(key); }
  void save(const TileKey& key, std::span<const SurfacePoint> points) override { folder_.save(key, points); }
  void commit() override { folder_.commit(); }

 private:
  SurfaceTiles tiles_;
  SurfaceFolder folder_;
};

RunSurface::RunSurface(const Machine& machine, const RunOptions& options, const RunPoses* poses)
    : machine_(machine), options_(options) {
  if (poses != nullptr) {
    use(*poses);
  } else if (machine.mapping.surface && machine.methods.odometry == "none") {
    notes_.emplace_back("no map of the surface was written, since there are no poses");
  }
}

void RunSurface::use(const RunPoses& poses) {
  if (!machine_.mapping.surface) {
    return;
  }
  if (poses.trajectory.empty()) {
    notes_.emplace_back("no map of the surface was written, since there are no poses");
    return;
  }
  const fs::path terrain = options_.terrain.empty() ? fs::path(machine_.mapping.terrain) : options_.terrain;
  if (!terrain.empty()) {
    terrain_ = TerrainModel::read(terrain, poses.datum, machine_.mapping.terrain_offset_m);
  }
  guard_ = PoseGuard(poses.trajectory, machine_.pose_guard, poses.poor_fix_stamps);
  poses_ = &poses;
}

RunSurface::~RunSurface() = default;

void RunSurface::place(const Scan& scan, std::span<const Label> labels, PlacedSurface& placed) const {
  double first_s = 0.0;
  placed.trust = place_scan(scan, poses_->trajectory, guard_, placed.motion, first_s);
  if (placed.trust == PoseTrust::trusted) {
    place_surface(scan, labels, first_s, machine_.mapping.max_range_m, placed);
  }
}

void RunSurface::open(const OutputFolder& output) {
  const fs::path folder = output / kFolder;
  std::error_code code;
  fs::create_directory(folder, code);
  if (code) {
    throw FileError(ErrorCode::write_failed, folder.string(), std::nullopt, "cannot be created: " + code.message());
  }
  const Eigen::Vector3d origin_m = origin_near(poses_->trajectory.poses().front().T_world_base.translation_m());
  tiles_ = std::make_unique<Tiles>(machine_.mapping, origin_m, folder);
}

void RunSurface::add(const PlacedSurface& placed) {
  if (placed.trust != PoseTrust::trusted) {
    ++counts_.not_mapped[static_cast<std::size_t>(placed.trust)];
    return;
  }
  ++counts_.mapped;
  counts_.left_out += placed.left_out;
  tiles_->tiles().add(placed.scan);
}

void RunSurface::finish(const OutputFolder& output, RunFiles& files, RunSummary& summary) {
  summary.notes.insert(summary.notes.end(), notes_.begin(), notes_.end());
  if (!is_on()) {
    return;
  }
  tiles_->tiles().finish();
  const SurfaceFolder& map = tiles_->folder();
  const SurfaceTileCounts& tiles = tiles_->tiles().counts();
  counts_.points = tiles.points;
  counts_.left_out += tiles.left_out;
  counts_.moved = tiles.moved;
  counts_.voxels = map.points();
  counts_.tiles = map.index().tiles.size();
  const Eigen::Vector3d& origin_m = map.index().frame.origin_m;
  counts_.origin_m = {origin_m.x(), origin_m.y(), origin_m.z()};
  files.emplace_back("surface", std::string(kFolder) + "/" + SurfaceFolder::kIndex);
  write_surface_cloud(output / "map.pcd", map);
  files.emplace_back("map", "map.pcd");
  std::string problem;
  const auto elevation = write_elevation(output / "", map, machine_.mapping.cell_m, poses_->datum,
                                         terrain_ ? &*terrain_ : nullptr, problem);
  if (!elevation) {
    summary.notes.push_back("no elevation raster was written: " + problem);
  } else {
    for (const std::string& name : elevation->files) {
      files.emplace_back(fs::path(name).stem().string(), name);
    }
    counts_.elevation_cells = elevation->cells;
    counts_.depth_cells = elevation->depth_cells;
    counts_.median_depth_m = elevation->median_depth_m;
    if (terrain_ && elevation->depth_cells == 0) {
      summary.notes.emplace_back("the terrain model does not lie under the map: there is no snow depth");
    }
  }
  summary.surface = counts_;
}

}  // namespace berm
