#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <octomap/ColorOcTree.h>

#include "berm/io/datum.hpp"
#include "berm/io/edge_lines_file.hpp"
#include "berm/map/edge_map.hpp"
#include "program.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using nlohmann::json;
using test::run_berm;
using testing::HasSubstr;

const Geodetic kMine{-23.5, 148.25, 310.0};

/// A straight road 12 m wide, along x, seen in `scans` scans from `from_m` on, 10 m each.
EdgeMap road_map(int from_m, int scans, const std::string& world, double voxel_m = 0.2) {
  EdgeMapConfig config;
  config.voxel_m = voxel_m;
  EdgeMap map(config, world);
  for (int scan = 0; scan < scans; ++scan) {
    std::vector<MappedEdge> edges;
    std::vector<Eigen::Vector3d> plain_m;
    for (int i = 0; i < 40; ++i) {
      const double x_m = from_m + 10.0 * scan + 0.25 * i;
      // Two or three hits in each place, as neighbouring scans give them.
      for (const double wobble_m : {-0.05, 0.05, 0.1}) {
        edges.push_back({{x_m + 0.3 * wobble_m, 6.0 + wobble_m, 0.1}, EdgeSide::left});
        edges.push_back({{x_m - 0.3 * wobble_m, -6.0 + wobble_m, -0.1}, EdgeSide::right});
      }
      for (double y_m = -5.0; y_m <= 5.0; y_m += 0.5) {
        plain_m.emplace_back(x_m, y_m, 0.0);
      }
    }
    for (int again = 0; again < 4; ++again) {
      static_cast<void>(map.add_scan(edges, plain_m));
    }
  }
  return map;
}

class MapCommandTest : public testing::Test {
 protected:
  std::string file(const std::string& name) const { return (here / name).string(); }
  void spill_map(const std::string& name, const EdgeMap& map) const { test::spill(here / name, map.to_octomap()); }
  std::string bytes(const std::string& name) const { return test::slurp(here / name); }
  static bool can_run(const std::string& tool) {
    return std::system((tool + " --version >/dev/null 2>&1").c_str()) == 0;
  }
  static bool was_built_with_gdal() {
    const test::TempFolder folder;
    test::spill(folder / "e.csv", "line,side,x,y,z,confidence\n");
    return run_berm({"map", "export", (folder / "e.csv").string(), "-o", (folder / "e.dxf").string()}).exit_code == 0;
  }

  test::TempFolder here;
};

TEST_F(MapCommandTest, MergesInAnyOrder) {
  const std::string world = world_name(kMine);
  const EdgeMap whole = road_map(0, 6, world);
  spill_map("a.ot", road_map(0, 2, world));
  spill_map("b.ot", road_map(20, 2, world));
  spill_map("c.ot", road_map(40, 2, world));
  EXPECT_EQ(run_berm({"map", "merge", file("a.ot"), file("b.ot"), file("c.ot"), "-o", file("abc.ot")}).exit_code, 0);
  EXPECT_EQ(run_berm({"map", "merge", file("c.ot"), file("a.ot"), file("b.ot"), "-o", file("cab.ot")}).exit_code, 0);
  EXPECT_EQ(bytes("abc.ot"), bytes("cab.ot"));
  EXPECT_EQ(bytes("abc.ot"), whole.to_octomap());
  // In two steps, over one of the inputs.
  EXPECT_EQ(run_berm({"map", "merge", file("a.ot"), file("b.ot"), "-o", file("a.ot"), "--force"}).exit_code, 0);
  EXPECT_EQ(run_berm({"map", "merge", file("c.ot"), file("a.ot"), "-o", file("a.ot"), "--force"}).exit_code, 0);
  EXPECT_EQ(bytes("a.ot"), bytes("abc.ot"));
}

