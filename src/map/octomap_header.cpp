#include "octomap_header.hpp"

#include <array>
#include <charconv>
#include <optional>

#include "berm/core/config.hpp"
#include "berm/core/error.hpp"
#include "berm/map/edge_map.hpp"

namespace berm {
namespace {

constexpr std::string_view kFirstLine = "# Octomap OcTree file";
constexpr std::string_view kOurs = "# berm ";
constexpr std::string_view kVersion = "edge_map 1";
constexpr std::string_view kTreeId = "ColorOcTree";
/// Longer ones are no header of anyone's, and are not searched for its end.
constexpr std::size_t kMaxHeaderBytes = 16384;
/// Leaves room for a tree around it.
constexpr std::int32_t kMaxOrigin = kMaxVoxelKey - 2 * kOctomapHalfRange;

template <typename Number>
std::string text_of(Number value) {
  std::array<char, 32> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return {buffer.data(), result.ptr};
}

template <typename Number>
std::optional<Number> number_in(std::string_view text) {
  Number value{};
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

class HeaderParser {
 public:
  HeaderParser(std::string_view bytes, const std::string& name) : bytes_(bytes), name_(name) {}

  ParsedOctomapHeader parse() {
    if (next_line() != kFirstLine) {
      throw error(ErrorCode::malformed,
                  "expected the first line of an OctoMap file, '" + std::string(kFirstLine) + "': is this a .ot file?");
    }
    for (std::string_view line = next_line(); line != "data"; line = next_line()) {
      take(line);
    }
    check_complete();
    check_size();
    return {header_, position_};
  }

 private:
  [[nodiscard]] FileError error(ErrorCode code, const std::string& problem) const {
    return {code, name_, line_start_, problem};
  }

  std::string_view next_line() {
    line_start_ = position_;
    const std::size_t end = bytes_.substr(0, kMaxHeaderBytes).find('\n', position_);
    if (end == std::string_view::npos) {
      if (bytes_.size() > kMaxHeaderBytes) {
        throw error(ErrorCode::malformed, "no line 'data' within the first " + text_of(kMaxHeaderBytes) + " bytes");
      }
      throw error(ErrorCode::truncated, "the file ends before the line 'data' that ends the header");
    }
    position_ = end + 1;
    return bytes_.substr(line_start_, end - line_start_);
  }

  void take(std::string_view line) {
    if (line.starts_with(kOurs)) {
      take_ours(line.substr(kOurs.size()));
      return;
    }
    if (line.starts_with('#')) {
      return;
    }
    const std::size_t space = line.find(' ');
    const std::string_view key = line.substr(0, space);
    const std::string_view value = space == std::string_view::npos ? std::string_view() : line.substr(space + 1);
    if (key == "id") {
      once(id_);
      if (value != kTreeId) {
        throw error(ErrorCode::unsupported, "expected a tree of the type " + std::string(kTreeId));
      }
    } else if (key == "size") {
      once(size_);
      const auto nodes = number_in<std::uint64_t>(value);
      if (!nodes) {
        throw error(ErrorCode::malformed, "expected the number of nodes after 'size'");
      }
      header_.nodes = *nodes;
      size_line_ = line_start_;
    } else if (key == "res") {
      once(res_);
      take_resolution(value);
    } else {
      throw error(ErrorCode::malformed, "expected id, size, res, data or a comment");
    }
  }

  void take_ours(std::string_view text) {
    const std::size_t space = text.find(' ');
    const std::string_view key = text.substr(0, space);
    const std::string_view value = space == std::string_view::npos ? std::string_view() : text.substr(space + 1);
    if (key == "edge_map") {
      once(ours_);
      if (text != kVersion) {
        throw error(ErrorCode::unsupported, "expected version 1 of an edge map: was it written by a newer berm?");
      }
    } else if (key == "origin_voxels") {
      once(origin_);
      take_origin(value);
    } else if (key == "world") {
      once(world_);
      header_.world = std::string(value);
      world_line_ = line_start_;
    } else if (key != "origin_m") {
      throw error(ErrorCode::malformed, "expected edge_map, origin_voxels, origin_m or world after '# berm'");
    }
  }

  void take_resolution(std::string_view value) {
    const auto voxel_m = number_in<double>(value);
    if (!voxel_m) {
      throw error(ErrorCode::malformed, "expected the side of a voxel in metres after 'res'");
    }
    header_.voxel_m = *voxel_m;
    try {
      EdgeMapConfig config;
      config.voxel_m = *voxel_m;
      config.check();
    } catch (const ConfigError& wrong) {
      throw error(ErrorCode::malformed, "voxels of " + std::string(value) + " m: " + wrong.problem());
    }
  }

  void take_origin(std::string_view value) {
    for (std::int32_t* coordinate : {&header_.origin.x, &header_.origin.y, &header_.origin.z}) {
      const std::size_t space = coordinate == &header_.origin.z ? value.size() : value.find(' ');
      const auto number = number_in<std::int32_t>(value.substr(0, space));
      if (space == std::string_view::npos || !number || *number < -kMaxOrigin || *number > kMaxOrigin) {
        throw error(ErrorCode::malformed,
                    "expected three whole numbers of up to " + text_of(kMaxOrigin) + " after 'origin_voxels'");
      }
      *coordinate = *number;
      value.remove_prefix(std::min(space + 1, value.size()));
    }
  }

  void once(bool& seen) const {
    if (seen) {
      throw error(ErrorCode::malformed, "this line is there twice");
    }
    seen = true;
  }

  void check_complete() const {
    if (!ours_ || !origin_) {
      throw error(ErrorCode::unsupported,
                  "an OctoMap, but no edge map: its comments '# berm edge_map' and '# berm origin_voxels' are missing. "
                  "Only files that berm wrote can be read, and tools that rewrite them lose the comments");
    }
    if (!id_ || !size_ || !res_) {
      throw error(ErrorCode::malformed, "expected lines id, size and res before 'data'");
    }
    try {
      (void)EdgeMap(EdgeMapConfig{}, header_.world);
    } catch (const Error& wrong) {
      throw FileError(ErrorCode::malformed, name_, world_line_, wrong.what());
    }
  }

  void check_size() const {
    const std::size_t left = bytes_.size() - position_;
    if (header_.nodes == left / kOctomapNodeBytes && left % kOctomapNodeBytes == 0) {
      return;
    }
    const bool short_of = header_.nodes > left / kOctomapNodeBytes;
    throw FileError(short_of ? ErrorCode::truncated : ErrorCode::malformed, name_, size_line_,
                    text_of(header_.nodes) + " nodes of " + text_of(kOctomapNodeBytes) + " bytes are announced, " +
                        text_of(left) + " bytes follow" + (short_of ? ": was the file cut?" : ""));
  }

  std::string_view bytes_;
  const std::string& name_;
  OctomapHeader header_;
  std::size_t position_ = 0;
  std::size_t line_start_ = 0;
  std::size_t size_line_ = 0;
  std::size_t world_line_ = 0;
  bool ours_ = false;
  bool origin_ = false;
  bool world_ = false;
  bool id_ = false;
  bool size_ = false;
  bool res_ = false;
};

}  // namespace

std::string write_octomap_header(const OctomapHeader& header) {
  std::string text(kFirstLine);
  text += "\n# The colour of a voxel counts what was seen there: red left edge, green right edge, blue plain road.\n";
  text += "# Its place in the world: the one in this file, plus origin_m.\n";
  text += std::string(kOurs) + std::string(kVersion) + "\n";
  text += std::string(kOurs) + "origin_voxels";
  for (const std::int32_t coordinate : {header.origin.x, header.origin.y, header.origin.z}) {
    text += " " + text_of(coordinate);
  }
  text += "\n" + std::string(kOurs) + "origin_m";
  for (const std::int32_t coordinate : {header.origin.x, header.origin.y, header.origin.z}) {
    text += " " + text_of(coordinate * header.voxel_m);
  }
  if (!header.world.empty()) {
    text += "\n" + std::string(kOurs) + "world " + header.world;
  }
  text += "\nid " + std::string(kTreeId) + "\nsize " + text_of(header.nodes) + "\nres " + text_of(header.voxel_m);
  return text + "\ndata\n";
}

ParsedOctomapHeader parse_octomap_header(std::string_view bytes, const std::string& name) {
  return HeaderParser(bytes, name).parse();
}

}  // namespace berm
