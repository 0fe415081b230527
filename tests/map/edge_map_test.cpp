#include "berm/map/edge_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"
#include "berm/map/reference_edge_map.hpp"
#include "made_edges.hpp"

namespace berm {
namespace {

using Eigen::Vector3d;

/// Few voxels and many scans, so that counts meet and some are full; some points no map can hold.
std::vector<test::MadeScan> random_scans(std::uint64_t seed, int scans) {
  std::mt19937_64 random(seed);
  const Vector3d around_m(random() % 2 == 0 ? 0.0 : 5e5, random() % 2 == 0 ? -3.0 : 5e6, 100.0);
  const auto somewhere = [&]() -> Vector3d {
    if (random() % 50 == 0) {
      return {std::numeric_limits<double>::quiet_NaN(), 1.0, 1e300};
    }
    return around_m + Vector3d(test::made_uniform(random), 4.0 * test::made_uniform(random), 0.3);
  };
  std::vector<test::MadeScan> made(static_cast<std::size_t>(scans));
  for (test::MadeScan& scan : made) {
    for (std::uint64_t i = random() % 8; i > 0; --i) {
      scan.edges.push_back({somewhere(), random() % 2 == 0 ? EdgeSide::left : EdgeSide::right});
    }
    for (std::uint64_t i = random() % 30; i > 0; --i) {
      scan.plain_m.push_back(somewhere());
    }
  }
  return made;
}

EdgeVoxel at(const EdgeMap& map, const Vector3d& place_m) {
  return map.at(*voxel_key(place_m, map.config().voxel_m));
}

TEST(EdgeMap, CountsAScanOncePerVoxelAndSide) {
  EdgeMap map({});
  const std::vector<MappedEdge> edges = {{{0.05, 0.05, 0.05}, EdgeSide::left},
                                         {{0.15, 0.05, 0.05}, EdgeSide::left},
                                         {{0.10, 0.10, 0.10}, EdgeSide::right},
                                         {{0.30, 0.05, 0.05}, EdgeSide::right}};
  const std::vector<Vector3d> plain_m = {{0.1, 0.1, 0.1}, {0.5, 0.1, 0.1}, {0.55, 0.1, 0.1}, {-0.1, -0.1, -0.1}};
  EXPECT_EQ(map.add_scan(edges, plain_m), 0U);
  EXPECT_EQ(at(map, {0.1, 0.1, 0.1}), (EdgeVoxel{1, 1, 0}));
  EXPECT_EQ(at(map, {0.3, 0.1, 0.1}), (EdgeVoxel{0, 1, 0}));
  EXPECT_EQ(at(map, {0.5, 0.1, 0.1}), (EdgeVoxel{0, 0, 1}));
  EXPECT_EQ(at(map, {-0.1, -0.1, -0.1}), (EdgeVoxel{0, 0, 1}));
  EXPECT_EQ(at(map, {0.7, 0.1, 0.1}), EdgeVoxel{});
  EXPECT_EQ(map.size(), 4U);
  map.add_scan(edges, plain_m);
  EXPECT_EQ(at(map, {0.1, 0.1, 0.1}), (EdgeVoxel{2, 2, 0}));
  EXPECT_EQ(map.size(), 4U);
}

TEST(EdgeMap, LeavesOutWhatItCannotCount) {
  EdgeMap map({});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(map.add_scan(std::vector<MappedEdge>{{{nan, 0.0, 0.0}, EdgeSide::left}, {{0.0, 0.0, 1e12}}},
                         std::vector<Vector3d>{{0.0, -infinity, 0.0}, {1.0, 1.0, 1.0}}),
            3U);
  EXPECT_EQ(map.size(), 1U);
}

TEST(EdgeMap, CountsStopAt255) {
  EdgeMap map({});
  const std::vector<MappedEdge> edges = {{{0.1, 0.1, 0.1}, EdgeSide::left}};
  for (int scan = 0; scan < 300; ++scan) {
    map.add_scan(edges, {});
  }
  EXPECT_EQ(at(map, {0.1, 0.1, 0.1}).left, 255);
  map.merge(map);
  EXPECT_EQ(at(map, {0.1, 0.1, 0.1}), (EdgeVoxel{255, 0, 0}));
}

TEST(EdgeMap, LogOddsByHand) {
  const EdgeMap map({});
  EXPECT_NEAR(map.log_odds({1, 0, 0}, EdgeSide::left), std::log(0.7 / 0.3), 1e-12);
  EXPECT_NEAR(map.log_odds({2, 0, 3}, EdgeSide::left), 2 * std::log(0.7 / 0.3) + 3 * std::log(0.4 / 0.6), 1e-12);
  EXPECT_NEAR(map.log_odds({9, 0, 0}, EdgeSide::left), std::log(0.97 / 0.03), 1e-12);
  EXPECT_NEAR(map.log_odds({0, 0, 200}, EdgeSide::right), std::log(0.12 / 0.88), 1e-12);
  EXPECT_NEAR(map.log_odds({1, 1, 0}), 2 * std::log(0.7 / 0.3), 1e-12);
  EXPECT_TRUE(map.is_edge({1, 0, 0}, EdgeSide::left));
  EXPECT_FALSE(map.is_edge({1, 0, 0}, EdgeSide::right));
  EXPECT_FALSE(map.is_edge({1, 0, 1}, EdgeSide::left));
}

TEST(EdgeMap, SameBytesForAnyOrderOfScans) {
  EXPECT_TRUE(rc::check("any order, counts full or not", [] {
    auto scans = random_scans(*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::element(0, 1, 20, 700));
    const std::string bytes = test::map_of(scans).to_octomap();
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    std::shuffle(scans.begin(), scans.end(), random);
    RC_ASSERT(test::map_of(scans).to_octomap() == bytes);
  }));
}

TEST(EdgeMap, PartsMergedAreTheWhole) {
  EXPECT_TRUE(rc::check("three parts, merged in any order, also through files", [] {
    const auto scans = random_scans(*rc::gen::arbitrary<std::uint64_t>(), *rc::gen::element(0, 3, 20, 700));
    std::vector<EdgeMap> parts(3, EdgeMap({}, "mine grid"));
    EdgeMap whole({}, "mine grid");
    for (const test::MadeScan& scan : scans) {
      parts[*rc::gen::inRange<std::size_t>(0, 3)].add_scan(scan.edges, scan.plain_m);
      whole.add_scan(scan.edges, scan.plain_m);
    }
    const std::size_t first = *rc::gen::inRange<std::size_t>(0, 3);
    EdgeMap merged = EdgeMap::from_octomap(parts[first].to_octomap(), "part", {});
    merged.merge(parts[(first + 2) % 3]);
    merged.merge(parts[(first + 1) % 3]);
    RC_ASSERT(merged.size() == whole.size());
    RC_ASSERT(merged.to_octomap() == whole.to_octomap());
  }));
}

TEST(EdgeMap, RefusesToMergeWhatDoesNotFit) {
  EdgeMapConfig coarse;
  coarse.voxel_m = 0.25;
  EdgeMap map({}, "EPSG:32750");
  map.add_scan(std::vector<MappedEdge>{{{1.0, 2.0, 3.0}, EdgeSide::left}}, {});
  const std::string before = map.to_octomap();
  for (const EdgeMap& other : {EdgeMap(coarse, "EPSG:32750"), EdgeMap({}, "EPSG:32751"), EdgeMap({})}) {
    try {
      map.merge(other);
      ADD_FAILURE() << "merged";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::invalid_argument);
    }
  }
  EXPECT_EQ(map.to_octomap(), before);
}

TEST(EdgeMap, RefusesNamesThatNoLineHolds) {
  EXPECT_NO_THROW(EdgeMap({}, "WGS84 -23.5 119.25 512.3"));
  for (const std::string& name : {std::string("a\nid OcTree"), std::string(" a"), std::string("a "), std::string("\t"),
                                  std::string(EdgeMap::kMaxWorldName + 1, 'a')}) {
    EXPECT_THROW(EdgeMap({}, name), Error);
  }
  EdgeMapConfig wrong;
  wrong.voxel_m = 0.0;
  EXPECT_THROW(EdgeMap{wrong}, ConfigError);
}

TEST(EdgeMap, UtmCoordinatesLoseNothing) {
  const Vector3d far_m(512'345.0, 7'412'345.0, 480.0);
  EdgeMap near({});
  EdgeMap far({});
  for (int i = 0; i < 50; ++i) {
    const Vector3d place_m(0.2 * i + 0.1, 0.1, 0.1);
    near.add_scan(std::vector<MappedEdge>{{place_m, EdgeSide::left}}, {});
    far.add_scan(std::vector<MappedEdge>{{far_m + place_m, EdgeSide::left}}, {});
  }
  EXPECT_EQ(near.size(), 50U);
  EXPECT_EQ(far.size(), 50U);
  const EdgeMap read = EdgeMap::from_octomap(far.to_octomap(), "far", {});
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(at(read, far_m + Vector3d(0.2 * i + 0.1, 0.1, 0.1)), (EdgeVoxel{1, 0, 0}));
  }
}

TEST(EdgeMap, MemoryPerKilometre) {
  // 250 m of a road 28 m wide, every voxel of its surface seen, at a grade of 8 % and with ruts.
  EdgeMap map({});
  std::vector<Vector3d> plain_m;
  for (double x = 0.1; x < 250.0; x += 0.2) {
    plain_m.clear();
    for (double y = 0.1; y < 28.0; y += 0.1) {
      plain_m.emplace_back(x, y, 0.08 * x + 0.1 * std::sin(3.0 * y) + 0.02 * y);
    }
    map.add_scan({}, plain_m);
  }
  EXPECT_GT(map.size(), 250U * 28U * 25U);
  EXPECT_LT(4 * map.memory_bytes(), 100'000'000U);
}

TEST(ReferenceEdgeMap, AgreesWithCountsWhereNothingIsClamped) {
  EXPECT_TRUE(rc::check("clamps out of reach", [] {
    EdgeMapConfig config;
    config.min_probability = 0.0001;
    config.max_probability = 0.9999;
    EdgeMap counts(config);
    ReferenceEdgeMap sequential(config);
    for (const test::MadeScan& scan : random_scans(*rc::gen::arbitrary<std::uint64_t>(), 5)) {
      counts.add_scan(scan.edges, scan.plain_m);
      sequential.add_scan(scan.edges, scan.plain_m);
    }
    counts.for_each([&](const VoxelKey& key, const EdgeVoxel& voxel) {
      for (const EdgeSide side : {EdgeSide::left, EdgeSide::right}) {
        RC_ASSERT(std::abs(sequential.log_odds(key, side) - counts.log_odds(voxel, side)) < 1e-5);
      }
    });
  }));
}

TEST(ReferenceEdgeMap, TheLastScansDecideWhereClampsAreHit) {
  const std::vector<MappedEdge> edge = {{{0.1, 0.1, 0.1}, EdgeSide::left}};
  const std::vector<Vector3d> plain_m = {{0.1, 0.1, 0.1}};
  ReferenceEdgeMap hits_last({});
  ReferenceEdgeMap misses_last({});
  for (int i = 0; i < 50; ++i) {
    hits_last.add_scan({}, plain_m);
    misses_last.add_scan(edge, {});
  }
  for (int i = 0; i < 50; ++i) {
    hits_last.add_scan(edge, {});
    misses_last.add_scan({}, plain_m);
  }
  EXPECT_NEAR(hits_last.log_odds({0, 0, 0}, EdgeSide::left), std::log(0.97 / 0.03), 1e-5);
  EXPECT_NEAR(misses_last.log_odds({0, 0, 0}, EdgeSide::left), std::log(0.12 / 0.88), 1e-5);
  EXPECT_TRUE(hits_last.is_edge({0, 0, 0}, EdgeSide::left));
  EXPECT_FALSE(hits_last.is_edge({0, 0, 0}, EdgeSide::right));
  EXPECT_FALSE(misses_last.is_edge({0, 0, 0}, EdgeSide::left));
}

}  // namespace
}  // namespace berm
