#include "berm/geometry/voxel_hash.hpp"

#include <cfloat>
#include <limits>
#include <map>
#include <set>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;

TEST(VoxelKey, IsTheFloorOfTheCoordinates) {
  EXPECT_EQ(voxel_key({0.0, 0.0, 0.0}, 0.5), (VoxelKey{0, 0, 0}));
  EXPECT_EQ(voxel_key({0.49, 0.5, -0.01}, 0.5), (VoxelKey{0, 1, -1}));
  EXPECT_EQ(voxel_key({-0.5, -0.51, 1e6}, 0.5), (VoxelKey{-1, -2, 2'000'000}));
  EXPECT_EQ(voxel_key({-0.0, 1e-320, -1e-320}, 0.5), (VoxelKey{0, 0, -1}));
}

TEST(VoxelKey, GivesNothingForWhatCannotBeCounted) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  for (const double odd : {std::numeric_limits<double>::quiet_NaN(), kInf, -kInf, DBL_MAX, -DBL_MAX,
                           static_cast<double>(FLT_MAX), 1e12, -1e12}) {
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(voxel_key(odd * Vector3d::Unit(axis), 0.1), std::nullopt) << odd << ", axis " << axis;
      Vector3d point_m(1.0, 2.0, 3.0);
      point_m[axis] = odd;
      EXPECT_EQ(voxel_key(point_m, 0.1), std::nullopt) << odd << ", axis " << axis;
    }
  }
  EXPECT_EQ(voxel_key({kMaxVoxelKey, 0.0, -double(kMaxVoxelKey)}, 1.0), (VoxelKey{kMaxVoxelKey, 0, -kMaxVoxelKey}));
  EXPECT_EQ(voxel_key({kMaxVoxelKey + 1.0, 0.0, 0.0}, 1.0), std::nullopt);
  EXPECT_EQ(voxel_key({1.0, 0.0, 0.0}, 1e-300), std::nullopt) << "a voxel too small to count with";
}

TEST(VoxelKey, ComesBackFromTheMiddleOfItsVoxel) {
  EXPECT_TRUE(rc::check("key(center(key)) = key", [] {
    const auto coordinate = [] { return *rc::gen::inRange<std::int32_t>(-(1 << 30), 1 << 30); };
    const VoxelKey key{coordinate(), coordinate(), coordinate()};
    const double voxel_m = *rc::gen::inRange(1, 1000) * 0.013;
    RC_ASSERT(voxel_key(voxel_center_m(key, voxel_m), voxel_m) == key);
  }));
}

