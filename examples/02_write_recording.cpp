// Writes a sequence folder: scans as PCD, times, and poses of the machine. Such a folder is what `berm run` reads.
// usage: 02_write_recording FOLDER

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/pcd.hpp"
#include "berm/io/trajectory_file.hpp"

namespace {

constexpr int kScans = 3;
constexpr double kPeriod_s = 0.1;
constexpr double kSpeed_m_s = 5.0;
constexpr double kSensorHeight_m = 1.73;

// Flat ground under a spinning sensor, one ring after the other, with intensity and ring.
berm::PointCloud made_scan() {
  berm::PointChannels channels;
  for (int ring = 0; ring < 40; ++ring) {
    const double range_m = 4.0 + ring;
    for (int column = 0; column < 360; ++column) {
      const double azimuth_rad = column * std::numbers::pi / 180.0;
      channels.x.push_back(static_cast<float>(range_m * std::cos(azimuth_rad)));
      channels.y.push_back(static_cast<float>(range_m * std::sin(azimuth_rad)));
      channels.z.push_back(static_cast<float>(-kSensorHeight_m));
      channels.intensity.push_back(100.0F);
      channels.ring.push_back(static_cast<std::uint16_t>(ring));
    }
  }
  return berm::PointCloud(std::move(channels));
}

void write_recording(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "scans");
  const berm::PointCloud cloud = made_scan();
  berm::Trajectory trajectory;
  std::string times;
  for (int i = 0; i < kScans; ++i) {
    berm::write_pcd(folder / "scans" / ("00000" + std::to_string(i) + ".pcd"), cloud.view());
    const double time_s = i * kPeriod_s;
    times += std::to_string(time_s) + "\n";
    trajectory.append(berm::from_seconds(time_s),
                      berm::Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {kSpeed_m_s * time_s, 0.0, 0.0}));
  }
  berm::write_file_atomically(folder / "times.txt", times);
  berm::write_tum(folder / "gnss.tum", trajectory);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
    return 2;
  }
  try {
    write_recording(argv[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  std::printf("%d scans in %s\n", kScans, argv[1]);
  return 0;
}
