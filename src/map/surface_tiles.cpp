#include "berm/map/surface_tiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace berm {
namespace {

constexpr std::int32_t kCellVoxels = 4;
/// How near to the middle of what was met a beam has to pass: half the side of a voxel at the default, which keeps
/// poles and posts, whose middle a beam only passes this near by going through it.
constexpr double kSameSurface_m = 0.08;
/// How far it has to go on: cells are 0.4 m wide at the default, and things lean.
constexpr double kBeyond_m = 0.6;
/// Nearer, 1 deg is less than kSameSurface_m; farther, cells are met by too few beams.
constexpr double kLeastLook_m = 1.5;
constexpr double kMostLook_m = 50.0;
constexpr std::uint16_t kLeastPasses = 2 * SurfaceTiles::kStride;
/// Of a cell that was met in fewer scans its neighbours may decide: most of them, and so many, are gone.
constexpr std::uint16_t kFewHits = 20;
constexpr int kLeastGone = 3;
/// A mean over more points does not get better, and follows the snow as it is groomed.
constexpr std::uint32_t kMostInMean = 5000;
constexpr std::size_t kVoteKinds = 3;

std::int32_t floor_div(std::int32_t value, std::int32_t by) {
  return value / by - (value % by < 0 ? 1 : 0);
}

std::optional<std::size_t> vote_of(Label label) {
  switch (label) {
    case Label::drivable:
      return 0;
    case Label::terrain:
      return 1;
    case Label::obstacle:
      return 2;
    case Label::unlabeled:
    case Label::no_return:
    case Label::falling_snow:
      break;
  }
  return std::nullopt;
}

/// Of equals the first: what can be driven on has to be seen as such more often than not.
Label majority(const std::uint16_t (&votes)[kVoteKinds]) {
  if (votes[2] >= votes[0] && votes[2] >= votes[1]) {
    return Label::obstacle;
  }
  return votes[1] >= votes[0] ? Label::terrain : Label::drivable;
}

void add_vote(std::uint16_t (&votes)[kVoteKinds], std::size_t kind) {
  if (votes[kind] == std::numeric_limits<std::uint16_t>::max()) {
    for (std::uint16_t& vote : votes) {
      vote = static_cast<std::uint16_t>(vote / 2U);
    }
  }
  ++votes[kind];
}

void add_saturating(std::uint16_t& count, std::uint16_t more) {
  const unsigned sum = unsigned{count} + more;
  count = static_cast<std::uint16_t>(std::min<unsigned>(sum, std::numeric_limits<std::uint16_t>::max()));
}

VoxelKey cell_of(const VoxelKey& voxel) {
  return {floor_div(voxel.x, kCellVoxels), floor_div(voxel.y, kCellVoxels), floor_div(voxel.z, kCellVoxels)};
}

/// The float nearest to `lower + offset` that still lies in the voxel: what is written is read back into it.
float rounded_within(double lower_m, float offset_m, std::int32_t key, double voxel_m) {
  auto rounded = static_cast<float>(lower_m + double{offset_m});
  while (std::floor(double{rounded} / voxel_m) < key) {
    rounded = std::nextafter(rounded, std::numeric_limits<float>::max());
  }
  while (std::floor(double{rounded} / voxel_m) > key) {
    rounded = std::nextafter(rounded, std::numeric_limits<float>::lowest());
  }
  return rounded;
}

/// One tile in kStride at a scan, all in turn.
bool is_its_turn(const TileKey& key, std::uint32_t scan) {
  const auto place = static_cast<std::uint32_t>(key.x) * 2U + static_cast<std::uint32_t>(key.y);
  return (place + scan) % SurfaceTiles::kStride == 0;
}

}  // namespace

void SurfaceMapConfig::check() const {
  check_fields(*this, "mapping");
  check_problem("mapping", "cell_m", cell_m < voxel_m || cell_m > tile_m ? "expected voxel_m to tile_m" : "");
  check_problem("mapping", "keep_m", keep_m <= max_range_m ? "expected more than max_range_m" : "");
}

SurfaceTiles::SurfaceTiles(const SurfaceMapConfig& config, const Eigen::Vector3d& origin_m, SurfaceStore& store)
    : config_(config),
      origin_m_(origin_m),
      store_(store),
      tile_voxels_(static_cast<std::int32_t>(std::max(1.0, std::round(config.tile_m / config.voxel_m)))),
      cell_m_(kCellVoxels * config.voxel_m) {
  config_.check();
}

std::size_t SurfaceTiles::voxels_in_memory() const {
  std::size_t voxels = 0;
  for (const auto& [key, tile] : tiles_) {
    voxels += tile.voxels.size();
  }
  return voxels;
}

void SurfaceTiles::add(const SurfaceScan& scan) {
  ++scans_;
  new_cells_.clear();
  for (const SurfaceSample& sample : scan.samples) {
    add_sample(sample);
  }
  if (config_.remove_moved) {
    look_back();
    look_through(scan);
    remember(scan);
  }
  give_away(scan.sensor_m);
}

