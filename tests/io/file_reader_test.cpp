#include "berm/io/file_reader.hpp"

#include <string>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "berm/core/error.hpp"
#include "support/child_process.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::expect_file_error;
using test::spill;

TEST(ReadFile, GivesTheBytesAndKeepsItsMemory) {
  const test::TempFolder folder;
  spill(folder / "long", std::string(100'000, 'l'));
  spill(folder / "short", std::string("s\0t", 3));
  spill(folder / "empty", "");
  FileBuffer buffer;
  read_file(folder / "long", buffer);
  EXPECT_EQ(buffer.text(), std::string(100'000, 'l'));
  const std::byte* const memory = buffer.bytes().data();
  EXPECT_EQ(read_file(folder / "short", buffer).size(), 3U);
  EXPECT_EQ(buffer.text(), std::string("s\0t", 3));
  EXPECT_EQ(buffer.bytes().data(), memory);
  EXPECT_TRUE(read_file(folder / "empty", buffer).empty());
}

TEST(ReadFile, EmptyFileInAFreshBuffer) {
  const test::TempFolder folder;
  spill(folder / "empty", "");
  FileBuffer buffer;
  EXPECT_TRUE(read_file(folder / "empty", buffer).empty());
  EXPECT_EQ(buffer.text(), "");
}

TEST(ReadFile, SaysWhatIsNoFile) {
  const test::TempFolder folder;
  spill(folder / "file", "x");
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  FileBuffer buffer;
  expect_file_error(ErrorCode::not_found, "no such file", [&] { read_file(folder / "none", buffer); });
  expect_file_error(ErrorCode::not_found, "no such file", [&] { read_file(folder / "file" / "none", buffer); });
  expect_file_error(ErrorCode::unreadable, "is a folder", [&] { read_file(folder.path(), buffer); });
  expect_file_error(ErrorCode::unreadable, "pipe", [&] { read_file(folder / "pipe", buffer); });
  expect_file_error(ErrorCode::unreadable, "device", [&] { read_file("/dev/zero", buffer); });
}

TEST(ReadFile, RefusesWhatIsTooLargeBeforeTakingMemory) {
  const test::TempFolder folder;
  spill(folder / "file", "1234");
  FileBuffer buffer;
  EXPECT_EQ(read_file(folder / "file", buffer, 4).size(), 4U);
  expect_file_error(ErrorCode::unsupported, "4 bytes", [&] { read_file(folder / "file", buffer, 3); });
  // Sparse: claims a terabyte, holds nothing.
  std::filesystem::resize_file(folder / "file", std::uintmax_t{1} << 40U);
  expect_file_error(ErrorCode::unsupported, "split it", [&] { read_file(folder / "file", buffer); });
}

TEST(ReadFile, SaysWhenPermissionIsMissing) {
  const test::TempFolder folder;
  spill(folder / "file", "x");
  ::chmod(folder.path().c_str(), 0755);
  ::chmod((folder / "file").c_str(), 0);
  const int result = test::run_in_child([&] {
    if (!test::become_ordinary_user()) {
      return 77;
    }
    FileBuffer buffer;
    try {
      read_file(folder / "file", buffer);
    } catch (const FileError& error) {
      return error.code() == ErrorCode::unreadable ? 0 : 2;
    }
    return 3;
  });
  if (result == 77) {
    GTEST_SKIP() << "runs as root and cannot become another user, whom permission bits would stop";
  }
  EXPECT_EQ(result, 0);
}

}  // namespace
}  // namespace berm
