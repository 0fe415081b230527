#include "map_layer.hpp"

#include <algorithm>
#include <cstdint>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>
#include <tsl/robin_set.h>

#include "berm/core/error.hpp"
#include "berm/core/ordered_parallel.hpp"
#include "berm/view/points_payload.hpp"

namespace berm {
namespace {

/// Tiles along one side of a joined tile: few requests for what is seen first.
constexpr int kJoined = 16;
/// The disk and the other requests want their share.
constexpr unsigned kMaxReaders = 8;

/// A cube of space, counted from the origin.
struct Cell {
  std::int64_t x = 0;
  std::int64_t y = 0;
  std::int64_t z = 0;

  /// The one that this and others make up, 4 along each side.
  [[nodiscard]] Cell four_times_larger() const { return {x >> 2U, y >> 2U, z >> 2U}; }
  /// 21 bits an axis: 2 million cells, of a tile that is some hundred wide.
  [[nodiscard]] std::uint64_t key() const {
    const auto bits = [](std::int64_t value) { return static_cast<std::uint64_t>(value) & ((1ULL << 21U) - 1); };
    return (bits(x) << 42U) | (bits(y) << 21U) | bits(z);
  }
};

Cell cell_of(const SurfacePoint& point, double per_m) {
  const auto whole = [per_m](float value_m) {
    const double cells = double{value_m} * per_m;
    const auto cut = static_cast<std::int64_t>(cells);  // a floor of the library takes as long as all the rest
    return cut - (cells < static_cast<double>(cut) ? 1 : 0);
  };
  return {whole(point.x_m), whole(point.y_m), whole(point.z_m)};
}

/// The table takes the lowest bits of a hash, and neighbours differ in the higher ones of their keys: without mixing
/// they would all meet in a few places. The finalizer of SplitMix64 (Steele, Lea, Flood 2014).
struct MixKey {
  std::size_t operator()(std::uint64_t key) const {
    key = (key ^ (key >> 30U)) * 0xbf58476d1ce4e5b9U;
    key = (key ^ (key >> 27U)) * 0x94d049bb133111ebU;
    return static_cast<std::size_t>(key ^ (key >> 31U));
  }
};
using CellKeys = tsl::robin_set<std::uint64_t, MixKey>;

TileKey joined_key(const TileKey& key) {
  const auto floor_div = [](std::int32_t value) {
    return value >= 0 ? value / kJoined : -((kJoined - 1 - value) / kJoined);
  };
  return {floor_div(key.x), floor_div(key.y)};
}

nlohmann::ordered_json to_json(const Eigen::Vector3f& value_m) {
  return {value_m.x(), value_m.y(), value_m.z()};
}

std::string make_payload(std::span<const SurfacePoint> points, const Eigen::Vector3f& shift_m) {
  PointChannels channels;
  for (const SurfacePoint& point : points) {
    channels.x.push_back(point.x_m);
    channels.y.push_back(point.y_m);
    channels.z.push_back(point.z_m);
    channels.intensity.push_back(point.intensity);
    channels.label.push_back(point.label);
  }
  return make_points_payload(PointCloud(std::move(channels)).view(),
                             Pose(Eigen::Quaterniond::Identity(), shift_m.cast<double>()));
}

}  // namespace

void choose_map_levels(std::span<const SurfacePoint> points, double voxel_m, std::vector<std::uint8_t>& levels) {
  static_assert(kMapLevels == 3 && kMapLevelVoxels[0] == 4.0 * kMapLevelVoxels[1]);
  constexpr std::uint64_t kNone = ~std::uint64_t{0};  // keys have 63 bits
  const double per_m = 1.0 / (kMapLevelVoxels[1] * voxel_m);
  CellKeys middle;
  CellKeys coarse;
  std::uint64_t last = kNone;
  levels.assign(points.size(), kMapLevels - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_in_payload(points[i].x_m, points[i].y_m, points[i].z_m)) {
      levels[i] = kMapLevels;
      continue;
    }
    const Cell cell = cell_of(points[i], per_m);
    const std::uint64_t key = cell.key();
    // Points come row by row: most lie in the cell of the one before.
    if (key == last) {
      continue;
    }
    last = key;
    // A large cell without a point has no smaller one that has.
    if (middle.insert(key).second) {
      levels[i] = coarse.insert(cell.four_times_larger().key()).second ? 0 : 1;
    }
  }
}

