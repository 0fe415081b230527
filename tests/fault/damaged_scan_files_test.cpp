// Every length and every single-bit flip of a small file of each format: one clear error or a correct read.
#include <algorithm>
#include <cstring>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/io/kitti_bin.hpp"
#include "berm/io/label_file.hpp"
#include "berm/io/pcd.hpp"
#include "support/counting_new.hpp"
#include "support/made_pcd.hpp"
#include "support/random_points.hpp"

namespace berm {
namespace {

constexpr std::size_t kMebibyte = std::size_t{1} << 20U;

/// What came of reading damaged bytes.
struct Outcome {
  std::optional<ErrorCode> error;
  ScanRecord record;
};

Outcome read_damaged(const std::string& bytes, const std::function<ScanRecord(std::span<const std::byte>)>& parse) {
  test::reset_peak();
  const std::size_t before = test::allocated_bytes();
  Outcome outcome;
  try {
    outcome.record = parse(test::as_bytes(bytes));
    // Channels must agree whatever the bytes were.
    PointCloud cloud(std::move(outcome.record.channels));
    outcome.record.channels = std::move(cloud).release();
  } catch (const FileError& error) {
    outcome.error = error.code();
    EXPECT_EQ(error.file(), "damaged");
    EXPECT_GT(std::strlen(error.what()), std::strlen("damaged: "));
    EXPECT_LT(std::strlen(error.what()), 500U) << error.what();
    EXPECT_TRUE(std::all_of(error.what(), error.what() + std::strlen(error.what()), [](char c) {
      return c >= ' ' && c <= '~';
    })) << error.what();
    EXPECT_TRUE(error.code() == ErrorCode::truncated || error.code() == ErrorCode::malformed ||
                error.code() == ErrorCode::unsupported)
        << error.what();
    EXPECT_LE(error.offset().value_or(0), bytes.size()) << error.what();
  }
  // Far below the promised 4 times the file plus 64 MiB, which for small files would hide a lot.
  EXPECT_LE(test::peak_bytes() - before + bytes.size(), 4 * bytes.size() + kMebibyte);
  return outcome;
}

struct Format {
  std::string name;
  std::string bytes;
  std::function<ScanRecord(std::span<const std::byte>)> parse;
  std::size_t unit_bytes = 0;  ///< a format without a header cannot miss whole units of this many bytes
};

void PrintTo(const Format& format, std::ostream* stream) {
  *stream << format.name;
}

ScanRecord parse_as_pcd(std::span<const std::byte> bytes) {
  return parse_pcd(bytes, "damaged");
}

test::MadePcd made_pcd_of_all_kinds() {
  return {.fields = {{"x", 'F', 4, 1, {1, -2, 3, 4.5L}},
                     {"y", 'F', 8, 1, {-1, 2, 3, 4}},
                     {"_", 'U', 1, 3, {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3}},
                     {"z", 'F', 4, 1, {-1, 2, 3, 4}},
                     {"intensity", 'U', 1, 1, {9, 8, 7, 255}},
                     {"ring", 'U', 2, 1, {0, 1, 300, 2}},
                     {"timestamp", 'F', 8, 1, {1.6e9L, 1.6e9L + 0.25L, 1.6e9L + 0.5L, 1.6e9L + 0.125L}}},
          .points = 4};
}

std::vector<Format> formats() {
  std::vector<Format> result;
  for (const char* encoding : {"ascii", "binary", "binary_compressed"}) {
    result.push_back({std::string("pcd_") + encoding, made_pcd_of_all_kinds().encoded(encoding), parse_as_pcd});
  }
  const std::string floats(reinterpret_cast<const char*>(std::vector<float>(20, 0.5F).data()), 80);
  result.push_back(
      {"kitti_bin", floats,
       [](std::span<const std::byte> bytes) { return parse_kitti_bin(bytes, "damaged", IntensityScale::unit); }, 16});
  result.push_back({"label_file", floats,
                    [](std::span<const std::byte> bytes) {
                      ScanRecord record;
                      record.channels.x.resize(parse_labels(bytes, "damaged", std::nullopt).size());
                      record.channels.y = record.channels.z = record.channels.x;
                      return record;
                    },
                    4});
  return result;
}

class DamagedScanFiles : public testing::TestWithParam<Format> {};

bool says_that_the_end_may_be_cut(const ScanRecord& record) {
  return std::any_of(record.notes.begin(), record.notes.end(),
                     [](const std::string& note) { return note.find("may be cut") != std::string::npos; });
}

TEST_P(DamagedScanFiles, WholeFileIsRead) {
  EXPECT_FALSE(read_damaged(GetParam().bytes, GetParam().parse).error);
}

TEST_P(DamagedScanFiles, CutAtEveryLength) {
  const auto& [name, bytes, parse, unit_bytes] = GetParam();
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    SCOPED_TRACE(length);
    const Outcome outcome = read_damaged(bytes.substr(0, length), parse);
    if (unit_bytes > 0) {
      EXPECT_EQ(outcome.error.has_value(), length % unit_bytes != 0);
    } else {
      EXPECT_TRUE(outcome.error || says_that_the_end_may_be_cut(outcome.record));
    }
  }
}

TEST_P(DamagedScanFiles, EverySingleBitFlipped) {
  const auto& [name, bytes, parse, unit_bytes] = GetParam();
  std::size_t refused = 0;
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    SCOPED_TRACE(bit);
    std::string damaged = bytes;
    damaged[bit / 8] = static_cast<char>(static_cast<unsigned char>(damaged[bit / 8]) ^ (1U << (bit % 8)));
    refused += read_damaged(damaged, parse).error ? 1U : 0U;
  }
  // A header does not survive just anything; without one every value is possible.
  EXPECT_EQ(refused > 0, unit_bytes == 0);
}

TEST_P(DamagedScanFiles, EverySingleByteReplaced) {
  const auto& [name, bytes, parse, unit_bytes] = GetParam();
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const char value : {'\0', '\n', ' ', '9', '-', '\xff'}) {
      SCOPED_TRACE(at);
      std::string damaged = bytes;
      damaged[at] = value;
      (void)read_damaged(damaged, parse);
    }
  }
}

std::string format_name(const testing::TestParamInfo<Format>& format) {
  return format.param.name;
}

INSTANTIATE_TEST_SUITE_P(Formats, DamagedScanFiles, testing::ValuesIn(formats()), format_name);

}  // namespace
}  // namespace berm
