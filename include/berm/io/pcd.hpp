#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "berm/core/point_cloud.hpp"
#include "berm/io/scan_record.hpp"

namespace berm {

enum class PcdEncoding : std::uint8_t { ascii, binary, binary_compressed };

/// Reads a PCD file (versions 0.5 to 0.7, all encodings; fields in any order, of any type and COUNT).
///
/// - `x y z` in m, as they are: NaN, Inf and no-returns stay.
/// - `intensity` from `reflectivity`, `intensity` or `i`, the first that exists, taken as 0..255.
/// - `time` from `t` (u32 ns), `time` (float s), `offset_time` (u32 ns), all relative to the stamp of the scan, or
///   `timestamp` (f64 s or u64 ns, absolute): see docs/formats.md for every name and type. Absolute times become
///   seconds since the earliest point, whose time is `start_ns`. NaN marks a point whose time is not known.
/// - `ring` from `ring`, `line` or `channel`.
/// - `label` from `label`, SemanticKITTI ids; ids that `semantic_kitti_id` does not give become `unlabeled`.
///
/// A channel whose field is missing stays empty. `reuse` gives its memory to the result. Throws FileError: as
/// `read_file`; malformed or truncated where header and bytes contradict each other; unsupported where a field of
/// time spans more than 1 s, `x y z` are missing, or reading would need more than 4 times the file plus 64 MiB.
[[nodiscard]] ScanRecord read_pcd(const std::filesystem::path& path, PointChannels reuse = {});

/// The same from memory; `name` stands for the file in errors.
[[nodiscard]] ScanRecord parse_pcd(std::span<const std::byte> bytes, const std::string& name, PointChannels reuse = {});

/// Writes `points` with the fields `x y z intensity time` (F4), `ring` (U2), `label` (U4, SemanticKITTI ids), those
/// that are present. What is written reads back the same, but for no-return labels, which have no id of their own.
/// Throws Error(invalid_argument) if channels differ in length, FileError(write_failed) as AtomicFile.
void write_pcd(const std::filesystem::path& path, const PointsView& points, PcdEncoding encoding = PcdEncoding::binary);

}  // namespace berm
