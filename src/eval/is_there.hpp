#pragma once

#include <filesystem>
#include <system_error>

namespace berm {

/// Whether there is a file or folder of this name; what cannot be looked at is not there.
inline bool is_there(const std::filesystem::path& path) {
  std::error_code code;
  return std::filesystem::exists(path, code);
}

}  // namespace berm