TEST_F(MapCommandTest, OctomapOpensAMergedMap) {
  spill_map("a.ot", road_map(0, 2, ""));
  spill_map("b.ot", road_map(20, 2, ""));
  ASSERT_EQ(run_berm({"map", "merge", file("a.ot"), file("b.ot"), "-o", file("ab.ot")}).exit_code, 0);
  const std::unique_ptr<octomap::AbstractOcTree> tree(octomap::AbstractOcTree::read(file("ab.ot")));
  const auto* color = dynamic_cast<octomap::ColorOcTree*>(tree.get());
  ASSERT_NE(color, nullptr);
  EXPECT_DOUBLE_EQ(color->getResolution(), 0.2);
  EXPECT_EQ(color->getNumLeafNodes(), road_map(0, 4, "").size());
  const auto* edge = color->search(15.1, 6.0, 0.1);
  ASSERT_NE(edge, nullptr);
  EXPECT_GT(edge->getOccupancy(), 0.7);
}

TEST_F(MapCommandTest, RefusesToMergeWhatDoesNotFit) {
  spill_map("a.ot", road_map(0, 1, world_name(kMine)));
  spill_map("coarse.ot", road_map(0, 1, world_name(kMine), 0.5));
  spill_map("elsewhere.ot", road_map(0, 1, "EPSG:32750"));
  spill_map("nowhere.ot", road_map(0, 1, ""));
  const auto refused = [&](const std::string& other, const std::string& part) {
    const auto result = run_berm({"map", "merge", file("a.ot"), file(other), "-o", file("sum.ot")});
    EXPECT_EQ(result.exit_code, 1) << other;
    EXPECT_THAT(result.err, HasSubstr(other));
    EXPECT_THAT(result.err, HasSubstr(part));
  };
  refused("coarse.ot", "its voxels are 0.5 m, those of " + file("a.ot") + " are 0.2 m");
  refused("elsewhere.ot", "it names 'EPSG:32750', " + file("a.ot") + " names 'WGS84 lat -23.5 lon 148.25 h 310'");
  refused("nowhere.ot", "it names no world");
  EXPECT_FALSE(std::filesystem::exists(here / "sum.ot"));
  EXPECT_EQ(run_berm({"map", "merge", file("a.ot"), "-o", file("sum.ot")}).exit_code, 2);
}

TEST_F(MapCommandTest, RefusesWhatIsNoMap) {
  spill_map("good.ot", road_map(0, 1, ""));
  const std::string good = bytes("good.ot");
  test::spill(here / "short.ot", good.substr(0, good.size() / 2));
  test::spill(here / "wrong.ot", "# Octomap OcTree binary file\n" + good.substr(good.find('\n') + 1));
  test::spill(here / "text.ot", "line,side,x,y,z,confidence\n");
  test::spill(here / "empty.ot", "");
  for (const char* name : {"short.ot", "wrong.ot", "text.ot", "empty.ot", "missing.ot"}) {
    for (const std::vector<std::string>& command : {std::vector<std::string>{"map", "info", file(name)},
                                                    {"map", "lines", file(name), "-o", file("out.csv")},
                                                    {"map", "merge", file("good.ot"), file(name), "-o", file("out.ot")},
                                                    {"map", "export", file(name), "-o", file("out.csv")},
                                                    {"map", "draw", file(name), "-o", file("out.png")}}) {
      const auto result = run_berm(command);
      EXPECT_EQ(result.exit_code, 1) << command[1] << " " << name;
      EXPECT_THAT(result.err, HasSubstr(name)) << command[1];
      EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    }
  }
  for (const char* name : {"out.csv", "out.ot", "out.png"}) {
    EXPECT_FALSE(std::filesystem::exists(here / name)) << name;
  }
}

