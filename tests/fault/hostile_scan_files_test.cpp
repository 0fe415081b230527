// Files that are made to take memory, and what is no file at all. Memory stays below 4 times the file plus 64 MiB.
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "berm/core/error.hpp"
#include "berm/io/kitti_bin.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/pcd.hpp"
#include "support/counting_new.hpp"
#include "support/file_error.hpp"
#include "support/made_pcd.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::expect_file_error;

constexpr std::size_t kScanMebibyte = std::size_t{1} << 20U;

/// Memory that `body` took, in bytes.
std::size_t peak_of(const std::function<void()>& body) {
  test::reset_peak();
  const std::size_t before = test::allocated_bytes();
  body();
  return test::peak_bytes() - before;
}

void expect_bounded_read(const std::filesystem::path& path, const std::function<void()>& read) {
  const std::size_t file_bytes = std::filesystem::file_size(path);
  const std::size_t peak = peak_of([&] {
    try {
      read();
    } catch (const FileError&) {
    }
  });
  EXPECT_GE(peak, file_bytes);  // or nothing was counted
  EXPECT_LE(peak, 4 * file_bytes + 64 * kScanMebibyte);
}

std::string repeated(const std::string& piece, std::size_t times) {
  std::string result;
  result.reserve(piece.size() * times);
  for (std::size_t i = 0; i < times; ++i) {
    result += piece;
  }
  return result;
}

std::string header(const std::string& fields, const std::string& sizes, const std::string& types, std::uint64_t points,
                   const std::string& encoding) {
  return "FIELDS " + fields + "\nSIZE " + sizes + "\nTYPE " + types + "\nPOINTS " + std::to_string(points) + "\nDATA " +
         encoding + "\n";
}

class HostilePcd : public testing::Test {
 protected:
  void expect_bounded(const std::string& bytes) {
    test::spill(folder_ / "scan.pcd", bytes);
    expect_bounded_read(folder_ / "scan.pcd", [&] { (void)read_pcd(folder_ / "scan.pcd"); });
  }

  test::TempFolder folder_;
};

TEST_F(HostilePcd, HeaderOfNothingButFields) {
  expect_bounded("FIELDS" + repeated(" x", 20 * kScanMebibyte) + "\n");
}

TEST_F(HostilePcd, HeaderOfNothingButLines) {
  expect_bounded(repeated("\n", 40 * kScanMebibyte));
}

TEST_F(HostilePcd, OneEndlessLine) {
  expect_bounded(std::string(40 * kScanMebibyte, 'x'));
}

TEST_F(HostilePcd, SmallestPossibleAsciiPoints) {
  constexpr std::size_t kPoints = 4 * kScanMebibyte;
  expect_bounded(header("x y z timestamp", "4 4 4 8", "F F F F", kPoints, "ascii") + repeated("1 1 1 1\n", kPoints));
}

TEST_F(HostilePcd, SmallestPossibleBinaryPoints) {
  // A point of 3 bytes in the file takes 12 in memory: with the file itself 5 times its size.
  constexpr std::size_t kPoints = 24 * kScanMebibyte;
  expect_bounded(header("x y z", "1 1 1", "I I I", kPoints, "binary") + std::string(3 * kPoints, '\1'));
}

TEST_F(HostilePcd, BombsOfEverySize) {
  // Runs of zeros: 3 bytes become 264.
  for (const std::size_t packed_bytes : {3'000U, 300'000U, 900'000U, 30'000'000U}) {
    const std::size_t points = packed_bytes * 88 / 12 - 1;
    const std::uint32_t sizes[] = {static_cast<std::uint32_t>(packed_bytes), static_cast<std::uint32_t>(12 * points)};
    expect_bounded(header("x y z", "4 4 4", "F F F", points, "binary_compressed") +
                   std::string(reinterpret_cast<const char*>(sizes), sizeof(sizes)) + std::string(2, '\0') +
                   repeated(std::string("\xe0\xff\0", 3), packed_bytes / 3));
  }
}

TEST_F(HostilePcd, LargeOrdinaryFilesAreRead) {
  // The limit must not refuse what is merely large: 48 MiB of points, with and without compression.
  test::MadePcd pcd = test::made_xyz(0);
  constexpr std::size_t kPoints = 3 * kScanMebibyte;
  pcd.points = kPoints;
  pcd.fields.push_back({.name = "intensity", .values = {}});
  const std::string body = repeated(std::string("\1\0\0\x40", 4), 4 * kPoints);
  test::spill(folder_ / "scan.pcd", pcd.header("binary") + body);
  ScanRecord record;
  expect_bounded_read(folder_ / "scan.pcd", [&] { record = read_pcd(folder_ / "scan.pcd"); });
  EXPECT_EQ(record.channels.z.size(), kPoints);
  write_pcd(folder_ / "ascii.pcd", PointCloud(std::move(record.channels)).view(), PcdEncoding::ascii);
  expect_bounded_read(folder_ / "ascii.pcd", [&] { record = read_pcd(folder_ / "ascii.pcd"); });
  EXPECT_EQ(record.channels.z.size(), kPoints);
}

TEST(HostileFiles, LargeHeaderlessFilesAreRead) {
  const test::TempFolder folder;
  test::spill(folder / "scan.bin", std::string(32 * kScanMebibyte, '\0'));
  ScanRecord record;
  expect_bounded_read(folder / "scan.bin", [&] { record = read_kitti_bin(folder / "scan.bin", IntensityScale::byte); });
  EXPECT_EQ(record.channels.x.size(), 2 * kScanMebibyte);
  std::vector<std::uint32_t> labels;
  expect_bounded_read(folder / "scan.bin", [&] { labels = read_labels(folder / "scan.bin", std::nullopt); });
  EXPECT_EQ(labels.size(), 8 * kScanMebibyte);
}

TEST(HostileFiles, WhatIsNoFileIsRefusedByEveryReader) {
  const test::TempFolder folder;
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  std::filesystem::create_directory(folder / "folder");
  std::filesystem::create_symlink("loop", folder / "loop");
  const std::vector<std::function<void(const std::filesystem::path&)>> readers = {
      [](const auto& path) { (void)read_pcd(path); },
      [](const auto& path) { (void)read_kitti_bin(path, IntensityScale::byte); },
      [](const auto& path) { (void)read_labels(path, std::nullopt); }};
  for (const auto& read : readers) {
    expect_file_error(ErrorCode::not_found, "no such file", [&] { read(folder / "none"); });
    expect_file_error(ErrorCode::unreadable, "is a folder", [&] { read(folder / "folder"); });
    expect_file_error(ErrorCode::unreadable, "pipe", [&] { read(folder / "pipe"); });
    expect_file_error(ErrorCode::unreadable, "cannot be opened", [&] { read(folder / "loop"); });
  }
}

TEST(HostileFiles, EmptyFile) {
  const test::TempFolder folder;
  test::spill(folder / "empty", "");
  expect_file_error(ErrorCode::truncated, "is it a PCD file", [&] { (void)read_pcd(folder / "empty"); });
  // Without a header nothing tells an empty scan from a lost one: it has no points.
  EXPECT_TRUE(read_kitti_bin(folder / "empty", IntensityScale::byte).channels.x.empty());
  EXPECT_TRUE(read_labels(folder / "empty", 0).empty());
}

}  // namespace
}  // namespace berm
