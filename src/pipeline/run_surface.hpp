#pragma once

#include <memory>
#include <optional>
#include <span>

#include "berm/core/label.hpp"
#include "berm/core/pose_guard.hpp"
#include "berm/core/scan.hpp"
#include "berm/io/output_folder.hpp"
#include "berm/io/terrain_model.hpp"
#include "berm/map/surface_tiles.hpp"
#include "berm/pipeline/machine.hpp"
#include "berm/pipeline/run.hpp"
#include "run_poses.hpp"
#include "run_report.hpp"
#include "surface_placing.hpp"

namespace berm {

/// The map of the surface in a run: OUT/map while it goes on, map.pcd and the elevation raster at its end.
class RunSurface {
 public:
  /// Nothing is mapped unless `mapping.surface` is set and there are poses, which is noted. `poses` must outlive this.
  /// Throws FileError as `TerrainModel::read`: what speaks against a run is found out before it.
  RunSurface(const Machine& machine, const RunOptions& options, const RunPoses* poses);
  RunSurface(const RunSurface&) = delete;
  RunSurface& operator=(const RunSurface&) = delete;
  ~RunSurface();

  /// For a recording without poses, once the odometry has told them. As the constructor.
  void use(const RunPoses& poses);
  [[nodiscard]] bool is_on() const { return poses_ != nullptr; }

  /// Takes a scan to the world. For any thread: writes to `placed` alone. Only if it is on, as all below.
  void place(const Scan& scan, std::span<const Label> labels, PlacedSurface& placed) const;
  /// Starts OUT/map. Throws FileError(write_failed).
  void open(const OutputFolder& output);
  /// For one thread, in the order of scans. Throws FileError as SurfaceFolder.
  void add(const PlacedSurface& placed);
  /// Writes what is left of the map, and what is made of it; completes `summary` and `files`.
  void finish(const OutputFolder& output, RunFiles& files, RunSummary& summary);

 private:
  class Tiles;

  const Machine& machine_;
  const RunOptions& options_;
  const RunPoses* poses_ = nullptr;
  PoseGuard guard_;
  std::optional<TerrainModel> terrain_;
  std::unique_ptr<Tiles> tiles_;
  SurfaceCounts counts_;
  std::vector<std::string> notes_;
};

}  // namespace berm
