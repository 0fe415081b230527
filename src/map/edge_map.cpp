#include "berm/map/edge_map.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "berm/core/error.hpp"

namespace berm {
namespace {

double log_of_odds(double probability) {
  return std::log(probability / (1.0 - probability));
}

bool is_world_name(std::string_view text) {
  const auto printable = [](char c) { return c >= ' ' && c <= '~'; };
  return text.size() <= EdgeMap::kMaxWorldName && std::all_of(text.begin(), text.end(), printable) &&
         (text.empty() || (text.front() != ' ' && text.back() != ' '));
}

std::uint8_t saturating_sum(std::uint8_t a, std::uint8_t b) {
  return static_cast<std::uint8_t>(std::min(a + b, 255));
}

/// Sorted, each once.
void make_unique(std::vector<VoxelKey>& keys) {
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
}

/// Neighbours along a ring often share their voxel: half of the sorting is saved here.
void append(std::vector<VoxelKey>& keys, const VoxelKey& key) {
  if (keys.empty() || keys.back() != key) {
    keys.push_back(key);
  }
}

}  // namespace

EdgeOdds edge_odds(const EdgeMapConfig& config) {
  return {.hit = log_of_odds(config.hit_probability),
          .miss = log_of_odds(config.miss_probability),
          .min = log_of_odds(config.min_probability),
          .max = log_of_odds(config.max_probability),
          .edge = log_of_odds(config.edge_probability)};
}

EdgeMap::EdgeMap(const EdgeMapConfig& config, std::string world)
    : config_((config.check(), config)), odds_(edge_odds(config)), world_(std::move(world)), slabs_(config.voxel_m) {
  if (!is_world_name(world_)) {
    throw Error(ErrorCode::invalid_argument, "edge map: the name of the world is not one line of up to " +
                                                 std::to_string(kMaxWorldName) + " printable characters");
  }
}

std::size_t EdgeMap::add_scan(std::span<const MappedEdge> edges, std::span<const Eigen::Vector3d> plain_m) {
  auto& [left, right, plain] = keys_;
  left.clear();
  right.clear();
  plain.clear();
  std::size_t left_out = 0;
  for (const MappedEdge& edge : edges) {
    const auto key = slabs_.key_of(edge.position_m);
    if (key) {
      append(edge.side == EdgeSide::left ? left : right, *key);
    } else {
      ++left_out;
    }
  }
  for (const Eigen::Vector3d& position_m : plain_m) {
    const auto key = slabs_.key_of(position_m);
    if (key) {
      append(plain, *key);
    } else {
      ++left_out;
    }
  }
  for (std::vector<VoxelKey>& keys : keys_) {
    make_unique(keys);
  }
  for (const VoxelKey& key : left) {
    add(key, {.left = 1});
  }
  for (const VoxelKey& key : right) {
    add(key, {.right = 1});
  }
  for (const VoxelKey& key : plain) {
    if (!std::binary_search(left.begin(), left.end(), key) && !std::binary_search(right.begin(), right.end(), key)) {
      add(key, {.miss = 1});
    }
  }
  return left_out;
}

void EdgeMap::merge(const EdgeMap& other) {
  if (config_.voxel_m != other.config_.voxel_m) {
    throw Error(ErrorCode::invalid_argument, "edge map: voxels of " + std::to_string(config_.voxel_m) + " m and of " +
                                                 std::to_string(other.config_.voxel_m) + " m cannot be merged");
  }
  if (world_ != other.world_) {
    throw Error(ErrorCode::invalid_argument,
                "edge map: maps of different worlds, '" + world_ + "' and '" + other.world_ + "', cannot be merged");
  }
  if (&other == this) {
    merge(EdgeMap(other));
    return;
  }
  other.for_each([this](const VoxelKey& key, const Voxel& voxel) { add(key, voxel); });
}

EdgeMap::Voxel EdgeMap::at(const VoxelKey& key) const {
  const Slab* slab = slabs_.find(slab_of(key));
  return slab == nullptr ? Voxel{} : (*slab)[place_in_slab(key)];
}

std::size_t EdgeMap::memory_bytes() const {
  // A bucket of the hash holds the distance to its home beside key and value.
  constexpr std::size_t kBucket = sizeof(VoxelKey) + sizeof(Slab) + 4;
  std::size_t bytes = sizeof(*this) + slabs_.capacity() * kBucket;
  for (const std::vector<VoxelKey>& keys : keys_) {
    bytes += keys.capacity() * sizeof(VoxelKey);
  }
  return bytes;
}

double EdgeMap::log_odds(const Voxel& voxel, EdgeSide side) const {
  const int hits = side == EdgeSide::left ? voxel.left : voxel.right;
  return std::clamp(hits * odds_.hit + voxel.miss * odds_.miss, odds_.min, odds_.max);
}

double EdgeMap::log_odds(const Voxel& voxel) const {
  const int hits = voxel.left + voxel.right;
  return std::clamp(hits * odds_.hit + voxel.miss * odds_.miss, odds_.min, odds_.max);
}

bool EdgeMap::is_edge(const Voxel& voxel, EdgeSide side) const {
  return log_odds(voxel, side) >= odds_.edge;
}

void EdgeMap::add(const VoxelKey& key, const Voxel& counts) {
  Voxel& voxel = slabs_.at_or_new(slab_of(key))[place_in_slab(key)];
  size_ += voxel.is_seen() ? 0U : 1U;
  voxel.left = saturating_sum(voxel.left, counts.left);
  voxel.right = saturating_sum(voxel.right, counts.right);
  voxel.miss = saturating_sum(voxel.miss, counts.miss);
}

}  // namespace berm