TEST_F(MapCommandTest, InfoSaysWhatIsInAMap) {
  spill_map("a.ot", road_map(0, 6, world_name(kMine)));
  const auto text = run_berm({"map", "info", file("a.ot")});
  EXPECT_EQ(text.exit_code, 0);
  EXPECT_THAT(text.out, HasSubstr("latitude -23.5 deg, longitude 148.25 deg, height 310 m"));
  const auto result = run_berm({"map", "info", file("a.ot"), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const json info = json::parse(result.out);
  EXPECT_EQ(info.at("voxel_m"), 0.2);
  EXPECT_EQ(info.at("datum").at("lon_deg"), 148.25);
  EXPECT_EQ(info.at("voxels"), road_map(0, 6, "").size());
  EXPECT_NEAR(info.at("extent_m").at("high")[1].get<double>(), 6.2, 0.21);
  for (const char* side : {"left", "right"}) {
    EXPECT_EQ(info.at(side).at("lines"), 1) << side;
    EXPECT_NEAR(info.at(side).at("length_m").get<double>(), 60.0, 1.5) << side;
    EXPECT_GT(info.at(side).at("edge_voxels"), 200) << side;
    EXPECT_EQ(info.at(side).at("gaps"), 0) << side;
  }
  EXPECT_GT(info.at("memory_bytes"), 1000);
  spill_map("empty.ot", EdgeMap({}));
  const json none = json::parse(run_berm({"map", "info", file("empty.ot"), "--json"}).out);
  EXPECT_TRUE(none.at("datum").is_null() && none.at("extent_m").is_null());
  EXPECT_EQ(run_berm({"map", "info", file("empty.ot")}).exit_code, 0);
}

TEST_F(MapCommandTest, LinesAreThoseOfTheMap) {
  spill_map("a.ot", road_map(0, 6, ""));
  ASSERT_EQ(run_berm({"map", "lines", file("a.ot"), "-o", file("edges.csv")}).exit_code, 0);
  const auto lines = read_edge_lines(here / "edges.csv");
  ASSERT_EQ(lines.size(), 2U);
  for (const EdgeLine& line : lines) {
    for (const EdgeLine::Vertex& vertex : line.vertices) {
      EXPECT_NEAR(vertex.position_m.y(), line.side == EdgeSide::left ? 6.0 : -6.0, 0.15);
    }
  }
  const std::string before = bytes("edges.csv");
  const auto again = run_berm({"map", "lines", file("a.ot"), "-o", file("edges.csv"), "--set", "lines.spacing_m=5"});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_THAT(again.err, HasSubstr("--force replaces it"));
  EXPECT_EQ(bytes("edges.csv"), before);
  EXPECT_EQ(run_berm({"map", "lines", file("a.ot"), "-o", file("edges.csv"), "--set", "lines.spacing_m=5", "--force"})
                .exit_code,
            0);
  EXPECT_LT(read_edge_lines(here / "edges.csv")[0].vertices.size(), lines[0].vertices.size() / 2);
  for (const char* value : {"lines.spacing=5", "lines.spacing_m=0", "map.voxel_m=1", "spacing_m=1"}) {
    const auto wrong = run_berm({"map", "lines", file("a.ot"), "-o", file("other.csv"), "--set", value});
    EXPECT_EQ(wrong.exit_code, 2) << value;
    EXPECT_THAT(wrong.err, HasSubstr(value));
  }
}

TEST_F(MapCommandTest, ExportsFromTheMapAndFromItsLines) {
  spill_map("a.ot", road_map(0, 6, world_name(kMine)));
  ASSERT_EQ(run_berm({"map", "lines", file("a.ot"), "-o", file("edges.csv")}).exit_code, 0);
  for (const std::string ending : {"geojson", "gpkg", "dxf", "osm", "csv"}) {
    if ((ending == "gpkg" || ending == "dxf") && !was_built_with_gdal()) {
      continue;
    }
    EXPECT_EQ(run_berm({"map", "export", file("a.ot"), "-o", file("map." + ending)}).exit_code, 0) << ending;
    EXPECT_EQ(
        run_berm({"map", "export", file("edges.csv"), "-o", file("lines." + ending), "--datum", "-23.5,148.25,310"})
            .exit_code,
        0)
        << ending;
  }
  EXPECT_EQ(bytes("map.csv"), bytes("edges.csv"));
  const json map = json::parse(bytes("map.geojson"));
  ASSERT_EQ(map.at("features").size(), 2U);
  const LocalFrame frame(kMine);
  const json lines = json::parse(bytes("lines.geojson"));
  for (std::size_t i = 0; i < 2; ++i) {
    const json& place = map.at("features")[i].at("geometry").at("coordinates")[0];
    const Eigen::Vector3d local_m =
        frame.to_local_m({place[1].get<double>(), place[0].get<double>(), place[2].get<double>()});
    EXPECT_NEAR(std::abs(local_m.y()), 6.0, 0.2);
    EXPECT_EQ(lines.at("features")[i].at("geometry").at("coordinates").size(),
              map.at("features")[i].at("geometry").at("coordinates").size());
  }
}

TEST_F(MapCommandTest, OtherToolsReadTheExports) {
  if (!can_run("ogr2ogr") || !was_built_with_gdal()) {
    GTEST_SKIP() << "needs ogr2ogr (Debian: gdal-bin) and a program built with GDAL";
  }
  spill_map("a.ot", road_map(0, 6, world_name(kMine)));
  for (const std::string ending : {"gpkg", "dxf"}) {
    ASSERT_EQ(run_berm({"map", "export", file("a.ot"), "-o", file("map." + ending)}).exit_code, 0);
    const std::string command =
        "ogr2ogr -f GeoJSON '" + file(ending + ".geojson") + "' '" + file("map." + ending) + "' >/dev/null 2>&1";
    ASSERT_EQ(std::system(command.c_str()), 0) << ending;
    EXPECT_EQ(json::parse(bytes(ending + ".geojson")).at("features").size(), 2U) << ending;
  }
  if (can_run("xmllint")) {
    ASSERT_EQ(run_berm({"map", "export", file("a.ot"), "-o", file("map.osm")}).exit_code, 0);
    const std::string command =
        "xmllint --noout --nonet --schema '" BERM_OSM_SCHEMA "' '" + file("map.osm") + "' >/dev/null 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0);
  }
}

TEST_F(MapCommandTest, WithoutADatumItSaysWhatToDo) {
  spill_map("a.ot", road_map(0, 6, "mine grid"));
  const auto result = run_berm({"map", "export", file("a.ot"), "-o", file("edges.geojson")});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("add --datum=LAT,LON,H"));
  EXPECT_THAT(result.err, HasSubstr("a.ot"));
  EXPECT_EQ(run_berm({"map", "export", file("a.ot"), "-o", file("edges.csv")}).exit_code, 0);
  EXPECT_EQ(
      run_berm({"map", "export", file("a.ot"), "-o", file("edges.geojson"), "--datum=-23.5,148.25,310"}).exit_code, 0);
  for (const char* datum : {"--datum=91,0,0", "--datum=1,2", "--datum=1,2,north", "--datum=1,2,3,4"}) {
    EXPECT_EQ(run_berm({"map", "export", file("a.ot"), "-o", file("x.geojson"), datum}).exit_code, 2) << datum;
  }
  EXPECT_EQ(run_berm({"map", "export", file("a.ot"), "-o", file("edges.shp")}).exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(here / "x.geojson"));
}

TEST_F(MapCommandTest, DrawsAPicture) {
  spill_map("a.ot", road_map(0, 6, ""));
  ASSERT_EQ(run_berm({"map", "draw", file("a.ot"), "-o", file("map.png"), "--size", "600"}).exit_code, 0);
  const std::string picture = bytes("map.png");
  EXPECT_EQ(picture.substr(1, 3), "PNG");
  EXPECT_GT(picture.size(), 2000U);
  ASSERT_EQ(run_berm({"map", "draw", file("a.ot"), "-o", file("again.png"), "--size", "600"}).exit_code, 0);
  EXPECT_EQ(bytes("again.png"), picture);
  EXPECT_EQ(run_berm({"map", "draw", file("a.ot"), "-o", file("map.png")}).exit_code, 1);
  EXPECT_EQ(run_berm({"map", "draw", file("a.ot"), "-o", file("x.png"), "--size", "10"}).exit_code, 2);
  spill_map("empty.ot", EdgeMap({}));
  EXPECT_THAT(run_berm({"map", "draw", file("empty.ot"), "-o", file("x.png")}).err, HasSubstr("nothing to draw"));
}

TEST_F(MapCommandTest, EverySubcommandHasExamples) {
  for (const char* name : {"info", "merge", "lines", "export", "draw"}) {
    const auto result = run_berm({"map", name, "--help"});
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.out, HasSubstr(std::string("berm map ") + name + " ")) << name;
  }
  EXPECT_EQ(run_berm({"map"}).exit_code, 2);
  EXPECT_EQ(run_berm({"map", "melt"}).exit_code, 2);
}

}  // namespace
}  // namespace berm