TEST(VoxelKeyHash, SpreadsNeighboursEvenly) {
  // 32^3 voxels into 2^15 buckets by the low bits: 63 % of the buckets are met if the hash were random.
  std::set<std::size_t> buckets;
  for (int x = 0; x < 32; ++x) {
    for (int y = 0; y < 32; ++y) {
      for (int z = 0; z < 32; ++z) {
        buckets.insert(VoxelKeyHash{}({x - 16, y - 16, z - 16}) & 0x7fffU);
      }
    }
  }
  EXPECT_GT(buckets.size(), 20'000U);
}

TEST(VoxelHash, RefusesVoxelsWithoutASize) {
  for (const double size :
       {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(VoxelHash<int>{size}, Error) << size;
  }
}

TEST(VoxelHash, IsEmptyByDefault) {
  VoxelHash<int> map(0.5);
  EXPECT_TRUE(map.empty());
  EXPECT_EQ(map.find({0, 0, 0}), nullptr);
  EXPECT_FALSE(map.erase({0, 0, 0}));
  EXPECT_EQ(map.erase_beyond(Vector3d::Zero(), 1.0), 0U);
  EXPECT_TRUE(map.sorted_keys().empty());
}

TEST(VoxelHash, MakesValuesOnFirstUse) {
  VoxelHash<int> map(0.5);
  EXPECT_EQ(map.at_or_new({1, 2, 3}), 0);
  map.at_or_new({1, 2, 3}) = 5;
  EXPECT_EQ(map.size(), 1U);
  ASSERT_NE(map.find({1, 2, 3}), nullptr);
  *map.find({1, 2, 3}) += 1;
  const VoxelHash<int>& reading = map;
  EXPECT_EQ(*reading.find({1, 2, 3}), 6);
  EXPECT_EQ(reading.find({3, 2, 1}), nullptr);
}

TEST(VoxelHash, AgreesWithAnOrderedMap) {
  EXPECT_TRUE(rc::check("any sequence of insertions and removals", [] {
    VoxelHash<int> map(1.0);
    std::map<VoxelKey, int> expected;
    const int steps = *rc::gen::inRange(0, 400);
    for (int step = 0; step < steps; ++step) {
      const auto coordinate = [] { return *rc::gen::inRange(-4, 4); };
      const VoxelKey key{coordinate(), coordinate(), coordinate()};
      switch (*rc::gen::inRange(0, 8)) {
        case 0:
          RC_ASSERT(map.erase(key) == (expected.erase(key) > 0));
          break;
        case 1: {
          const Vector3d center_m = voxel_center_m(key, 1.0);
          const double radius_m = *rc::gen::inRange(0, 9) + 0.1;
          const std::size_t removed = map.erase_beyond(center_m, radius_m);
          const auto outside = [&](const auto& entry) {
            return (voxel_center_m(entry.first, 1.0) - center_m).norm() > radius_m;
          };
          RC_ASSERT(removed == std::erase_if(expected, outside));
          break;
        }
        default:
          map.at_or_new(key) += step;
          expected[key] += step;
      }
    }
    RC_ASSERT(map.size() == expected.size());
    std::vector<VoxelKey> keys;
    for (const auto& [key, value] : expected) {
      keys.push_back(key);
      RC_ASSERT(map.find(key) != nullptr);
      RC_ASSERT(*map.find(key) == value);
    }
    RC_ASSERT(map.sorted_keys() == keys);
  }));
}

TEST(VoxelHash, ExportsTheSameWhateverItsHistory) {
  VoxelHash<int> forth(1.0);
  VoxelHash<int> back(1.0);
  for (int i = 0; i < 5000; ++i) {
    forth.at_or_new({i % 17, i % 23, i % 29}) = 1;
    back.at_or_new({(4999 - i) % 17, (4999 - i) % 23, (4999 - i) % 29}) = 1;
    back.at_or_new({-1 - i, 0, 0}) = 1;
  }
  back.erase_beyond({14.0, 14.0, 14.0}, 24.5);
  for (int i = 1; i < 30; ++i) {
    back.erase({-i, 0, 0});
  }
  EXPECT_EQ(forth.sorted_keys(), back.sorted_keys());
}

TEST(VoxelHash, KeepsItsMemoryBoundedUnderChurn) {
  // A map of 20 m around a machine that drives 20 km.
  VoxelHash<std::int64_t> map(1.0);
  std::size_t largest = 0;
  for (int step = 0; step < 20'000; ++step) {
    for (int y = -20; y <= 20; ++y) {
      map.at_or_new({step + 20, y, 0}) = step;
    }
    if (step % 10 == 0) {
      map.erase_beyond({static_cast<double>(step), 0.0, 0.0}, 20.0);
    }
    largest = std::max(largest, map.size());
    ASSERT_LE(map.capacity(), 16'384U) << step;
  }
  EXPECT_LT(largest, 2500U);
}

TEST(VoxelHash, GivesMemoryBackAfterAPeak) {
  VoxelHash<int> map(1.0);
  for (int i = 0; i < 100'000; ++i) {
    map.at_or_new({i, 0, 0}) = i;
  }
  const std::size_t peak = map.capacity();
  map.erase_beyond(Vector3d::Zero(), 100.0);
  map.at_or_new({0, 1, 0}) = 1;
  EXPECT_LT(map.capacity(), peak / 100);
  EXPECT_EQ(*map.find({50, 0, 0}), 50);
}

}  // namespace
}  // namespace berm
