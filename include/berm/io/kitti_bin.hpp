#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "berm/core/point_cloud.hpp"
#include "berm/io/scan_record.hpp"

namespace berm {

/// Unit of the intensities in a KITTI `.bin` file; the file itself does not say.
enum class IntensityScale : std::uint8_t {
  unit,  ///< 0..1, multiplied by 255 while reading
  byte,  ///< 0..255, taken as it is
};

/// What raw intensities (read with `IntensityScale::byte`) say about their unit: a value above 1 means byte, otherwise
/// a value strictly between 0 and 1 means unit; nothing where there are but zeros, ones and NaN. Decide once for a
/// recording, so that a dark scan does not change the unit.
[[nodiscard]] std::optional<IntensityScale> recognise_intensity_scale(std::span<const float> intensity);

/// Reads 4 x f32 (x y z intensity) per point, no header. Throws FileError as `read_file`, and truncated where the size
/// is no multiple of 16. `reuse` gives its memory to the result.
[[nodiscard]] ScanRecord read_kitti_bin(const std::filesystem::path& path, IntensityScale scale,
                                        PointChannels reuse = {});

/// The same from memory; `name` stands for the file in errors.
[[nodiscard]] ScanRecord parse_kitti_bin(std::span<const std::byte> bytes, const std::string& name,
                                         IntensityScale scale, PointChannels reuse = {});

/// Writes x y z intensity as they are in `points` (intensity 0..255, 0 where absent) in the unit `scale`. Throws
/// Error(invalid_argument) if channels differ in length, FileError(write_failed) as AtomicFile.
void write_kitti_bin(const std::filesystem::path& path, const PointsView& points, IntensityScale scale);

}  // namespace berm
