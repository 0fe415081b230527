#include <cmath>
#include <sstream>
#include <string>

#include "berm/core/pose_guard.hpp"
#include "berm/io/pose_log.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    std::istringstream input(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    const berm::PoseLog log = berm::read_pose_csv(input, "poses.csv", {}, {}, {});
    berm::test::demand(!log.trajectory.empty());
    for (const berm::StampedPose& pose : log.trajectory.poses()) {
      berm::test::demand(pose.T_world_base.translation_m().allFinite());
      berm::test::demand(std::abs(pose.T_world_base.rotation().norm() - 1.0) < 1e-9);
    }
    const berm::PoseGuard guard(log.trajectory, {}, log.poor_fix_stamps);
    berm::test::demand(guard.jumps() < log.trajectory.size());
  });
}
