#pragma once

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <tsl/robin_map.h>

namespace berm {

/// A voxel of a cubic lattice: floor of the coordinates divided by its side.
struct VoxelKey {
  std::int32_t x = 0;
  std::int32_t y = 0;
  std::int32_t z = 0;

  friend constexpr bool operator==(const VoxelKey&, const VoxelKey&) = default;
  friend constexpr auto operator<=>(const VoxelKey&, const VoxelKey&) = default;
};

/// Keys lie in [-kMaxVoxelKey, kMaxVoxelKey], so that neighbours of a voxel can be counted out without overflow.
constexpr std::int32_t kMaxVoxelKey = 1 << 30;

/// The voxel of side `voxel_m` (> 0) that holds a point; none for NaN, Inf and what lies too far out to be counted.
[[nodiscard]] inline std::optional<VoxelKey> voxel_key(const Eigen::Vector3d& point_m, double voxel_m) {
  const Eigen::Vector3d place = point_m / voxel_m;
  // Compared as doubles, because casting NaN or what no integer holds is undefined.
  const auto countable = [](double value) { return value >= -kMaxVoxelKey && value < kMaxVoxelKey + 1.0; };
  if (!countable(place.x()) || !countable(place.y()) || !countable(place.z())) {
    return std::nullopt;
  }
  // std::floor is a call where the instruction set has no rounding.
  const auto floor_of = [](double value) {
    const auto cut = static_cast<std::int32_t>(value);
    return cut - (value < cut ? 1 : 0);
  };
  return VoxelKey{floor_of(place.x()), floor_of(place.y()), floor_of(place.z())};
}

/// Middle of a voxel.
[[nodiscard]] inline Eigen::Vector3d voxel_center_m(const VoxelKey& key, double voxel_m) {
  return {(key.x + 0.5) * voxel_m, (key.y + 0.5) * voxel_m, (key.z + 0.5) * voxel_m};
}

/// Spreads neighbouring keys over all bits.
struct VoxelKeyHash {
  [[nodiscard]] std::size_t operator()(const VoxelKey& key) const noexcept {
    const auto bits = [](std::int32_t value) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(value)); };
    return static_cast<std::size_t>(stir(stir(bits(key.x) | (bits(key.y) << 32U)) + bits(key.z)));
  }

 private:
  /// Last step of splitmix64 (Steele, Lea, Flood 2014): every bit of the input changes half of the output.
  [[nodiscard]] static std::uint64_t stir(std::uint64_t bits) noexcept {
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31U);
  }
};

/// Values of the voxels that have one. Memory follows the number of voxels, also down, after the next insertion.
/// Voxels are met in the order of their keys wherever that order can reach a result.
template <typename T>
class VoxelHash {
 public:
  /// Throws Error(invalid_argument) unless `voxel_m` is finite and positive.
  explicit VoxelHash(double voxel_m);

  [[nodiscard]] double voxel_m() const { return voxel_m_; }
  [[nodiscard]] std::size_t size() const { return map_.size(); }
  [[nodiscard]] bool empty() const { return map_.empty(); }
  /// Voxels that there is room for, a measure of the memory held.
  [[nodiscard]] std::size_t capacity() const { return map_.bucket_count(); }

  [[nodiscard]] std::optional<VoxelKey> key_of(const Eigen::Vector3d& point_m) const {
    return voxel_key(point_m, voxel_m_);
  }

  /// The value of a voxel, made by T{} if there was none. Valid until the next insertion or removal.
  T& at_or_new(const VoxelKey& key) { return map_[key]; }

  /// The value of a voxel, or null. Valid until the next insertion or removal.
  [[nodiscard]] T* find(const VoxelKey& key) {
    const auto i = map_.find(key);
    return i == map_.end() ? nullptr : &i.value();
  }
  [[nodiscard]] const T* find(const VoxelKey& key) const {
    const auto i = map_.find(key);
    return i == map_.end() ? nullptr : &i->second;
  }

  /// Whether there was something to remove.
  bool erase(const VoxelKey& key) { return map_.erase(key) > 0; }

  /// Removes every voxel whose middle is farther than `radius_m` from `center_m`. Returns how many.
  std::size_t erase_beyond(const Eigen::Vector3d& center_m, double radius_m);

  void clear() { map_.clear(); }

  /// All keys in ascending order: the same whatever the history of the map.
  [[nodiscard]] std::vector<VoxelKey> sorted_keys() const;

 private:
  double voxel_m_;
  tsl::robin_map<VoxelKey, T, VoxelKeyHash> map_;
};

namespace detail {
/// Returns `voxel_m`, or throws Error(invalid_argument).
double checked_voxel_m(double voxel_m);
}  // namespace detail

template <typename T>
VoxelHash<T>::VoxelHash(double voxel_m) : voxel_m_(detail::checked_voxel_m(voxel_m)) {
  // Below this load the next insertion gives memory back: a map that follows a machine must not stay at its peak.
  constexpr float kShrinkBelow = 0.1F;
  map_.min_load_factor(kShrinkBelow);
}

template <typename T>
std::size_t VoxelHash<T>::erase_beyond(const Eigen::Vector3d& center_m, double radius_m) {
  const std::size_t before = map_.size();
  for (auto i = map_.begin(); i != map_.end();) {
    const double distance_m = (voxel_center_m(i->first, voxel_m_) - center_m).norm();
    i = distance_m > radius_m ? map_.erase(i) : std::next(i);
  }
  return before - map_.size();
}

template <typename T>
std::vector<VoxelKey> VoxelHash<T>::sorted_keys() const {
  std::vector<VoxelKey> keys;
  keys.reserve(map_.size());
  for (const auto& [key, value] : map_) {
    keys.push_back(key);
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

}  // namespace berm
