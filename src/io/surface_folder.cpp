#include "berm/io/surface_folder.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/file_reader.hpp"
#include "little_endian.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

constexpr const char* kSurfaceSchema = "berm.surface/1";
constexpr std::size_t kTileRecord = 4 * sizeof(float) + 2 * sizeof(std::uint32_t) + 5 * sizeof(std::uint16_t);
constexpr std::size_t kCloudRecord = 4 * sizeof(float) + 2 * sizeof(std::uint32_t);
constexpr std::size_t kTileBlockPoints = 4096;
constexpr double kMostCoordinate_m = 1e9;

constexpr std::string_view kTileFields =
    "FIELDS x y z intensity label count drivable terrain obstacle hits passes\n"
    "SIZE 4 4 4 4 4 4 2 2 2 2 2\nTYPE F F F F U U U U U U U\nCOUNT 1 1 1 1 1 1 1 1 1 1 1\n";
constexpr std::string_view kCloudFields =
    "FIELDS x y z intensity label count\nSIZE 4 4 4 4 4 4\nTYPE F F F F U U\nCOUNT 1 1 1 1 1 1\n";
constexpr std::string_view kStart = "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n";

std::string header_of(std::string_view fields, std::uint64_t points) {
  return fmt::format("{}{}WIDTH {}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {}\nDATA binary\n", kStart, fields,
                     points, points);
}

[[noreturn]] void refuse_tile(const std::string& name, const std::string& problem,
                              ErrorCode code = ErrorCode::malformed) {
  throw FileError(code, name, std::nullopt, problem);
}

/// Places value after value into a record.
class Packer {
 public:
  explicit Packer(std::byte* target) : target_(target) {}
  template <typename Value>
  void put(Value value) {
    store(target_, value);
    target_ += sizeof(Value);
  }

 private:
  std::byte* target_;
};

class Unpacker {
 public:
  explicit Unpacker(const std::byte* source) : source_(source) {}
  template <typename Value>
  void take(Value& value) {
    value = berm::load<Value>(source_);
    source_ += sizeof(Value);
  }

 private:
  const std::byte* source_;
};

void pack_common(Packer& packer, const SurfacePoint& point) {
  packer.put(point.x_m);
  packer.put(point.y_m);
  packer.put(point.z_m);
  packer.put(point.intensity);
  packer.put(semantic_kitti_id(point.label));
  packer.put(point.count);
}

void pack_votes(Packer& packer, const SurfacePoint& point) {
  for (const std::uint16_t value : {point.drivable, point.terrain, point.obstacle, point.hits, point.passes}) {
    packer.put(value);
  }
}

void write_points(AtomicFile& file, std::span<const SurfacePoint> points, bool with_votes) {
  const std::size_t record = with_votes ? kTileRecord : kCloudRecord;
  std::vector<std::byte> block(kTileBlockPoints * record);
  for (std::size_t begin = 0; begin < points.size(); begin += kTileBlockPoints) {
    const auto part = points.subspan(begin, std::min(kTileBlockPoints, points.size() - begin));
    for (std::size_t i = 0; i < part.size(); ++i) {
      Packer packer(block.data() + i * record);
      pack_common(packer, part[i]);
      if (with_votes) {
        pack_votes(packer, part[i]);
      }
    }
    file.write(std::span<const std::byte>(block).first(part.size() * record));
  }
}

std::optional<Label> label_of(std::uint32_t id) {
  for (const Label label : {Label::drivable, Label::terrain, Label::obstacle}) {
    if (semantic_kitti_id(label) == id) {
      return label;
    }
  }
  return std::nullopt;
}

/// The number behind POINTS, which the header is then built from again and compared with: there is one way to write it.
std::uint64_t announced_points(std::string_view text, const std::string& name) {
  constexpr std::string_view kKey = "\nPOINTS ";
  constexpr std::size_t kLongestHeader = 512;
  const std::string_view head = text.substr(0, kLongestHeader);
  const std::size_t at = head.find(kKey);
  const std::string_view number = at == std::string_view::npos ? std::string_view() : head.substr(at + kKey.size());
  std::uint64_t points = 0;
  if (std::from_chars(number.data(), number.data() + number.size(), points).ec != std::errc() ||
      !text.starts_with(header_of(kTileFields, points))) {
    refuse_tile(name, "is no tile of a surface map: another header than berm writes");
  }
  return points;
}

