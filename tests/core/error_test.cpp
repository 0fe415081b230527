#include "berm/core/error.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace berm {
namespace {

TEST(Error, KeepsCodeAndText) {
  const Error error(ErrorCode::invalid_argument, "what is wrong");
  EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
  EXPECT_STREQ(error.what(), "what is wrong");
}

TEST(FileError, NamesFileOffsetAndProblem) {
  const FileError error(ErrorCode::truncated, "a/b.pcd", 12, "expected 16 bytes, found 4");
  EXPECT_STREQ(error.what(), "a/b.pcd: at byte 12: expected 16 bytes, found 4");
  EXPECT_EQ(error.code(), ErrorCode::truncated);
  EXPECT_EQ(error.file(), "a/b.pcd");
  EXPECT_EQ(error.offset(), 12U);
}

TEST(FileError, LeavesTheOffsetOutWhereTheWholeFileIsMeant) {
  const FileError error(ErrorCode::not_found, "a.pcd", std::nullopt, "no such file");
  EXPECT_STREQ(error.what(), "a.pcd: no such file");
  EXPECT_FALSE(error.offset().has_value());
}

TEST(FileError, ShowsOffsetsAtBothEnds) {
  EXPECT_STREQ(FileError(ErrorCode::malformed, "f", 0, "p").what(), "f: at byte 0: p");
  EXPECT_STREQ(FileError(ErrorCode::malformed, "f", std::numeric_limits<std::uint64_t>::max(), "p").what(),
               "f: at byte 18446744073709551615: p");
}

TEST(ConfigError, NamesKeyAndProblem) {
  const ConfigError error("ground.cell_m", "-1 is not allowed");
  EXPECT_STREQ(error.what(), "ground.cell_m: -1 is not allowed");
  EXPECT_EQ(error.code(), ErrorCode::config);
  EXPECT_EQ(error.key(), "ground.cell_m");
  EXPECT_EQ(error.problem(), "-1 is not allowed");
}

TEST(ConfigError, NamesWhereTheValueCameFrom) {
  const ConfigError error("car.yaml:7", "ground.cell_m", "-1 is not allowed");
  EXPECT_STREQ(error.what(), "car.yaml:7: ground.cell_m: -1 is not allowed");
  EXPECT_EQ(error.key(), "ground.cell_m");
}

TEST(Error, IsCaughtAsOneKind) {
  const auto throws = [] { throw FileError(ErrorCode::unreadable, "f", std::nullopt, "p"); };
  EXPECT_THROW(throws(), Error);
  EXPECT_THROW(throws(), std::runtime_error);
}

}  // namespace
}  // namespace berm
