#include "memory_limit.hpp"

#include <optional>

#include <fmt/format.h>

#include "berm/core/error.hpp"

namespace berm {

void check_memory(const std::string& name, std::uint64_t file_bytes, std::uint64_t needed_bytes) {
  constexpr std::uint64_t kMebibyte = std::uint64_t{1} << 20U;
  const std::uint64_t allowed_bytes = 4 * file_bytes + 64 * kMebibyte;
  if (needed_bytes > allowed_bytes) {
    throw FileError(
        ErrorCode::unsupported, name, std::nullopt,
        fmt::format("would need {} MiB of memory for a file of {} MiB, more than the allowed 4 times the file "
                    "plus 64 MiB; convert it to uncompressed binary with fields of type F4",
                    needed_bytes / kMebibyte, file_bytes / kMebibyte));
  }
}

}  // namespace berm
