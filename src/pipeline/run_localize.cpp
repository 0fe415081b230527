#include "run_localize.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <system_error>
#include <utility>

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/surface_folder.hpp"
#include "berm/io/trajectory_file.hpp"
#include "scan_table.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

/// A plane needs eight points of a voxel of the matching: of a map three times as fine, there are nine.
constexpr double kVoxelsPerSide = 3.0;
/// Tiles as `mapping.tile_m` allows.
constexpr double kSmallestTile_m = 1.0;
constexpr double kLargestTile_m = 500.0;
/// Bytes of a point in a tile at least: what the file of a tile must hold.
constexpr std::uint64_t kLeastPointBytes = 24;
/// Broken tiles that are named.
constexpr std::size_t kNamedTiles = 5;

/// MAP may be the folder of a run, its folder `map`, or the index in it.
fs::path tile_folder(const fs::path& map) {
  std::error_code code;
  for (const fs::path& folder : {map, map / "map", map.parent_path()}) {
    if (fs::is_regular_file(folder / SurfaceFolder::kIndex, code) &&
        (folder != map.parent_path() || map.filename() == SurfaceFolder::kIndex)) {
      return folder;
    }
  }
  throw FileError(ErrorCode::not_found, map.string(), std::nullopt,
                  "holds no map of a surface: expected the folder of a run with --map-surface, or its folder map with "
                  "tiles.json");
}

double most_sigma(const Eigen::Matrix3d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, axes.eigenvalues()[2]));
}

bool is_located(const MapPose& pose) {
  return pose.health == OdometryHealth::good || pose.health == OdometryHealth::weak;
}

/// The pose at the first scan, or the first after it.
std::optional<Pose> first_pose(const Recording& recording, const RunOptions& options, const RunPoses* poses) {
  if (poses == nullptr || poses->trajectory.empty()) {
    return std::nullopt;
  }
  const Stamp stamp_ns = recording.scan(options.first).stamp_ns;
  if (const auto pose = poses->trajectory.at(stamp_ns)) {
    return pose;
  }
  for (const StampedPose& pose : poses->trajectory.poses()) {
    if (pose.stamp_ns >= stamp_ns) {
      return pose.T_world_base;
    }
  }
  return std::nullopt;
}

}  // namespace

/// The tiles on the disk. One that turns out to be broken is left out: the run goes on, and says so.
class RunLocalize::Tiles final : public MapTileSource {
 public:
  explicit Tiles(const fs::path& path) : path_(tile_folder(path)), folder_(SurfaceFolder::open(path_)) {}

  [[nodiscard]] double tile_m() const override { return folder_.index().frame.tile_m; }
  [[nodiscard]] Eigen::Vector3d origin_m() const override { return folder_.index().frame.origin_m; }
  [[nodiscard]] bool has(const TileKey& key) const override { return folder_.index().tiles.contains(key); }
  [[nodiscard]] std::vector<SurfacePoint> load(const TileKey& key) override {
    try {
      return folder_.load(key);
    } catch (const FileError& error) {
      broken_.insert(error.what());
      return {};
    }
  }

  /// Throws FileError for what a look at the folder tells.
  void check(double coarse_voxel_m) const {
    const std::string index = (path_ / SurfaceFolder::kIndex).string();
    const SurfaceFrame& frame = folder_.index().frame;
    const auto refuse = [](const std::string& file, const std::string& problem, ErrorCode code) {
      throw FileError(code, file, std::nullopt, problem);
    };
    if (folder_.index().tiles.empty()) {
      refuse(index, "the map has no tiles", ErrorCode::malformed);
    }
    if (!(frame.tile_m >= kSmallestTile_m && frame.tile_m <= kLargestTile_m)) {
      refuse(index, fmt::format("tiles of {} m, expected {} to {}", frame.tile_m, kSmallestTile_m, kLargestTile_m),
             ErrorCode::malformed);
    }
    if (kVoxelsPerSide * frame.voxel_m > coarse_voxel_m) {
      refuse(index,
             fmt::format("voxels of {} m are too coarse to find surfaces in, expected at most {} m (a third of "
                         "odometry.coarse_voxel_m): make the map with a smaller mapping.voxel_m",
                         frame.voxel_m, coarse_voxel_m / kVoxelsPerSide),
             ErrorCode::malformed);
    }
    for (const auto& [key, entry] : folder_.index().tiles) {
      const fs::path file = path_ / entry.file;
      std::error_code code;
      const std::uint64_t bytes = fs::file_size(file, code);
      if (code) {
        refuse(file.string(), "is named in tiles.json and cannot be read: " + code.message(), ErrorCode::not_found);
      }
      if (bytes / kLeastPointBytes < entry.points) {
        refuse(file.string(), fmt::format("holds {} bytes, too few for its {} points", bytes, entry.points),
               ErrorCode::truncated);
      }
    }
  }

