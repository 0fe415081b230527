#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <lzf.h>

#include "berm/core/error.hpp"
#include "berm/io/file_reader.hpp"
#include "berm/io/pcd.hpp"
#include "little_endian.hpp"
#include "memory_limit.hpp"
#include "pcd_ascii.hpp"
#include "pcd_decoder.hpp"
#include "pcd_header.hpp"
#include "pcd_plan.hpp"

namespace berm {
namespace {

/// Points decoded channel by channel before the next ones: their records stay in the first-level cache.
constexpr std::size_t kReadBlockPoints = 512;

class PcdReader {
 public:
  PcdReader(std::span<const std::byte> bytes, const std::string& name)
      : bytes_(bytes), name_(name), header_(parse_pcd_header(bytes, name)), plan_(plan_channels(header_, name)) {}

  ScanRecord read(PointChannels reuse) {
    switch (header_.encoding) {
      case PcdEncoding::ascii:
        read_ascii(std::move(reuse));
        break;
      case PcdEncoding::binary:
        read_binary(std::move(reuse));
        break;
      case PcdEncoding::binary_compressed:
        read_compressed(std::move(reuse));
        break;
    }
    ScanRecord record = decoder_->finish();
    std::move(notes_.begin(), notes_.end(), std::back_inserter(record.notes));
    return record;
  }

 private:
  [[nodiscard]] std::span<const std::byte> body() const { return bytes_.subspan(header_.data_offset); }

  /// Takes the memory; the number of points must have been checked against the bytes before.
  void start(PointChannels reuse, std::uint64_t other_bytes) {
    check_memory(name_, bytes_.size(),
                 bytes_.size() + other_bytes + header_.points * PcdDecoder::bytes_per_point(plan_));
    decoder_.emplace(header_, plan_, name_, std::move(reuse));
  }

  [[noreturn]] void fail_truncated(const std::string& problem) const {
    throw FileError(ErrorCode::truncated, name_, bytes_.size(),
                    problem + "; it is cut or its header is wrong, copy it again");
  }

  void read_ascii(PointChannels reuse) {
    std::size_t words = 0;
    for (const PcdField& field : header_.fields) {
      words += field.count;
    }
    // A word takes a character and a blank or line end; the end of the last line may be missing.
    const std::size_t most_points = (body().size() + 1) / (2 * words);
    if (header_.points > most_points) {
      fail_truncated(fmt::format("the file ends here with room for at most {} of {} points of {} values", most_points,
                                 header_.points, words));
    }
    start(std::move(reuse), 0);
    read_pcd_ascii(body(), header_, plan_, name_, *decoder_, notes_);
  }

  void read_binary(PointChannels reuse) {
    const std::size_t most_points = body().size() / header_.point_bytes;
    if (header_.points > most_points) {
      fail_truncated(fmt::format("the file ends here with {} of {} points of {} bytes", most_points, header_.points,
                                 header_.point_bytes));
    }
    note_rest(body().size() - header_.points * header_.point_bytes);
    start(std::move(reuse), 0);
    std::vector<PcdColumn> columns;
    columns.reserve(plan_.channels.size());
    for (const auto& [channel, field] : plan_.channels) {
      columns.push_back({body().data() + header_.fields[field].offset, header_.point_bytes});
    }
    decode_all(std::move(columns));
  }

  void read_compressed(PointChannels reuse) {
    if (header_.points == 0) {
      start(std::move(reuse), 0);
      return;
    }
    const std::vector<std::byte> plain = decompress();
    start(std::move(reuse), plain.size());
    std::vector<PcdColumn> columns;
    columns.reserve(plan_.channels.size());
    for (const auto& [channel, field] : plan_.channels) {
      // Field after field, each with its values for all points.
      const PcdField& column = header_.fields[field];
      columns.push_back({plain.data() + column.offset * header_.points, column.bytes()});
    }
    decode_all(std::move(columns));
  }

  std::vector<std::byte> decompress() {
    constexpr std::size_t kSizesBytes = 2 * sizeof(std::uint32_t);
    // The longest match of LZF makes 264 bytes of 3.
    constexpr std::uint64_t kMostExpansion = 264 / 3;
    if (body().size() < kSizesBytes) {
      fail_truncated("the file ends here before the two sizes of its compressed data");
    }
    const std::uint64_t packed_bytes = load<std::uint32_t>(body().data());
    const std::uint64_t plain_bytes = load<std::uint32_t>(body().data() + sizeof(std::uint32_t));
    const std::size_t present_bytes = body().size() - kSizesBytes;
    if (packed_bytes > present_bytes) {
      fail_truncated(
          fmt::format("the file ends here with {} of {} bytes of compressed data", present_bytes, packed_bytes));
    }
    if (plain_bytes / header_.point_bytes != header_.points || plain_bytes % header_.point_bytes != 0) {
      fail_sizes(fmt::format("announces {} bytes after decompression, {} points of {} bytes are expected", plain_bytes,
                             header_.points, header_.point_bytes));
    }
    if (plain_bytes > packed_bytes * kMostExpansion) {
      fail_sizes(fmt::format("announces {} bytes after decompression, more than {} compressed bytes can become",
                             plain_bytes, packed_bytes));
    }
    note_rest(present_bytes - packed_bytes);
    check_memory(name_, bytes_.size(),
                 bytes_.size() + plain_bytes + header_.points * PcdDecoder::bytes_per_point(plan_));
    std::vector<std::byte> plain(plain_bytes);
    const unsigned int got = lzf_decompress(body().data() + kSizesBytes, static_cast<unsigned int>(packed_bytes),
                                            plain.data(), static_cast<unsigned int>(plain_bytes));
    if (got != plain_bytes) {
      throw FileError(ErrorCode::malformed, name_, header_.data_offset + kSizesBytes,
                      "the compressed data is damaged (LZF); copy the file again");
    }
    return plain;
  }

  [[noreturn]] void fail_sizes(const std::string& problem) const {
    throw FileError(ErrorCode::malformed, name_, header_.data_offset, problem);
  }

  void note_rest(std::size_t bytes) {
    if (bytes > 0) {
      notes_.push_back(fmt::format("{} bytes after the last point were ignored", bytes));
    }
  }

  void decode_all(std::vector<PcdColumn> columns) {
    for (std::size_t begin = 0; begin < header_.points; begin += kReadBlockPoints) {
      const std::size_t count = std::min(kReadBlockPoints, header_.points - begin);
      decoder_->decode(columns, begin, count);
      for (PcdColumn& column : columns) {
        column.first += count * column.stride_bytes;
      }
    }
  }

  std::span<const std::byte> bytes_;
  const std::string& name_;
  PcdHeader header_;
  PcdPlan plan_;
  std::optional<PcdDecoder> decoder_;
  std::vector<std::string> notes_;
};

}  // namespace

ScanRecord parse_pcd(std::span<const std::byte> bytes, const std::string& name, PointChannels reuse) {
  return PcdReader(bytes, name).read(std::move(reuse));
}

ScanRecord read_pcd(const std::filesystem::path& path, PointChannels reuse) {
  FileBuffer buffer;
  return parse_pcd(read_file(path, buffer), path.string(), std::move(reuse));
}

}  // namespace berm
