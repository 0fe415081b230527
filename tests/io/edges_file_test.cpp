#include "berm/io/edges_file.hpp"

#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::expect_file_error;

std::vector<Edge> parse_edges(const std::string& text) {
  std::istringstream input(text);
  return read_edges(input, "edges.csv");
}

void expect_no_edges(const std::string& text, const std::string& part) {
  SCOPED_TRACE(text);
  expect_file_error(ErrorCode::malformed, part, [&] { (void)parse_edges(text); });
}

TEST(EdgesFile, SidesAndBlankLinesEndAPolyline) {
  const auto edges = parse_edges(
      "# truth\nside,x,y,z\nleft,0,1,2\nleft,1,1,2\nright,0,-1,2\nright, 1 ,-1,2\r\n\r\n\nright,9,9,9\nright,8,8,8");
  ASSERT_EQ(edges.size(), 3U);
  EXPECT_TRUE(edges[0].left);
  EXPECT_FALSE(edges[1].left);
  EXPECT_FALSE(edges[2].left);
  EXPECT_EQ(edges[1].vertices_m[1], Eigen::Vector3d(1.0, -1.0, 2.0));
  EXPECT_EQ(edges[2].vertices_m.size(), 2U);
  EXPECT_TRUE(parse_edges("side,x,y,z\n").empty());
}

TEST(EdgesFile, SurvivesARoundTrip) {
  const test::TempFolder folder;
  EXPECT_TRUE(rc::check("any polylines survive", [&](const std::vector<bool>& sides) {
    std::vector<Edge> edges;
    for (const bool left : sides) {
      Edge edge{left, {}};
      const int count = *rc::gen::inRange(2, 5);
      for (int i = 0; i < count; ++i) {
        edge.vertices_m.emplace_back(*rc::gen::inRange(-900000, 900000) / 8.0, *rc::gen::inRange(-9999, 9999) / 8.0,
                                     *rc::gen::inRange(-9999, 9999) / 8.0);
      }
      edges.push_back(edge);
    }
    write_edges(folder / "edges.csv", edges);
    const auto again = read_edges(folder / "edges.csv");
    RC_ASSERT(again.size() == edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      RC_ASSERT(again[i].left == edges[i].left);
      RC_ASSERT(again[i].vertices_m == edges[i].vertices_m);
    }
  }));
  const Edge left{true, {{0.0004, 1.0, -2.5}, {1.0, 2.0, -0.0001}}};
  const std::vector<Edge> two = {left, left};
  write_edges(folder / "edges.csv", two);
  EXPECT_EQ(test::slurp(folder / "edges.csv"),
            "side,x,y,z\nleft,0.000,1.000,-2.500\nleft,1.000,2.000,0.000\n\n"
            "left,0.000,1.000,-2.500\nleft,1.000,2.000,0.000\n");
}

TEST(EdgesFile, RefusesWhatIsNoEdge) {
  expect_no_edges("", "the file is empty");
  expect_no_edges("left,0,0,0\n", "line 1: expected the header side,x,y,z, found 'left,0,0,0'");
  expect_no_edges("line,side,x,y,z\n", "expected the header");
  expect_no_edges("side,x,y,z\nmiddle,0,0,0\n", "line 2: expected left or right in column 1, found 'middle'");
  for (const char* line :
       {"left,0,0", "left,0,0,0,0", "left,0,0,nan", "left,0,,0", "left,0,0,1e10", "left", "left,0,0,", "left,0 0,0"}) {
    expect_no_edges("side,x,y,z\n" + std::string(line) + "\n", "line 2: expected three coordinates");
  }
  expect_no_edges("side,x,y,z\nleft,0,0,0\nright,0,0,0\n", "line 3: the polyline that ends before has one vertex");
  expect_no_edges("side,x,y,z\nleft,0,0,0\n", "has one vertex");
  const test::TempFolder folder;
  const std::vector<Edge> one = {{true, {{0.0, 0.0, 0.0}}}};
  EXPECT_THROW(write_edges(folder / "edges.csv", one), Error);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace berm