void parse_tile_into(std::span<const std::byte> bytes, const std::string& name, std::vector<SurfacePoint>& points) {
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const std::uint64_t count = announced_points(text, name);
  const std::span<const std::byte> body = bytes.subspan(header_of(kTileFields, count).size());
  if (body.size() % kTileRecord != 0 || body.size() / kTileRecord != count) {
    refuse_tile(name,
                fmt::format("holds {} bytes of points, expected {} points of {}", body.size(), count, kTileRecord),
                body.size() / kTileRecord < count ? ErrorCode::truncated : ErrorCode::malformed);
  }
  points.resize(count);
  for (std::size_t i = 0; i < points.size(); ++i) {
    SurfacePoint& point = points[i];
    Unpacker unpacker(body.data() + i * kTileRecord);
    std::uint32_t id = 0;
    for (float* value : {&point.x_m, &point.y_m, &point.z_m, &point.intensity}) {
      unpacker.take(*value);
    }
    unpacker.take(id);
    unpacker.take(point.count);
    for (std::uint16_t* value : {&point.drivable, &point.terrain, &point.obstacle, &point.hits, &point.passes}) {
      unpacker.take(*value);
    }
    const auto label = label_of(id);
    if (!label || !std::isfinite(point.x_m) || !std::isfinite(point.y_m) || !std::isfinite(point.z_m)) {
      refuse_tile(name, fmt::format("point {} has no place, or the label {}", i, id));
    }
    point.label = *label;
  }
}

double number_in(const OrderedJson& json, const char* key, double most, const std::string& name) {
  const auto place = json.find(key);
  if (place == json.end() || !place->is_number() || !(std::abs(place->get<double>()) <= most)) {
    refuse_tile(name, fmt::format("'{}' is missing or no number within +-{}", key, most));
  }
  return place->get<double>();
}

template <typename Integer>
Integer integer_in(const OrderedJson& json, const char* key, const std::string& name) {
  const auto place = json.find(key);
  if (place == json.end() || !place->is_number_integer() || place->get<std::int64_t>() < -(std::int64_t{1} << 31U) ||
      place->get<std::int64_t>() >= std::int64_t{1} << 31U ||
      (std::is_unsigned_v<Integer> && place->get<std::int64_t>() < 0)) {
    refuse_tile(name, fmt::format("'{}' is missing or no whole number that can be", key));
  }
  return place->get<Integer>();
}

void read_tile_entry(const OrderedJson& json, SurfaceIndex& index, const std::string& name) {
  if (!json.is_object() || !json.contains("file") || !json["file"].is_string()) {
    refuse_tile(name, "a tile has no 'file'");
  }
  const TileKey key{integer_in<std::int32_t>(json, "x", name), integer_in<std::int32_t>(json, "y", name)};
  const std::string file = json["file"].get<std::string>();
  // Names are taken to be in the folder of the index.
  if (file.empty() || file.find_first_of(std::string_view("/\\\0", 3)) != std::string::npos ||
      !file.ends_with(".pcd")) {
    refuse_tile(name, "'" + file + "' is no name of a tile");
  }
  if (!index.tiles.try_emplace(key, SurfaceTileEntry{file, integer_in<std::uint32_t>(json, "points", name)}).second) {
    refuse_tile(name, fmt::format("tile {}, {} is named twice", key.x, key.y));
  }
}

std::string to_text(const SurfaceIndex& index) {
  const Eigen::Vector3d& origin_m = index.frame.origin_m;
  OrderedJson json = {{"schema", kSurfaceSchema},
                      {"voxel_m", index.frame.voxel_m},
                      {"tile_m", index.frame.tile_m},
                      {"origin_m", {origin_m.x(), origin_m.y(), origin_m.z()}},
                      {"tiles", OrderedJson::array()}};
  for (const auto& [key, entry] : index.tiles) {
    json["tiles"].push_back({{"x", key.x}, {"y", key.y}, {"file", entry.file}, {"points", entry.points}});
  }
  return json.dump(1) + "\n";
}

}  // namespace

