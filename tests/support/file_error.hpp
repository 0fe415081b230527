#pragma once

#include <string>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"

namespace berm::test {

/// Expects `body` to throw a FileError with `code` whose message contains `part`.
template <typename Body>
void expect_file_error(ErrorCode code, const std::string& part, Body&& body) {
  try {
    body();
  } catch (const FileError& error) {
    EXPECT_EQ(static_cast<int>(error.code()), static_cast<int>(code)) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos)
        << "'" << part << "' is not in: " << error.what();
    return;
  }
  ADD_FAILURE() << "no FileError, expected one that says '" << part << "'";
}

}  // namespace berm::test
