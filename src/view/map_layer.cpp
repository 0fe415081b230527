#include "map_layer.hpp"

#include <array>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>
#include <tsl/robin_set.h>

#include "berm/core/error.hpp"
#include "berm/view/points_payload.hpp"

namespace berm {
namespace {

/// Tiles along one side of a joined tile.
constexpr int kJoined = 8;

/// Cells of one size that hold a point.
class Cells {
 public:
  explicit Cells(double size_m) : per_m_(1.0 / size_m) {}

  /// Whether the cell of `point` was empty; it is not any more.
  bool take(const SurfacePoint& point) {
    const std::uint64_t key = key_of(point);
    // Points come row by row: most lie in the cell of the one before.
    if (key == last_) {
      return false;
    }
    last_ = key;
    return taken_.insert(key).second;
  }

 private:
  /// The table takes the lowest bits of a hash, and neighbours differ in the higher ones of their keys: without mixing
  /// they would all meet in a few places. The finalizer of SplitMix64 (Steele, Lea, Flood 2014).
  struct Mix {
    std::size_t operator()(std::uint64_t key) const {
      key = (key ^ (key >> 30U)) * 0xbf58476d1ce4e5b9U;
      key = (key ^ (key >> 27U)) * 0x94d049bb133111ebU;
      return static_cast<std::size_t>(key ^ (key >> 31U));
    }
  };

  /// 21 bits an axis: 2 million cells, of a tile that is some hundred wide.
  [[nodiscard]] std::uint64_t key_of(const SurfacePoint& point) const {
    constexpr std::uint64_t kMask = (std::uint64_t{1} << 21U) - 1;
    const auto cell = [this](float value_m) {
      return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(double{value_m} * per_m_))) & kMask;
    };
    return (cell(point.x_m) << 42U) | (cell(point.y_m) << 21U) | cell(point.z_m);
  }

  static constexpr std::uint64_t kNone = ~std::uint64_t{0};  // keys have 63 bits

  double per_m_;
  std::uint64_t last_ = kNone;
  tsl::robin_set<std::uint64_t, Mix> taken_;
};

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

std::vector<std::uint8_t> choose_map_levels(std::span<const SurfacePoint> points, double voxel_m) {
  std::vector<std::uint8_t> levels;
  levels.reserve(points.size());
  Cells coarse(kMapLevelVoxels[0] * voxel_m);
  Cells middle(kMapLevelVoxels[1] * voxel_m);
  for (const SurfacePoint& point : points) {
    // A point of the coarsest level fills its cell of the middle one, too.
    const bool opens_middle = middle.take(point);
    const bool opens_coarse = coarse.take(point);
    levels.push_back(opens_coarse ? std::uint8_t{0} : opens_middle ? std::uint8_t{1} : std::uint8_t{2});
  }
  return levels;
}

MapLayer::MapLayer(const std::filesystem::path& folder, const Eigen::Vector3d& origin_m, const std::atomic<bool>& stop)
    : folder_(SurfaceFolder::open(folder)), shift_m_((folder_.index().frame.origin_m - origin_m).cast<float>()) {
  for (const auto& [key, entry] : folder_.index().tiles) {
    if (stop) {
      throw Error(ErrorCode::unsupported, "the server is being ended");
    }
    add_tile(key);
  }
  std::vector<Tile> joined;
  joined.reserve(coarse_.size());
  for (const auto& [key, tile] : coarse_) {
    joined.push_back(tile);
  }
  tiles_.insert(tiles_.begin(), joined.begin(), joined.end());
  coarse_.clear();
}

void MapLayer::add_point(Tile& tile, const SurfacePoint& point) const {
  if (is_in_payload(point.x_m, point.y_m, point.z_m)) {
    ++tile.points;
    tile.box_m.extend(Eigen::Vector3f(point.x_m, point.y_m, point.z_m) + shift_m_);
  }
}

void MapLayer::add_tile(const TileKey& key) {
  const std::vector<SurfacePoint> points = folder_.load(key);
  const std::vector<std::uint8_t> levels = choose_map_levels(points, folder_.index().frame.voxel_m);
  const TileKey joined = joined_key(key);
  Tile& coarse = coarse_[joined];
  coarse.key = joined;
  std::array<Tile, kMapLevels> fine;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (levels[i] > 0) {
      add_point(fine[levels[i]], points[i]);
      continue;
    }
    if (++coarse_count_ > kMaxCoarsePoints) {
      throw Error(ErrorCode::unsupported, "the map is too large to be shown: " + std::to_string(folder_.points()) +
                                              " points; berm export or map.pcd takes it to other programs");
    }
    add_point(coarse, points[i]);
    coarse_points_[joined].push_back(points[i]);
  }
  for (std::uint8_t level = 1; level < kMapLevels; ++level) {
    if (fine[level].points > 0) {
      fine[level].level = level;
      fine[level].key = key;
      tiles_.push_back(fine[level]);
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
  const std::vector<std::uint8_t> levels = choose_map_levels(points, folder_.index().frame.voxel_m);
  std::vector<SurfacePoint> kept;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (levels[i] == wanted.level) {
      kept.push_back(points[i]);
    }
  }
  return make_payload(kept, shift_m_);
}

}  // namespace berm
