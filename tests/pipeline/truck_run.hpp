#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "berm/io/edge_lines_file.hpp"
#include "berm/map/edge_map.hpp"
#include "berm/pipeline/run.hpp"
#include "support/temp_folder.hpp"
#include "truck_recording.hpp"

namespace berm::test {

/// A run over a recording of a truck. The scans are made once for all tests.
class TruckRunTest : public ::testing::Test {
 protected:
  static constexpr std::size_t kScans = 20;

  static void SetUpTestSuite() {
    scans_ = std::make_unique<TempFolder>();
    make_truck_recording(scans_->path(), {.scans = kScans});
  }
  static void TearDownTestSuite() { scans_.reset(); }

  void SetUp() override {
    std::filesystem::create_directory(recording_);
    std::filesystem::create_directory_symlink(*scans_ / "scans", recording_ / "scans");
    std::filesystem::copy_file(*scans_ / "times.txt", recording_ / "times.txt");
  }

  /// Stamps of the scans from `start_ns` on.
  void start_at(Stamp start_ns) {
    drive_.start_ns = start_ns;
    std::string times;
    for (std::size_t i = 0; i < kScans; ++i) {
      times += std::to_string(to_seconds(start_ns) + 0.1 * static_cast<double>(i)) + "\n";
    }
    spill(recording_ / "times.txt", times);
  }

  /// The poses of the drive, moved by `move(stamp_ns)`, but those for which it gives nothing.
  template <typename Move>
  [[nodiscard]] Trajectory poses_moved(Move&& move) const {
    const Trajectory all = drive_.poses();
    Trajectory some;
    for (const StampedPose& pose : all.poses()) {
      if (const std::optional<Eigen::Vector3d> by_m = move(pose.stamp_ns)) {
        some.append(pose.stamp_ns, Pose(Eigen::Quaterniond::Identity(), *by_m) * pose.T_world_base);
      }
    }
    return some;
  }
  template <typename Keep>
  [[nodiscard]] Trajectory poses_where(Keep&& keep) const {
    return poses_moved([&keep](Stamp stamp_ns) {
      return keep(stamp_ns) ? std::optional<Eigen::Vector3d>(Eigen::Vector3d::Zero()) : std::nullopt;
    });
  }
  void put_poses(const Trajectory& poses) const { spill(recording_ / "gnss.tum", as_tum(poses)); }

  RunSummary run_it(RunOptions options = {}) const {
    if (options.output.empty()) {
      options.output = out_;
    }
    return run(Recording::open(recording_), machine_, options);
  }

  [[nodiscard]] nlohmann::json report() const { return nlohmann::json::parse(slurp(out_ / "run.json")); }
  [[nodiscard]] EdgeMap map() const { return map_in(out_); }
  [[nodiscard]] EdgeMap map_in(const std::filesystem::path& folder) const {
    return EdgeMap::from_octomap(slurp(folder / "edges.ot"), "edges.ot", machine_.map);
  }
  [[nodiscard]] std::vector<EdgeLine> lines() const { return read_edge_lines(out_ / "edges.csv"); }

  /// Every vertex lies at the toe of the berm of its side, and there are vertices on both sides. How exact lines are is
  /// for others to test: here they are to be in the right place of the world.
  void expect_on_berms(const std::vector<EdgeLine>& lines) const {
    constexpr double kTolerance_m = 0.4;
    std::size_t vertices[2] = {};
    std::size_t off = 0;
    for (const EdgeLine& line : lines) {
      const double toe_m = line.side == EdgeSide::left ? TruckDrive::kHalfWidth_m : -TruckDrive::kHalfWidth_m;
      for (const EdgeLine::Vertex& vertex : line.vertices) {
        off += std::abs(drive_.offset_m(vertex.position_m) - toe_m) < kTolerance_m ? 0U : 1U;
        ++vertices[static_cast<std::size_t>(line.side)];
      }
    }
    EXPECT_EQ(off, 0U);
    EXPECT_GT(vertices[0], 10U);
    EXPECT_GT(vertices[1], 10U);
  }

  /// How far off the path voxels of the map lie. m.
  [[nodiscard]] double farthest_off_m() const {
    double farthest_m = 0.0;
    const EdgeMap found = map();
    found.for_each([&](const VoxelKey& key, const EdgeVoxel&) {
      const Eigen::Vector3d place_m = machine_.map.voxel_m * Eigen::Vector3d(key.x, key.y, key.z);
      farthest_m = std::max(farthest_m, std::abs(drive_.offset_m(place_m)));
    });
    return farthest_m;
  }

  static inline std::unique_ptr<TempFolder> scans_;
  TempFolder folder_;
  std::filesystem::path recording_ = folder_ / "recording";
  std::filesystem::path out_ = folder_ / "out";
  TruckDrive drive_{.scans = kScans};
  Machine machine_ = haul_truck();
};

}  // namespace berm::test
