// The files of the edge map: OctoMap reads them as meant, and nothing that is broken is believed.
#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <octomap/ColorOcTree.h>
#include <rapidcheck.h>

#include "berm/map/edge_map.hpp"
#include "made_edges.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::expect_file_error;

EdgeMap small_map(const Eigen::Vector3d& at_m = {10.0, -20.0, 3.0}, const std::string& world = "mine grid") {
  EdgeMap map({}, world);
  for (const test::MadeScan& scan :
       test::drive(test::straight_course(at_m, 0.7, 4.0), {.half_width_m = 2.0, .hits_per_m = 5.0})) {
    map.add_scan(scan.edges, scan.plain_m);
  }
  return map;
}

std::unique_ptr<octomap::ColorOcTree> read_by_octomap(const std::string& bytes) {
  std::istringstream stream(bytes);
  std::unique_ptr<octomap::AbstractOcTree> tree(octomap::AbstractOcTree::read(stream));
  auto* color = dynamic_cast<octomap::ColorOcTree*>(tree.get());
  if (color != nullptr) {
    (void)tree.release();
  }
  return std::unique_ptr<octomap::ColorOcTree>(color);
}

EdgeMap read(const std::string& bytes) {
  return EdgeMap::from_octomap(bytes, "some.ot", {});
}

std::size_t tree_at(const std::string& bytes) {
  return bytes.find("\ndata\n") + 6;
}

/// `bytes` with the first `from` replaced.
std::string replaced(std::string bytes, const std::string& from, const std::string& to) {
  const std::size_t at = bytes.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return bytes.replace(at, from.size(), to);
}

/// A file of that tree, with a header that agrees with it.
std::string file_of(const std::string& tree) {
  return "# Octomap OcTree file\n# berm edge_map 1\n# berm origin_voxels 0 0 0\nid ColorOcTree\nsize " +
         std::to_string(tree.size() / 8) + "\nres 0.2\ndata\n" + tree;
}

std::string node(float log_odds, unsigned red, unsigned children) {
  std::string bytes(8, '\0');
  std::memcpy(bytes.data(), &log_odds, sizeof(log_odds));
  bytes[4] = static_cast<char>(red);
  bytes[7] = static_cast<char>(children);
  return bytes;
}

/// From the root down through first children to a node `levels` below it.
std::string chain(int levels, unsigned last_red) {
  std::string tree;
  for (int level = 0; level < levels; ++level) {
    tree += node(0.0F, 0, 1);
  }
  return tree + node(0.0F, last_red, 0);
}

