#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>

#include "berm/core/point_cloud.hpp"
#include "berm/io/pcd.hpp"

namespace berm::test {

/// A bumpy plain with a wall ahead, a little different for every `scan`; one beam in seven does not return.
[[nodiscard]] inline PointCloud made_cloud(std::size_t scan, std::size_t points) {
  PointChannels channels;
  for (std::size_t i = 0; i < points; ++i) {
    const bool returns = i % 7 != 6;
    const auto column = static_cast<float>(i % 97);
    const auto row = static_cast<float>(i / 97 % 31);
    const float bump = 0.02F * static_cast<float>((i * 31 + scan * 17) % 5);
    const bool wall = i % 11 == 0;
    channels.x.push_back(returns ? 3.0F + row : 0.0F);
    channels.y.push_back(returns ? 0.3F * (column - 48.0F) : 0.0F);
    channels.z.push_back(returns ? (wall ? 0.5F : -1.7F + bump) : 0.0F);
    channels.intensity.push_back(static_cast<float>(i % 256));
  }
  return PointCloud(std::move(channels));
}

[[nodiscard]] inline std::string scan_name(std::size_t index) {
  const std::string digits = std::to_string(index);
  return std::string(6 - digits.size(), '0') + digits;
}

/// A sequence folder of `scans` scans without any of the optional files.
inline void make_recording(const std::filesystem::path& folder, std::size_t scans, std::size_t points = 500) {
  std::filesystem::create_directories(folder / "scans");
  for (std::size_t i = 0; i < scans; ++i) {
    write_pcd(folder / "scans" / (scan_name(i) + ".pcd"), made_cloud(i, points).view());
  }
}

}  // namespace berm::test
