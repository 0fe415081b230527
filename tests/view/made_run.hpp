#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "berm/core/label.hpp"
#include "berm/core/stamp.hpp"
#include "berm/core/trajectory.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/trajectory_file.hpp"
#include "support/made_recording.hpp"
#include "support/temp_folder.hpp"

namespace berm::test {

inline constexpr std::size_t kMadeScans = 4;
inline constexpr std::size_t kMadePoints = 700;  ///< 600 of them returns
inline constexpr std::size_t kMadeReturns = 600;

/// FOLDER/recording and FOLDER/out, a run of its scans but the first: all points obstacles, the machine 2 m farther
/// along x in every scan, the last scan skipped.
inline void make_run(const std::filesystem::path& folder, const Eigen::Vector3d& start_m = Eigen::Vector3d::Zero()) {
  make_recording(folder / "recording", kMadeScans, kMadePoints);
  std::filesystem::create_directories(folder / "out" / "labels");
  std::string table = "scan,stamp,points,returns,degraded\n";
  Trajectory trajectory;
  for (std::size_t i = 1; i < kMadeScans; ++i) {
    const auto shift_m = static_cast<double>(2 * (i - 1));
    const Eigen::Vector3d position_m = start_m + Eigen::Vector3d(shift_m, 0.0, 0.0);
    trajectory.append(static_cast<Stamp>(i) * 100'000'000, Pose(Eigen::Quaterniond::Identity(), position_m));
    if (i + 1 < kMadeScans) {
      write_labels(folder / "out" / "labels" / (scan_name(i) + ".label"),
                   std::vector<Label>(kMadePoints, Label::obstacle));
      table += scan_name(i) + ",0.1," + std::to_string(kMadePoints) + ",600," + (i == 2 ? "no_intensity" : "") + "\n";
    }
  }
  write_tum(folder / "out" / "trajectory.tum", trajectory);
  spill(folder / "out" / "scans.csv", table);
  spill(folder / "out" / "run.json", R"({"schema": "berm.run/2",
    "recording": {"path": "recording", "first": 1, "scans": 4}, "counts": {"scans": {"selected": 3}},
    "machine": {"machine": {"name": "car <b>"}, "sensor": {"model": "made"}, "methods": {"piste": "default"},
                "mount": {"height_m": 1.5, "pitch_deg": 0, "roll_deg": 0, "yaw_deg": 0, "x_m": 0, "y_m": 0}}})");
  spill(folder / "out" / "edges.csv",
        "line,side,x,y,z,confidence\n0,left,1,2,0.5,0.75\n0,left,2,2,0.5,1\n1,right,1,-2,0,0.5\n1,right,2,-2,0,0.5\n");
}

}  // namespace berm::test
