#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <lzf.h>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/pcd.hpp"
#include "little_endian.hpp"
#include "points_check.hpp"

namespace berm {
namespace {

constexpr std::size_t kWriteBlockPoints = 2048;

/// The channels that are present, in the order of the file, with what the header says of them.
class PcdWriter {
 public:
  explicit PcdWriter(const PointsView& points) : points_(points) {
    add("x", 'F', 4);
    add("y", 'F', 4);
    add("z", 'F', 4);
    if (!points.intensity.empty()) {
      add("intensity", 'F', 4);
    }
    if (!points.ring.empty()) {
      add("ring", 'U', 2);
    }
    if (!points.time.empty()) {
      add("time", 'F', 4);
    }
    if (!points.label.empty()) {
      add("label", 'U', 4);
    }
  }

  [[nodiscard]] std::string header(PcdEncoding encoding) const {
    constexpr std::array<const char*, 3> kEncodings = {"ascii", "binary", "binary_compressed"};
    return fmt::format(
        "# .PCD v0.7 - Point Cloud Data file format\n"
        "VERSION 0.7\nFIELDS{}\nSIZE{}\nTYPE{}\nCOUNT{}\n"
        "WIDTH {}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA {}\n",
        names_, sizes_, types_, counts_, points_.size(), points_.size(),
        kEncodings.at(static_cast<std::size_t>(encoding)));
  }

  /// Calls `use(values, size of one value, offset in the record)` for each channel, the points from `begin` on.
  template <typename Use>
  void each_channel(std::size_t begin, std::size_t count, Use&& use) const {
    std::size_t offset = 0;
    const auto channel = [&](auto values, auto convert) {
      using Value = decltype(convert(values[0]));
      if (!values.empty()) {
        use(values.subspan(begin, count), convert, offset);
        offset += sizeof(Value);
      }
    };
    const auto same = [](auto value) { return value; };
    channel(points_.x, same);
    channel(points_.y, same);
    channel(points_.z, same);
    channel(points_.intensity, same);
    channel(points_.ring, same);
    channel(points_.time, same);
    channel(points_.label, [](Label label) { return semantic_kitti_id(label); });
  }

  void write_binary(AtomicFile& file) const {
    std::vector<std::byte> block(kWriteBlockPoints * point_bytes_);
    for (std::size_t begin = 0; begin < points_.size(); begin += kWriteBlockPoints) {
      const std::size_t count = std::min(kWriteBlockPoints, points_.size() - begin);
      each_channel(begin, count, [&](auto values, auto convert, std::size_t offset) {
        std::byte* target = block.data() + offset;
        for (const auto value : values) {
          store(target, convert(value));
          target += point_bytes_;
        }
      });
      file.write(std::span<const std::byte>(block).first(count * point_bytes_));
    }
  }

  void write_compressed(AtomicFile& file) const {
    const std::uint64_t plain_bytes = std::uint64_t{points_.size()} * point_bytes_;
    // Data that does not shrink grows by 1/32 at most.
    const std::uint64_t most_bytes = plain_bytes + plain_bytes / 16 + 64;
    if (most_bytes > UINT32_MAX) {
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("{}: {} points are too many for binary_compressed, write binary", file.target().string(),
                              points_.size()));
    }
    std::vector<std::byte> plain(plain_bytes);
    each_channel(0, points_.size(), [&](auto values, auto convert, std::size_t offset) {
      std::byte* target = plain.data() + offset * points_.size();
      for (const auto value : values) {
        const auto converted = convert(value);
        store(target, converted);
        target += sizeof(converted);
      }
    });
    std::vector<std::byte> packed(most_bytes);
    const unsigned int packed_bytes = plain.empty()
                                          ? 0
                                          : lzf_compress(plain.data(), static_cast<unsigned int>(plain_bytes),
                                                         packed.data(), static_cast<unsigned int>(most_bytes));
    const std::array<std::uint32_t, 2> sizes = {packed_bytes, static_cast<std::uint32_t>(plain_bytes)};
    file.write(std::as_bytes(std::span(sizes)));
    file.write(std::span<const std::byte>(packed).first(packed_bytes));
  }

  void write_ascii(AtomicFile& file) const {
    std::array<char, 32> digits{};
    std::string line;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      line.clear();
      each_channel(i, 1, [&](auto values, auto convert, std::size_t offset) {
        // The shortest digits that read back as the same value.
        const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), convert(values[0]));
        line.append(offset == 0 ? "" : " ").append(digits.data(), end);
      });
      line += '\n';
      file.write(line);
    }
  }

 private:
  void add(const char* name, char type, std::size_t size) {
    names_ += std::string(" ") + name;
    sizes_ += " " + std::to_string(size);
    types_ += std::string(" ") + type;
    counts_ += " 1";
    point_bytes_ += size;
  }

  const PointsView& points_;
  std::string names_;
  std::string sizes_;
  std::string types_;
  std::string counts_;
  std::size_t point_bytes_ = 0;
};

}  // namespace

void write_pcd(const std::filesystem::path& path, const PointsView& points, PcdEncoding encoding) {
  check_channels(points);
  const PcdWriter writer(points);
  AtomicFile file(path);
  file.write(writer.header(encoding));
  switch (encoding) {
    case PcdEncoding::ascii:
      writer.write_ascii(file);
      break;
    case PcdEncoding::binary:
      writer.write_binary(file);
      break;
    case PcdEncoding::binary_compressed:
      writer.write_compressed(file);
      break;
  }
  file.commit();
}

}  // namespace berm
