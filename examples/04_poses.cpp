// Where was the machine at any time? Poses that come with a recording, interpolated on the motion between them.
// usage: 04_poses RECORDING

#include <cmath>
#include <cstdio>

#include "berm/core/error.hpp"
#include "berm/io/recording.hpp"

namespace {

int print_poses(const berm::Recording& recording) {
  const auto given = recording.read_given_poses();
  if (!given) {
    std::fprintf(stderr, "the recording holds no poses\n");
    return 1;
  }
  // T_target_source takes coordinates from source to target: frames can be read off the product.
  const berm::Pose T_base_sensor = berm::Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {0.0, 0.0, 1.73});
  for (std::size_t i = 0; i + 1 < recording.size(); ++i) {
    const berm::Stamp begin_ns = recording.scan(i).stamp_ns;
    const berm::Stamp middle_ns = begin_ns + (recording.scan(i + 1).stamp_ns - begin_ns) / 2;
    const auto T_world_base = given->trajectory.at(middle_ns);
    if (!T_world_base) {
      continue;  // outside the time of the poses there is no answer rather than a guess
    }
    const berm::Pose T_world_sensor = *T_world_base * T_base_sensor;
    const Eigen::Vector3d ahead_world = T_world_sensor * Eigen::Vector3d(10.0, 0.0, 0.0);
    std::printf("%.3f s: 10 m ahead of the sensor is (%.2f, %.2f, %.2f)\n", berm::to_seconds(middle_ns),
                ahead_world.x(), ahead_world.y(), ahead_world.z());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s RECORDING\n", argv[0]);
    return 2;
  }
  try {
    return print_poses(berm::Recording::open(argv[1]));
  } catch (const berm::Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