void SurfaceTiles::add_sample(const SurfaceSample& sample) {
  const Eigen::Vector3d from_origin_m = sample.place_m - origin_m_;
  const auto key = voxel_key(from_origin_m, config_.voxel_m);
  const auto kind = vote_of(sample.label);
  if (!key || !kind) {
    ++counts_.left_out;
    return;
  }
  Tile& tile = tile_at(tile_of(*key));
  Voxel& voxel = tile.voxels[*key];
  voxel.count += voxel.count < std::numeric_limits<std::uint32_t>::max() ? 1U : 0U;
  const float share = 1.0F / static_cast<float>(std::min(voxel.count, kMostInMean));
  const std::array<std::int32_t, 3> lower = {key->x, key->y, key->z};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double offset_m = from_origin_m[static_cast<Eigen::Index>(axis)] - lower[axis] * config_.voxel_m;
    voxel.offset_m[axis] += share * (static_cast<float>(offset_m) - voxel.offset_m[axis]);
  }
  voxel.intensity += share * (sample.intensity - voxel.intensity);
  add_vote(voxel.votes, *kind);
  ++counts_.points;
  if (config_.remove_moved && sample.label == Label::obstacle) {
    hit(tile, *key, from_origin_m);
  }
}

TileKey SurfaceTiles::tile_of(const VoxelKey& key) const {
  return {floor_div(key.x, tile_voxels_), floor_div(key.y, tile_voxels_)};
}

SurfaceTiles::Tile& SurfaceTiles::tile_at(const TileKey& key) {
  if (tile_ == nullptr || tile_key_ != key) {
    const auto [place, is_new] = tiles_.try_emplace(key);
    if (is_new) {
      load(key, place->second);
    }
    tile_ = &place->second;
    tile_key_ = key;
  }
  return *tile_;
}

void SurfaceTiles::hit(Tile& tile, const VoxelKey& voxel, const Eigen::Vector3d& from_origin_m) {
  const VoxelKey key = cell_of(voxel);
  const auto [place, is_new] = tile.cells.try_emplace(key);
  Cell& cell = place.value();
  if (is_new) {
    new_cells_.push_back({tile_key_, key});
  }
  if (cell.last_hit != scans_) {
    cell.last_hit = scans_;
    cell.since_hit = 0;
    add_saturating(cell.hits, 1);
  }
  cell.points += cell.points < kMostInMean ? 1U : 0U;
  const Eigen::Vector3f offset_m = (from_origin_m - voxel_center_m(key, cell_m_)).cast<float>();
  cell.mean_m += (offset_m - cell.mean_m) / static_cast<float>(cell.points);
}

Eigen::Vector3d SurfaceTiles::place_m(const VoxelKey& cell, const Cell& evidence) const {
  return origin_m_ + voxel_center_m(cell, cell_m_) + evidence.mean_m.cast<double>();
}

bool SurfaceTiles::was_looked_through(const Cell& cell) {
  return cell.since_hit >= kGone || (cell.passes >= kLeastPasses && cell.passes >= cell.hits);
}

bool SurfaceTiles::has_moved(const Tile& tile, const VoxelKey& key, const Cell& cell) {
  if (was_looked_through(cell)) {
    return true;
  }
  if (cell.hits > kFewHits) {
    return false;
  }
  int gone = 0;
  int stands = 0;
  for (std::int32_t z = -1; z <= 1; ++z) {
    for (std::int32_t y = -1; y <= 1; ++y) {
      for (std::int32_t x = -1; x <= 1; ++x) {
        const auto place = tile.cells.find({key.x + x, key.y + y, key.z + z});
        if (place != tile.cells.end() && place->first != key) {
          ++(was_looked_through(place->second) ? gone : stands);
        }
      }
    }
  }
  return gone >= kLeastGone && gone > stands;
}

/// What was there before the thing that is met now?
void SurfaceTiles::look_back() {
  for (const NewCell& found : new_cells_) {
    Cell& cell = tiles_.at(found.tile).cells.find(found.cell).value();
    const Eigen::Vector3d middle_m = place_m(found.cell, cell);
    for (const std::vector<BeamImage>& images : history_) {
      const bool seen_through = std::any_of(images.begin(), images.end(), [&](const BeamImage& image) {
        return image.sees_through(middle_m, kSameSurface_m, kBeyond_m);
      });
      add_saturating(cell.passes, seen_through ? kStride : std::uint16_t{0});
    }
  }
}

void SurfaceTiles::look_through(const SurfaceScan& scan) {
  for (auto& [key, tile] : tiles_) {
    if (!is_its_turn(key, scans_) || distance_m(key, scan.sensor_m) > kMostLook_m) {
      continue;
    }
    // The cells are independent of each other, so that their order is of no matter.
    for (auto place = tile.cells.begin(); place != tile.cells.end(); ++place) {
      const Eigen::Vector3d middle_m = place_m(place->first, place->second);
      const double range_m = (middle_m - scan.sensor_m).norm();
      if (place->second.last_hit == scans_ || range_m < kLeastLook_m || range_m > kMostLook_m) {
        continue;
      }
      const bool seen_through = std::any_of(scan.beams.begin(), scan.beams.end(), [&](const BeamImage& image) {
        return image.sees_through(middle_m, kSameSurface_m, kBeyond_m);
      });
      if (seen_through) {
        add_saturating(place.value().passes, kStride);
        add_saturating(place.value().since_hit, kStride);
      }
    }
  }
}

