#pragma once

#include <cstdint>
#include <string>

namespace berm {

/// Reading a file never takes more than 4 times its size plus 64 MiB, whatever its counts claim. Throws
/// FileError(unsupported) if `needed_bytes`, the file itself included, are more than that.
void check_memory(const std::string& name, std::uint64_t file_bytes, std::uint64_t needed_bytes);

}  // namespace berm
