#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include <gtest/gtest.h>

namespace berm::test {

/// Folder of real recordings: $BERM_DATA, else `shared/data` beside the repository. Not checked for existence.
[[nodiscard]] inline std::filesystem::path data_folder() {
  if (const char* folder = std::getenv("BERM_DATA"); folder != nullptr && *folder != '\0') {
    return folder;
  }
  const std::filesystem::path repository = std::filesystem::path(__FILE__).parent_path().parent_path().parent_path();
  return repository.parent_path() / "shared" / "data";
}

/// The recording or file `name` below `data_folder()`, none if it is not there.
[[nodiscard]] inline std::optional<std::filesystem::path> find_data(const std::string& name) {
  std::error_code error;
  const std::filesystem::path path = data_folder() / name;
  return std::filesystem::exists(path, error) ? std::optional(path) : std::nullopt;
}

/// Whether a missing recording is a failure (as in CI) instead of a skipped test: $BERM_REQUIRE_DATA=1.
[[nodiscard]] inline bool data_is_required() {
  const char* value = std::getenv("BERM_REQUIRE_DATA");
  return value != nullptr && std::string(value) == "1";
}

}  // namespace berm::test

/// First line of a test that needs the real recording `name`: defines its path as `variable`, or skips (or, with
/// BERM_REQUIRE_DATA=1, fails).
#define BERM_NEED_DATA(variable, name)                                                             \
  const std::optional<std::filesystem::path> variable##_found = ::berm::test::find_data(name);     \
  if (!variable##_found) {                                                                         \
    if (::berm::test::data_is_required()) {                                                        \
      FAIL() << "recording '" << (name) << "' is not in " << ::berm::test::data_folder()           \
             << " and BERM_REQUIRE_DATA=1 asks for it; set BERM_DATA to the folder that holds it"; \
    }                                                                                              \
    GTEST_SKIP() << "recording '" << (name) << "' is not in " << ::berm::test::data_folder()       \
                 << "; set BERM_DATA to the folder that holds it";                                 \
  }                                                                                                \
  const std::filesystem::path variable = *variable##_found
