#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string_view>

namespace berm {

/// Memory for whole files, kept from one file to the next.
class FileBuffer {
 public:
  /// What was read last.
  [[nodiscard]] std::span<const std::byte> bytes() const { return {memory_.get(), size_}; }
  /// The same as text.
  [[nodiscard]] std::string_view text() const;

  /// Memory for `size` bytes, their values unspecified.
  [[nodiscard]] std::span<std::byte> prepare(std::size_t size);

 private:
  std::unique_ptr<std::byte[]> memory_;
  std::size_t capacity_ = 0;
  std::size_t size_ = 0;
};

/// Larger files are refused: no single scan or table is near it.
constexpr std::uint64_t kMaxFileBytes = std::uint64_t{4} << 30U;

/// Reads the whole regular file `path` into `buffer`; the result is valid until the buffer is used again or dies.
/// Throws FileError: not_found; unreadable (no permission, a folder, a pipe or device, an error of the disk);
/// truncated (the file shrank meanwhile); unsupported (larger than `max_bytes`). Never waits for a pipe.
std::span<const std::byte> read_file(const std::filesystem::path& path, FileBuffer& buffer,
                                     std::uint64_t max_bytes = kMaxFileBytes);

}  // namespace berm
