#include <cmath>
#include <cstring>
#include <limits>
#include <optional>
#include <sstream>
#include <utility>

#include <octomap/ColorOcTree.h>

#include "berm/core/error.hpp"
#include "berm/map/edge_map.hpp"
#include "octomap_header.hpp"

namespace berm {
namespace {

/// Lowest and highest key along one axis.
struct Extent {
  std::int32_t low = std::numeric_limits<std::int32_t>::max();
  std::int32_t high = std::numeric_limits<std::int32_t>::min();

  void add(std::int32_t key) {
    low = std::min(low, key);
    high = std::max(high, key);
  }
};

/// OctoMap's origin on one axis: that of the world if the map lies around it, else near the map's middle, at a round
/// number of voxels if these fit. It follows from what is in the map alone, not from what came first. None: too wide.
std::optional<std::int32_t> choose_origin(const Extent& extent) {
  const auto fits = [&](std::int32_t origin) {
    return extent.low >= origin - kOctomapHalfRange && extent.high < origin + kOctomapHalfRange;
  };
  constexpr std::int32_t kRound = 5000;  // voxels; 1 km at 0.2 m
  const std::int32_t middle = extent.low + (extent.high - extent.low + 1) / 2;
  const auto rounded = static_cast<std::int32_t>(std::lround(static_cast<double>(middle) / kRound)) * kRound;
  for (const std::int32_t origin : {0, rounded, middle}) {
    if (fits(origin)) {
      return origin;
    }
  }
  return std::nullopt;
}

VoxelKey find_origin(const EdgeMap& map) {
  std::array<Extent, 3> extents;
  map.for_each([&](const VoxelKey& key, const EdgeMap::Voxel&) {
    extents[0].add(key.x);
    extents[1].add(key.y);
    extents[2].add(key.z);
  });
  const auto x = choose_origin(extents[0]);
  const auto y = choose_origin(extents[1]);
  const auto z = choose_origin(extents[2]);
  if (!x || !y || !z) {
    throw Error(ErrorCode::invalid_argument,
                "edge map: it spans more than the 65536 voxels that an OctoMap holds (" +
                    std::to_string(2 * kOctomapHalfRange * map.config().voxel_m) +
                    " m). Did a pose jump? Otherwise use larger voxels, or a map for each part");
  }
  return {*x, *y, *z};
}

/// Reads the nodes of a tree, none of which is trusted.
class TreeReader {
 public:
  /// `bytes` is the whole file, with a tree of `header.nodes` nodes at its end, all of which are there.
  TreeReader(std::string_view bytes, const std::string& name, const ParsedOctomapHeader& parsed)
      : bytes_(bytes), name_(name), origin_(parsed.header.origin), position_(parsed.bytes) {}

  /// Calls `take(key, voxel)` for every voxel.
  template <typename Take>
  void read(Take&& take) {
    if (position_ < bytes_.size()) {
      read_node(kOctomapDepth, {0, 0, 0}, take);
    }
    if (position_ != bytes_.size()) {
      throw error(ErrorCode::malformed, "the tree ends here, more nodes follow");
    }
  }

 private:
  [[nodiscard]] FileError error(ErrorCode code, const std::string& problem) const {
    return {code, name_, position_, problem};
  }

  /// `levels`: below this node; `key` has the bits that were decided on the way down. As deep as the tree, not more.
  template <typename Take>
  void read_node(int levels, const VoxelKey& key, Take& take) {
    if (position_ == bytes_.size()) {
      throw error(ErrorCode::truncated, "the file ends where a child was announced");
    }
    float log_odds = 0.0F;
    std::memcpy(&log_odds, bytes_.data() + position_, sizeof(log_odds));
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes_[position_ + i]); };
    const EdgeMap::Voxel voxel{byte(4), byte(5), byte(6)};
    const unsigned children = byte(7);
    if (!std::isfinite(log_odds)) {
      throw error(ErrorCode::malformed, "a node's log-odds are not finite");
    }
    if (levels == 0) {
      if (children != 0 || !voxel.is_seen()) {
        throw error(ErrorCode::malformed, children != 0 ? "a voxel with children" : "a voxel without any count");
      }
      position_ += kOctomapNodeBytes;
      take(VoxelKey{key.x - kOctomapHalfRange + origin_.x, key.y - kOctomapHalfRange + origin_.y,
                    key.z - kOctomapHalfRange + origin_.z},
           voxel);
      return;
    }
    if (children == 0) {
      throw error(ErrorCode::unsupported, "a leaf above the level of voxels: was the tree pruned by another tool?");
    }
    position_ += kOctomapNodeBytes;
    for (int child = 0; child < 8; ++child) {
      if (((children >> static_cast<unsigned>(child)) & 1U) != 0) {
        const int shift = levels - 1;
        read_node(levels - 1,
                  {key.x | ((child & 1) << shift), key.y | (((child >> 1) & 1) << shift),
                   key.z | (((child >> 2) & 1) << shift)},
                  take);
      }
    }
  }

  std::string_view bytes_;
  const std::string& name_;
  VoxelKey origin_;
  std::size_t position_;
};

}  // namespace

std::string EdgeMap::to_octomap() const {
  const VoxelKey origin = empty() ? VoxelKey{} : find_origin(*this);
  octomap::ColorOcTree tree(config_.voxel_m);
  for_each([&](const VoxelKey& key, const Voxel& voxel) {
    const auto octomap_key = [](std::int32_t value, std::int32_t from) {
      return static_cast<octomap::key_type>(value - from + kOctomapHalfRange);
    };
    const octomap::OcTreeKey place(octomap_key(key.x, origin.x), octomap_key(key.y, origin.y),
                                   octomap_key(key.z, origin.z));
    octomap::ColorOcTreeNode* node = tree.setNodeValue(place, 0.0F, true);
    // Written past the tree's own clamps, which are in its settings and not in the file.
    node->setLogOdds(static_cast<float>(log_odds(voxel)));
    node->setColor(voxel.left, voxel.right, voxel.miss);
  });
  if (!empty()) {  // OctoMap would follow the root that an empty tree does not have
    tree.updateInnerOccupancy();
  }
  std::ostringstream out;
  out << write_octomap_header({origin, world_, tree.size(), config_.voxel_m});
  tree.writeData(out);
  return std::move(out).str();
}

EdgeMap EdgeMap::from_octomap(std::string_view bytes, const std::string& name, const EdgeMapConfig& config) {
  config.check();
  const ParsedOctomapHeader parsed = parse_octomap_header(bytes, name);
  EdgeMapConfig own = config;
  own.voxel_m = parsed.header.voxel_m;
  EdgeMap map(own, parsed.header.world);
  TreeReader(bytes, name, parsed).read([&](const VoxelKey& key, const Voxel& voxel) { map.add(key, voxel); });
  return map;
}

}  // namespace berm