TEST(OctomapFile, OctomapReadsEveryVoxel) {
  // Near the origin, and far from it, where OctoMap's coordinates start at the origin that the file tells.
  for (const Eigen::Vector3d& at_m : {Eigen::Vector3d(10.0, -20.0, 3.0), Eigen::Vector3d(5.1e5, 7.4e6, 300.0)}) {
    const EdgeMap map = small_map(at_m);
    const std::string bytes = map.to_octomap();
    Eigen::Vector3d origin_m;
    std::istringstream line(bytes.substr(bytes.find("origin_m ") + 9));
    line >> origin_m.x() >> origin_m.y() >> origin_m.z();
    EXPECT_EQ(origin_m.x(), at_m.x() > 1e5 ? 510'000.0 : 0.0);
    EXPECT_EQ(origin_m.z(), 0.0);
    const auto tree = read_by_octomap(bytes);
    ASSERT_NE(tree, nullptr);
    EXPECT_DOUBLE_EQ(tree->getResolution(), 0.2);
    EXPECT_EQ(tree->getNumLeafNodes(), map.size());
    map.for_each([&](const VoxelKey& key, const EdgeVoxel& voxel) {
      const Eigen::Vector3d center_m = voxel_center_m(key, 0.2) - origin_m;
      const octomap::ColorOcTreeNode* leaf = tree->search(center_m.x(), center_m.y(), center_m.z());
      ASSERT_NE(leaf, nullptr);
      EXPECT_EQ(leaf->getColor(), octomap::ColorOcTreeNode::Color(voxel.left, voxel.right, voxel.miss));
      EXPECT_FLOAT_EQ(leaf->getLogOdds(), static_cast<float>(map.log_odds(voxel)));
    });
  }
}

TEST(OctomapFile, WrittenAndReadIsTheSame) {
  EXPECT_TRUE(rc::check([] {
    EdgeMapConfig config;
    config.voxel_m = *rc::gen::element(0.2, 0.1, 1.0 / 3.0, 0.02, 5.0);
    const double reach_m = 1000.0 * config.voxel_m;
    EdgeMap map(config, *rc::gen::element<std::string>("", "EPSG:32750", "# berm world id data"));
    const std::size_t places = *rc::gen::inRange<std::size_t>(0, 60);
    const Eigen::Vector3d middle_m(*rc::gen::element(0.0, -5e6), *rc::gen::element(0.0, 5e6), 0.0);
    std::mt19937_64 random(*rc::gen::arbitrary<std::uint64_t>());
    for (std::size_t i = 0; i < places; ++i) {
      const Eigen::Vector3d place_m =
          middle_m + reach_m * Eigen::Vector3d(test::made_noise(random), test::made_noise(random), 0.0);
      map.add_scan(std::vector<MappedEdge>{{place_m, random() % 2 == 0 ? EdgeSide::left : EdgeSide::right}},
                   std::vector<Eigen::Vector3d>{place_m + Eigen::Vector3d(0.0, 0.0, config.voxel_m)});
    }
    const std::string bytes = map.to_octomap();
    const EdgeMap again = EdgeMap::from_octomap(bytes, "again", {});
    RC_ASSERT(again.config().voxel_m == config.voxel_m);
    RC_ASSERT(again.world() == map.world());
    RC_ASSERT(again.size() == map.size());
    map.for_each([&](const VoxelKey& key, const EdgeVoxel& voxel) { RC_ASSERT(again.at(key) == voxel); });
    RC_ASSERT(again.to_octomap() == bytes);
  }));
}

TEST(OctomapFile, ReachesAsFarAsOctomap) {
  const auto width = [](double meters) {
    EdgeMap map({});
    map.add_scan(std::vector<MappedEdge>{{{1e5 + 0.1, 0.1, 0.1}, EdgeSide::left},
                                         {{1e5 + 0.1 + meters, 0.1, 0.1}, EdgeSide::left}},
                 {});
    return map;
  };
  EXPECT_EQ(read(width(13'107.0).to_octomap()).size(), 2U);
  EXPECT_THROW((void)width(13'107.2).to_octomap(), Error);
}

TEST(OctomapFile, OctomapsToolsTakeIt) {
  const test::TempFolder folder;
  const std::filesystem::path file = folder.path() / "edges.ot";
  std::ofstream(file, std::ios::binary) << small_map().to_octomap();
  int tools = 0;
  for (const std::string tool : {"octree2pointcloud", "convert_octree"}) {
    if (std::system(("command -v " + tool + " > /dev/null").c_str()) == 0) {
      ++tools;
      const std::string out = (folder.path() / (tool == "octree2pointcloud" ? "edges.pcd" : "edges.bt")).string();
      std::string command = tool;
      command.append(" ").append(file.string()).append(" ").append(out).append(" > /dev/null 2>&1");
      EXPECT_EQ(std::system(command.c_str()), 0) << tool;
      EXPECT_GT(std::filesystem::file_size(out), 100U) << tool;
    }
  }
  if (tools == 0) {
    GTEST_SKIP() << "none of OctoMap's tools is installed (octomap-tools)";
  }
}

TEST(OctomapFile, TruncatedAtEveryLength) {
  const std::string bytes = small_map().to_octomap();
  for (std::size_t length = 0; length < bytes.size(); length += length < 600 ? 1 : 37) {
    EXPECT_THROW((void)read(bytes.substr(0, length)), FileError) << length;
  }
  EXPECT_THROW((void)read(bytes + '\0'), FileError);
  EXPECT_THROW((void)read(bytes + node(0.0F, 1, 0)), FileError);
}

TEST(OctomapFile, HeaderThatLies) {
  const std::string good = small_map().to_octomap();
  const std::string size_line = good.substr(good.find("\nsize ") + 1, good.find("\nres") - good.find("\nsize ") - 1);
  const auto refused = [&](const std::string& from, const std::string& to, ErrorCode code, const std::string& says) {
    SCOPED_TRACE(to);
    expect_file_error(code, says, [&] { (void)read(replaced(good, from, to)); });
  };
  refused("# Octomap OcTree file", "# Octomap OcTree binary file", ErrorCode::malformed, "first line");
  refused("id ColorOcTree", "id OcTree", ErrorCode::unsupported, "ColorOcTree");
  refused("id ColorOcTree", "id ColorOcTree\nid ColorOcTree", ErrorCode::malformed, "twice");
  refused("id ColorOcTree\n", "", ErrorCode::malformed, "id, size and res");
  refused("id ColorOcTree", "ID ColorOcTree", ErrorCode::malformed, "expected id");
  refused("# berm edge_map 1\n", "", ErrorCode::unsupported, "no edge map");
  refused("edge_map 1", "edge_map 2", ErrorCode::unsupported, "version");
  refused("edge_map 1", "egde_map 1", ErrorCode::malformed, "expected edge_map");
  refused("origin_voxels 0 0 0", "origin_voxels 0 0", ErrorCode::malformed, "three whole numbers");
  refused("origin_voxels 0 0 0", "origin_voxels 0 0 0 0", ErrorCode::malformed, "three whole numbers");
  refused("origin_voxels 0 0 0", "origin_voxels 0 0 1073741824", ErrorCode::malformed, "three whole numbers");
  refused("origin_voxels 0 0 0", "origin_voxels 0 0 0.5", ErrorCode::malformed, "three whole numbers");
  refused("world mine grid", "world \x01", ErrorCode::malformed, "world");
  refused(size_line, "size 4294967295", ErrorCode::truncated, "announced");
  refused(size_line, "size 2305843009213693953", ErrorCode::truncated, "announced");  // times 8 is 8
  refused(size_line, "size 99999999999999999999999", ErrorCode::malformed, "number of nodes");
  refused(size_line, "size -1", ErrorCode::malformed, "number of nodes");
  refused(size_line, "size 1", ErrorCode::malformed, "announced");
  refused(size_line, "size 0", ErrorCode::malformed, "announced");
  for (const std::string res : {"0", "nan", "inf", "-0.2", "1e-30", "1e30", "0.2x", ""}) {
    refused("res 0.2", "res " + res, ErrorCode::malformed, "");
  }
  // Comments of others are theirs.
  EXPECT_EQ(read(replaced(good, "id ColorOcTree", "# by hand\nid ColorOcTree")).to_octomap(), good);
  expect_file_error(ErrorCode::malformed, "16384",
                    [&] { (void)read("# Octomap OcTree file\n" + std::string(1U << 20U, '#')); });
}

TEST(OctomapFile, TreeThatLies) {
  EXPECT_EQ(read(file_of(chain(16, 3))).size(), 1U);
  EXPECT_EQ(read(file_of("")).size(), 0U);
  const auto refused = [](const std::string& tree, ErrorCode code, const std::string& says) {
    expect_file_error(code, says, [&] { (void)read(file_of(tree)); });
  };
  refused(chain(15, 3), ErrorCode::unsupported, "pruned");
  refused(chain(0, 3), ErrorCode::unsupported, "pruned");
  refused(chain(17, 3), ErrorCode::malformed, "with children");
  refused(chain(100'000, 3), ErrorCode::malformed, "with children");
  refused(chain(16, 0), ErrorCode::malformed, "without any count");
  refused(chain(16, 3) + node(0.0F, 1, 0), ErrorCode::malformed, "more nodes follow");
  refused(node(0.0F, 0, 255) + chain(15, 3), ErrorCode::truncated, "child was announced");
  std::string infinite = chain(16, 3);
  infinite.replace(0, 8, node(std::numeric_limits<float>::quiet_NaN(), 0, 1));
  refused(infinite, ErrorCode::malformed, "not finite");
}

TEST(OctomapFile, AnyByteChangedIsRefusedOrHarmless) {
  const std::string good = small_map().to_octomap();
  EXPECT_TRUE(rc::check([&] {
    std::string bytes = good;
    const auto at = *rc::gen::inRange<std::size_t>(0, bytes.size());
    bytes[at] = *rc::gen::arbitrary<char>();
    try {
      const EdgeMap map = read(bytes);
      // What was accepted is a map as any other: it is written, and read again, as it is.
      RC_ASSERT(read(map.to_octomap()).to_octomap() == map.to_octomap());
      RC_ASSERT(map.size() <= (bytes.size() - tree_at(good)) / 8 + 16);
    } catch (const FileError& error) {
      RC_ASSERT(error.file() == "some.ot");
    }
  }));
}

}  // namespace
}  // namespace berm