MapLayer::MapLayer(const std::filesystem::path& folder, const Eigen::Vector3d& origin_m, const std::atomic<bool>& stop)
    : folder_(SurfaceFolder::open(folder)), shift_m_((folder_.index().frame.origin_m - origin_m).cast<float>()) {
  std::vector<TileKey> keys;
  keys.reserve(folder_.index().tiles.size());
  for (const auto& [key, entry] : folder_.index().tiles) {
    keys.push_back(key);
  }
  std::map<TileKey, Tile> joined;
  std::vector<Scratch> scratch(std::clamp(std::thread::hardware_concurrency(), 1U, kMaxReaders));
  OrderedParallel<TileParts>(
      keys.size(), scratch.size(),
      [&](std::size_t worker, std::size_t i, TileParts& parts) { read_parts(keys[i], parts, scratch[worker]); },
      [&](std::size_t i, const TileParts& parts) {
        if (stop) {
          throw Error(ErrorCode::unsupported, "the server is being ended");
        }
        take_parts(keys[i], parts, joined);
        return true;
      })
      .run();
  std::vector<Tile> coarse;
  coarse.reserve(joined.size());
  for (const auto& [key, tile] : joined) {
    coarse.push_back(tile);
  }
  tiles_.insert(tiles_.begin(), coarse.begin(), coarse.end());
}

void MapLayer::read_parts(const TileKey& key, TileParts& parts, Scratch& scratch) const {
  folder_.load(key, scratch.tile);
  const std::vector<SurfacePoint>& points = scratch.tile.points;
  choose_map_levels(points, folder_.index().frame.voxel_m, scratch.levels);
  parts.levels = {};
  parts.coarse.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint8_t level = scratch.levels[i];
    if (level == kMapLevels) {
      continue;
    }
    ++parts.levels[level].points;
    parts.levels[level].box_m.extend(Eigen::Vector3f(points[i].x_m, points[i].y_m, points[i].z_m) + shift_m_);
    if (level == 0) {
      parts.coarse.push_back(points[i]);
    }
  }
}

void MapLayer::take_parts(const TileKey& key, const TileParts& parts, std::map<TileKey, Tile>& joined) {
  coarse_count_ += parts.coarse.size();
  if (coarse_count_ > kMaxCoarsePoints) {
    throw Error(ErrorCode::unsupported, "the map is too large to be shown: " + std::to_string(folder_.points()) +
                                            " points; berm export or map.pcd takes it to other programs");
  }
  const TileKey joined_to = joined_key(key);
  Tile& coarse = joined[joined_to];
  coarse.key = joined_to;
  coarse.points += parts.levels[0].points;
  coarse.box_m.extend(parts.levels[0].box_m);
  std::vector<SurfacePoint>& points = coarse_points_[joined_to];
  points.insert(points.end(), parts.coarse.begin(), parts.coarse.end());
  for (std::uint8_t level = 1; level < kMapLevels; ++level) {
    if (parts.levels[level].points > 0) {
      Tile& tile = tiles_.emplace_back(parts.levels[level]);
      tile.level = level;
      tile.key = key;
    }
  }
}

std::string MapLayer::describe() const {
  using TilesJson = nlohmann::ordered_json;
  TilesJson list = TilesJson::array();
  Eigen::AlignedBox3f box_m;
  for (std::size_t id = 0; id < tiles_.size(); ++id) {
    const Tile& tile = tiles_[id];
    if (tile.points == 0) {
      continue;
    }
    box_m.extend(tile.box_m);
    list.push_back({{"id", id},
                    {"level", tile.level},
                    {"min", to_json(tile.box_m.min())},
                    {"max", to_json(tile.box_m.max())},
                    {"points", tile.points},
                    {"spacing_m", kMapLevelVoxels[tile.level] * folder_.index().frame.voxel_m}});
  }
  if (box_m.isEmpty()) {
    box_m.extend(Eigen::Vector3f::Zero());
  }
  const TilesJson map = {{"bounds", {{"min", to_json(box_m.min())}, {"max", to_json(box_m.max())}}},
                         {"channels", std::uint32_t{kPayloadIntensity} | kPayloadLabel},
                         {"tiles", std::move(list)}};
  return map.dump();
}

std::optional<std::string> MapLayer::read(std::size_t tile) const {
  if (tile >= tiles_.size()) {
    return std::nullopt;
  }
  const Tile& wanted = tiles_[tile];
  if (wanted.level == 0) {
    return make_payload(coarse_points_.at(wanted.key), shift_m_);
  }
  const std::vector<SurfacePoint> points = folder_.load(wanted.key);
  std::vector<std::uint8_t> levels;
  choose_map_levels(points, folder_.index().frame.voxel_m, levels);
  std::vector<SurfacePoint> kept;
  kept.reserve(wanted.points);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (levels[i] == wanted.level) {
      kept.push_back(points[i]);
    }
  }
  return make_payload(kept, shift_m_);
}

}  // namespace berm
