#include "berm/io/kitti_bin.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/file_reader.hpp"
#include "little_endian.hpp"
#include "points_check.hpp"

namespace berm {
namespace {

constexpr std::size_t kKittiPointBytes = 4 * sizeof(float);
constexpr float kByteFromUnit = 255.0F;
constexpr std::size_t kKittiBlockPoints = 4096;

}  // namespace

std::optional<IntensityScale> recognise_intensity_scale(std::span<const float> intensity) {
  bool fraction = false;
  for (const float value : intensity) {
    if (value > 1.0F) {
      return IntensityScale::byte;
    }
    fraction |= value > 0.0F && value < 1.0F;
  }
  return fraction ? std::optional(IntensityScale::unit) : std::nullopt;
}

ScanRecord parse_kitti_bin(std::span<const std::byte> bytes, const std::string& name, IntensityScale scale,
                           PointChannels reuse) {
  if (bytes.size() % kKittiPointBytes != 0) {
    throw FileError(
        ErrorCode::truncated, name, bytes.size() - bytes.size() % kKittiPointBytes,
        fmt::format("{} bytes left for a point of 16 (x y z intensity as f32): the file is cut, or it is no "
                    "KITTI scan; copy it again or convert it",
                    bytes.size() % kKittiPointBytes));
  }
  const std::size_t points = bytes.size() / kKittiPointBytes;
  const float factor = scale == IntensityScale::unit ? kByteFromUnit : 1.0F;
  ScanRecord record;
  record.channels = std::move(reuse);
  PointChannels& channels = record.channels;
  channels.time.clear();
  channels.ring.clear();
  channels.label.clear();
  channels.x.resize(points);
  channels.y.resize(points);
  channels.z.resize(points);
  channels.intensity.resize(points);
  for (std::size_t i = 0; i < points; ++i) {
    const auto point = load<std::array<float, 4>>(bytes.data() + i * kKittiPointBytes);
    channels.x[i] = point[0];
    channels.y[i] = point[1];
    channels.z[i] = point[2];
    channels.intensity[i] = point[3] * factor;
  }
  record.fields = {"x", "y", "z", "intensity"};
  record.notes.emplace_back(scale == IntensityScale::unit ? "intensity 0..1 was multiplied by 255"
                                                          : "intensity was taken as 0..255");
  return record;
}

ScanRecord read_kitti_bin(const std::filesystem::path& path, IntensityScale scale, PointChannels reuse) {
  FileBuffer buffer;
  return parse_kitti_bin(read_file(path, buffer), path.string(), scale, std::move(reuse));
}

void write_kitti_bin(const std::filesystem::path& path, const PointsView& points, IntensityScale scale) {
  check_channels(points);
  const float factor = scale == IntensityScale::unit ? 1.0F / kByteFromUnit : 1.0F;
  AtomicFile file(path);
  std::vector<float> block;
  block.reserve(4 * kKittiBlockPoints);
  for (std::size_t begin = 0; begin < points.size(); begin += kKittiBlockPoints) {
    const std::size_t end = std::min(begin + kKittiBlockPoints, points.size());
    block.clear();
    for (std::size_t i = begin; i < end; ++i) {
      const float intensity = points.intensity.empty() ? 0.0F : points.intensity[i] * factor;
      block.insert(block.end(), {points.x[i], points.y[i], points.z[i], intensity});
    }
    file.write(std::as_bytes(std::span<const float>(block)));
  }
  file.commit();
}

}  // namespace berm
