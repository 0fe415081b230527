#include <cmath>
#include <sstream>
#include <string>

#include "berm/io/trajectory_file.hpp"
#include "fuzz_parser.hpp"

namespace {

void demand_rigid(const berm::Pose& pose) {
  berm::test::demand(std::abs(pose.rotation().norm() - 1.0) < 1e-9);
  berm::test::demand(pose.translation_m().cwiseAbs().maxCoeff() <= berm::kMaxCoordinate_m);
}

}  // namespace

/// The first byte chooses the format.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    if (bytes.empty()) {
      return;
    }
    const std::string text(reinterpret_cast<const char*>(bytes.data()) + 1, bytes.size() - 1);
    std::istringstream input(text);
    switch (static_cast<char>(bytes.front())) {
      case 't': {
        const berm::Trajectory trajectory = berm::read_tum(input, "path.tum");
        for (const berm::StampedPose& pose : trajectory.poses()) {
          demand_rigid(pose.T_world_base);
        }
        break;
      }
      case 'k':
        for (const berm::Pose& pose : berm::read_kitti_poses(input, "poses.txt")) {
          demand_rigid(pose);
        }
        break;
      default:
        demand_rigid(berm::read_kitti_calibration(input, "calib.txt"));
    }
  });
}