void SurfaceTiles::remember(const SurfaceScan& scan) {
  if (scans_ % kStride != 0) {
    return;
  }
  history_.push_back(scan.beams);
  if (history_.size() > kHistory) {
    history_.pop_front();
  }
}

double SurfaceTiles::distance_m(const TileKey& key, const Eigen::Vector3d& sensor_m) const {
  const Eigen::Vector2d low_m = origin_m_.head<2>() + tile_m() * Eigen::Vector2d(key.x, key.y);
  const Eigen::Vector2d nearest_m =
      sensor_m.head<2>().cwiseMax(low_m).cwiseMin(low_m + Eigen::Vector2d::Constant(tile_m()));
  return (nearest_m - sensor_m.head<2>()).norm();
}

void SurfaceTiles::give_away(const Eigen::Vector3d& sensor_m) {
  const std::uint64_t saved_before = counts_.saved;
  for (auto place = tiles_.begin(); place != tiles_.end();) {
    if (distance_m(place->first, sensor_m) > config_.keep_m) {
      save(place->first, place->second);
      place = tiles_.erase(place);
    } else {
      ++place;
    }
  }
  if (counts_.saved != saved_before) {
    tile_ = nullptr;
    store_.commit();
  }
}

void SurfaceTiles::finish() {
  for (const auto& [key, tile] : tiles_) {
    save(key, tile);
  }
  tiles_.clear();
  tile_ = nullptr;
  store_.commit();
}

void SurfaceTiles::save(const TileKey& key, const Tile& tile) {
  std::vector<VoxelKey> keys;
  keys.reserve(tile.voxels.size());
  for (const auto& [voxel_key, voxel] : tile.voxels) {
    keys.push_back(voxel_key);
  }
  std::sort(keys.begin(), keys.end());
  points_.clear();
  for (const VoxelKey& at : keys) {
    const Voxel& voxel = tile.voxels.find(at)->second;
    SurfacePoint point{.intensity = voxel.intensity,
                       .label = majority(voxel.votes),
                       .count = voxel.count,
                       .drivable = voxel.votes[0],
                       .terrain = voxel.votes[1],
                       .obstacle = voxel.votes[2]};
    // A machine's own tracks are taken for terrain.
    const auto cell = point.label == Label::drivable ? tile.cells.end() : tile.cells.find(cell_of(at));
    if (cell != tile.cells.end()) {
      if (has_moved(tile, cell->first, cell->second)) {
        ++counts_.moved;
        continue;
      }
      point.hits = point.label == Label::obstacle ? cell->second.hits : std::uint16_t{0};
      point.passes = point.label == Label::obstacle ? cell->second.passes : std::uint16_t{0};
    }
    point.x_m = rounded_within(at.x * config_.voxel_m, voxel.offset_m[0], at.x, config_.voxel_m);
    point.y_m = rounded_within(at.y * config_.voxel_m, voxel.offset_m[1], at.y, config_.voxel_m);
    point.z_m = rounded_within(at.z * config_.voxel_m, voxel.offset_m[2], at.z, config_.voxel_m);
    points_.push_back(point);
  }
  store_.save(key, points_);
  ++counts_.saved;
}

void SurfaceTiles::load(const TileKey& key, Tile& tile) {
  const std::vector<SurfacePoint> points = store_.load(key);
  counts_.loaded += points.empty() ? 0U : 1U;
  for (const SurfacePoint& point : points) {
    const Eigen::Vector3d from_origin_m(point.x_m, point.y_m, point.z_m);
    const auto at = voxel_key(from_origin_m, config_.voxel_m);
    if (!at) {
      continue;
    }
    Voxel& voxel = tile.voxels[*at];
    const std::array<std::int32_t, 3> lower = {at->x, at->y, at->z};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      voxel.offset_m[axis] =
          static_cast<float>(from_origin_m[static_cast<Eigen::Index>(axis)] - lower[axis] * config_.voxel_m);
    }
    voxel.intensity = point.intensity;
    voxel.count = point.count;
    voxel.votes[0] = point.drivable;
    voxel.votes[1] = point.terrain;
    voxel.votes[2] = point.obstacle;
    if (point.hits > 0) {
      Cell& cell = tile.cells[cell_of(*at)];
      cell.hits = std::max(cell.hits, point.hits);
      cell.passes = std::max(cell.passes, point.passes);
      cell.points += point.obstacle;
      const Eigen::Vector3f offset_m = (from_origin_m - voxel_center_m(cell_of(*at), cell_m_)).cast<float>();
      cell.mean_m += static_cast<float>(point.obstacle) / static_cast<float>(cell.points) * (offset_m - cell.mean_m);
    }
  }
}

}  // namespace berm
