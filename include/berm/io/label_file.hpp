#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "berm/core/label.hpp"

namespace berm {

/// Class of a SemanticKITTI label as it is on disk.
[[nodiscard]] constexpr std::uint32_t semantic_class(std::uint32_t raw) {
  return raw & 0xFFFFU;
}
/// Instance of a SemanticKITTI label as it is on disk; 0 where none.
[[nodiscard]] constexpr std::uint32_t semantic_instance(std::uint32_t raw) {
  return raw >> 16U;
}

/// What berm makes of a SemanticKITTI label of any origin: what vehicles drive on is drivable, other ground is terrain,
/// 0 and 1 (outlier) are unlabeled, 110 is falling snow, everything else an obstacle.
[[nodiscard]] Label to_label(std::uint32_t raw);

/// Reads a SemanticKITTI `.label` file: one u32 per point, low 16 bits class, high 16 instance. Throws FileError as
/// `read_file`, truncated where the size is no multiple of 4, malformed (with both numbers) where there are not
/// `expected_points` of them; `nullopt` takes any number.
[[nodiscard]] std::vector<std::uint32_t> read_labels(const std::filesystem::path& path,
                                                     std::optional<std::size_t> expected_points);

/// The same from memory; `name` stands for the file in errors.
[[nodiscard]] std::vector<std::uint32_t> parse_labels(std::span<const std::byte> bytes, const std::string& name,
                                                      std::optional<std::size_t> expected_points);

/// Writes one u32 per point, `semantic_kitti_id` of each label. Throws FileError(write_failed) as AtomicFile.
void write_labels(const std::filesystem::path& path, std::span<const Label> labels);
/// Writes labels as they are.
void write_labels(const std::filesystem::path& path, std::span<const std::uint32_t> raw);

}  // namespace berm