  /// What is wrong with the tiles that could not be read.
  [[nodiscard]] const std::set<std::string>& broken() const { return broken_; }

 private:
  fs::path path_;
  SurfaceFolder folder_;
  std::set<std::string> broken_;
};

RunLocalize::RunLocalize(const Recording& recording, const Machine& machine, const RunOptions& options,
                         const RunPoses* poses) {
  if (options.localize.empty()) {
    return;
  }
  if (machine.methods.odometry == "none") {
    throw Error(ErrorCode::invalid_argument, "--localize needs an odometry: --method odometry=default");
  }
  const auto start = options.start ? options.start : first_pose(recording, options, poses);
  if (!start) {
    throw Error(ErrorCode::invalid_argument,
                "--localize needs to know where to look for the machine, since the recording brings no poses: --start "
                "X,Y,YAW in metres and degrees, in the frame of the map");
  }
  map_ = options.localize.string();
  tiles_ = std::make_unique<Tiles>(options.localize);
  tiles_->check(machine.odometry.coarse_voxel_m);
  localizer_ = std::make_unique<MapLocalizer>(machine.localize, machine.odometry, *tiles_);
  const bool has_ground = localizer_->start(*start);
  if (!tiles_->broken().empty()) {
    throw Error(ErrorCode::malformed, *tiles_->broken().begin());
  }
  if (!has_ground) {
    const Eigen::Vector3d& place_m = start->translation_m();
    throw Error(
        ErrorCode::invalid_argument,
        fmt::format("the map {} holds no ground near the start at {:.1f}, {:.1f}: is it in the frame of the map?", map_,
                    place_m.x(), place_m.y()));
  }
}

RunLocalize::~RunLocalize() = default;

void RunLocalize::add(const std::string& name, const Scan& scan, std::span<const Label> labels,
                      const OdometryResult& odometry) {
  const OdometryInput input{
      .points = scan.cloud.view(), .labels = labels, .stamp_ns = scan.stamp_ns, .T_base_sensor = scan.T_base_sensor};
  rows_.push_back({name, scan.stamp_ns, localizer_->process(input, odometry)});
}

LocalizationCounts RunLocalize::count() const {
  LocalizationCounts counts{.map = map_, .scans = rows_.size(), .broken_tiles = tiles_->broken().size()};
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const MapPose& pose = rows_[i].pose;
    ++counts.health[static_cast<std::size_t>(pose.health)];
    counts.most_tiles = std::max(counts.most_tiles, pose.tiles);
    if (is_located(pose)) {
      ++counts.located;
      counts.mean_ground_fit += pose.ground_fit;
      if (!counts.first_s) {
        counts.first_s = to_seconds(rows_[i].stamp_ns - rows_.front().stamp_ns);
      }
    }
  }
  counts.mean_ground_fit /= static_cast<double>(std::max<std::size_t>(1, counts.located));
  return counts;
}

void RunLocalize::write_table(const OutputFolder& output) const {
  AtomicFile file(output / "localization.csv");
  file.write("scan,stamp,health,ground_fit,standing_fit,weakest,sigma_m,sigma_rad,samples,places,tiles\n");
  for (const Row& row : rows_) {
    const MapPose& pose = row.pose;
    file.write(fmt::format("{},{},{},{:.4f},{:.4f},{:.4f},{:.6f},{:.7f},{},{},{}\n", csv_field(row.name),
                           stamp_field(row.stamp_ns), health_name(pose.health), pose.ground_fit, pose.standing_fit,
                           pose.weakest, most_sigma(pose.covariance.topLeftCorner<3, 3>()),
                           most_sigma(pose.covariance.bottomRightCorner<3, 3>()), pose.samples, pose.places,
                           pose.tiles));
  }
  file.commit();
}

void RunLocalize::write(const OutputFolder& output, RunFiles& files, RunSummary& summary) const {
  write_table(output);
  files.emplace_back("localization", "localization.csv");
  const LocalizationCounts& counts = summary.localization.emplace(count());
  Trajectory trajectory;
  for (const Row& row : rows_) {
    if (is_located(row.pose)) {
      trajectory.append(row.stamp_ns, row.pose.T_map_begin);
    }
  }
  if (trajectory.empty()) {
    summary.notes.push_back(
        fmt::format("the machine was never located in {}: is it the map of this place, and the start right but for "
                    "localize.start_radius_m and start_turn_deg?",
                    map_));
  } else {
    write_tum(output / "trajectory_map.tum", trajectory);
    files.emplace_back("trajectory_map", "trajectory_map.tum");
    if (counts.located < counts.scans) {
      summary.notes.push_back(fmt::format("{} of {} scans are not located in the map: see localization.csv",
                                          counts.scans - counts.located, counts.scans));
    }
  }
  std::size_t named = 0;
  for (const std::string& problem : tiles_->broken()) {
    if (++named <= kNamedTiles) {
      summary.notes.push_back("a tile of the map was left out: " + problem);
    }
  }
}

}  // namespace berm