SurfaceIndex parse_surface_index(std::string_view text, const std::string& name) {
  const OrderedJson json = OrderedJson::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("schema") || json["schema"] != kSurfaceSchema) {
    refuse_tile(name, std::string("is no index of a surface map, expected schema ") + kSurfaceSchema);
  }
  SurfaceIndex index;
  index.frame.voxel_m = number_in(json, "voxel_m", kMostCoordinate_m, name);
  index.frame.tile_m = number_in(json, "tile_m", kMostCoordinate_m, name);
  if (!(index.frame.voxel_m > 0.0 && index.frame.tile_m >= index.frame.voxel_m)) {
    refuse_tile(name, "voxels and tiles have no size that can be");
  }
  const auto origin = json.find("origin_m");
  if (origin == json.end() || !origin->is_array() || origin->size() != 3 || !json.contains("tiles") ||
      !json["tiles"].is_array()) {
    refuse_tile(name, "expected three numbers in 'origin_m' and a list 'tiles'");
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const OrderedJson& value = (*origin)[axis];
    if (!value.is_number() || !(std::abs(value.get<double>()) <= kMostCoordinate_m)) {
      refuse_tile(name, "'origin_m' is no place");
    }
    index.frame.origin_m[static_cast<Eigen::Index>(axis)] = value.get<double>();
  }
  for (const OrderedJson& tile : json["tiles"]) {
    read_tile_entry(tile, index, name);
  }
  return index;
}

std::vector<SurfacePoint> parse_surface_tile(std::span<const std::byte> bytes, const std::string& name) {
  std::vector<SurfacePoint> points;
  parse_tile_into(bytes, name, points);
  return points;
}

SurfaceFolder::SurfaceFolder(fs::path folder, const SurfaceFrame& frame) : folder_(std::move(folder)) {
  index_.frame = frame;
}

SurfaceFolder SurfaceFolder::open(const fs::path& folder) {
  const fs::path file = folder / kIndex;
  FileBuffer buffer;
  read_file(file, buffer);
  SurfaceFolder map(folder, {});
  map.index_ = parse_surface_index(buffer.text(), file.string());
  return map;
}

std::uint64_t SurfaceFolder::points() const {
  std::uint64_t sum = 0;
  for (const auto& [key, entry] : index_.tiles) {
    sum += entry.points;
  }
  return sum;
}

std::vector<SurfacePoint> SurfaceFolder::load(const TileKey& key) const {
  SurfaceTileBuffer buffer;
  load(key, buffer);
  return std::move(buffer.points);
}

void SurfaceFolder::load(const TileKey& key, SurfaceTileBuffer& buffer) const {
  const auto place = index_.tiles.find(key);
  if (place == index_.tiles.end()) {
    buffer.points.clear();
    return;
  }
  const fs::path file = folder_ / place->second.file;
  parse_tile_into(read_file(file, buffer.file), file.string(), buffer.points);
  if (buffer.points.size() != place->second.points) {
    refuse_tile(file.string(),
                fmt::format("holds {} points, the index says {}", buffer.points.size(), place->second.points));
  }
}

void SurfaceFolder::save(const TileKey& key, std::span<const SurfacePoint> points) {
  if (const auto place = index_.tiles.find(key); place != index_.tiles.end()) {
    outdated_.push_back(place->second.file);
    index_.tiles.erase(place);
  }
  if (points.empty()) {
    return;
  }
  std::string name;
  std::error_code code;
  do {
    name = fmt::format("{}_{}.{}.pcd", key.x, key.y, ++revisions_[key]);
  } while (fs::exists(folder_ / name, code));
  AtomicFile file(folder_ / name);
  file.write(header_of(kTileFields, points.size()));
  write_points(file, points, true);
  file.commit();
  index_.tiles[key] = {name, points.size()};
}

void SurfaceFolder::commit() {
  write_file_atomically(folder_ / kIndex, to_text(index_));
  for (const std::string& name : outdated_) {
    std::error_code ignored;
    fs::remove(folder_ / name, ignored);
  }
  outdated_.clear();
}

void write_surface_cloud(const fs::path& path, const SurfaceFolder& map) {
  AtomicFile file(path);
  file.write(header_of(kCloudFields, map.points()));
  for (const auto& [key, entry] : map.index().tiles) {
    write_points(file, map.load(key), false);
  }
  file.commit();
}

}  // namespace berm
