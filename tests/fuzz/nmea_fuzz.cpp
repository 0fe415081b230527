#include <string_view>

#include "berm/core/pose_guard.hpp"
#include "berm/io/pose_log.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    berm::PoseLogConfig any;
    any.fix = "any";
    const berm::PoseLog log = berm::parse_nmea(text, "log.nmea", any, {}, {});
    berm::test::demand(!log.trajectory.empty() && log.datum.has_value());
    for (const berm::StampedPose& pose : log.trajectory.poses()) {
      berm::test::demand(pose.T_world_base.translation_m().allFinite());
    }
    const berm::PoseGuard guard(log.trajectory, {}, log.poor_fix_stamps);
    berm::test::demand(guard.jumps() < log.trajectory.size());
  });
}
