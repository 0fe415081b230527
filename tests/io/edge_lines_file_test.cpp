#include "berm/io/edge_lines_file.hpp"

#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"
#include "io/made_edges.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

std::vector<EdgeLine> parse(const std::string& text) {
  std::istringstream input(text);
  return read_edge_lines(input, "edges.csv");
}

void expect_refused(const std::string& text, const std::string& part) {
  SCOPED_TRACE(text);
  test::expect_file_error(ErrorCode::malformed, part, [&] { (void)parse(text); });
}

const std::string kHeader = "line,side,x,y,z,confidence,berm_height_m\n";
const std::string kBareHeader = "line,side,x,y,z,confidence\n";

TEST(EdgeLinesFile, WritesWhatIsDocumented) {
  const test::TempFolder folder;
  write_edge_lines(folder / "edges.csv", test::made_edges());
  EXPECT_EQ(test::slurp(folder / "edges.csv"), kHeader +
                                                   "0,left,0.000,5.125,0.250,1.000,1.250\n"
                                                   "0,left,10.500,5.250,0.500,0.750,0.500\n"
                                                   "0,left,-1200.001,830.500,-40.000,0.125,\n"
                                                   "1,right,0.000,-5.000,0.000,0.500,\n"
                                                   "1,right,11.000,-5.000,0.000,0.000,\n");
}

TEST(EdgeLinesFile, SurvivesARoundTrip) {
  const test::TempFolder folder;
  EXPECT_TRUE(rc::check("any lines survive, at UTM's coordinates too", [&](const std::vector<bool>& sides) {
    std::vector<EdgeLine> lines;
    for (const bool left : sides) {
      EdgeLine line;
      line.side = left ? EdgeSide::left : EdgeSide::right;
      const int count = *rc::gen::inRange(2, 5);
      for (int i = 0; i < count; ++i) {
        line.vertices.push_back({{*rc::gen::inRange(0, 40'000'000) / 8.0, *rc::gen::inRange(0, 80'000'000) / 8.0,
                                  *rc::gen::inRange(-9999, 9999) / 8.0},
                                 *rc::gen::inRange(0, 9) / 8.0});
        if (*rc::gen::arbitrary<bool>()) {
          line.vertices.back().berm_height_m = *rc::gen::inRange(0, 99) / 8.0;
        }
      }
      lines.push_back(line);
    }
    write_edge_lines(folder / "edges.csv", lines);
    const auto again = read_edge_lines(folder / "edges.csv");
    RC_ASSERT(again.size() == lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      RC_ASSERT(again[i].side == lines[i].side);
      RC_ASSERT(again[i].vertices.size() == lines[i].vertices.size());
      for (std::size_t k = 0; k < lines[i].vertices.size(); ++k) {
        RC_ASSERT(again[i].vertices[k].position_m == lines[i].vertices[k].position_m);
        RC_ASSERT(again[i].vertices[k].confidence == lines[i].vertices[k].confidence);
        RC_ASSERT(again[i].vertices[k].berm_height_m == lines[i].vertices[k].berm_height_m);
      }
    }
  }));
}

TEST(EdgeLinesFile, HeightsMayBeMissing) {
  const auto lines = parse(kHeader + "0,left,0,0,0,1,\n0,left,1,0,0,1, 0.75 \n");
  EXPECT_EQ(lines.at(0).vertices.at(0).berm_height_m, std::nullopt);
  EXPECT_EQ(lines.at(0).vertices.at(1).berm_height_m, 0.75);
  EXPECT_EQ(parse(kBareHeader + "0,left,0,0,0,1\n0,left,1,0,0,1\n").at(0).vertices.at(1).berm_height_m, std::nullopt);
  for (const char* height : {"high", "nan", "1e10", "1,1"}) {
    expect_refused(kHeader + "0,left,0,0,0,1," + height + "\n", "line 2: expected");
  }
  expect_refused(kHeader + "0,left,0,0,0,1\n", "confidence of 0 to 1 in column 6 of 7");
}

TEST(EdgeLinesFile, RefusesWhatIsNoLine) {
  EXPECT_TRUE(parse(kBareHeader).empty());
  EXPECT_EQ(parse("# made\n" + kBareHeader + "3,left,0,0,0,1\r\n\n3, left ,1,0,0, 0.5 \n").size(), 1U);
  expect_refused("", "the file is empty");
  expect_refused("side,x,y,z\n", "line 1: expected the header line,side,x,y,z,confidence");
  for (const char* number : {"", "-1", "1.5", "one", "99999999999999999999", "1 2"}) {
    expect_refused(kBareHeader + number + ",left,0,0,0,1\n", "line 2: expected the number of the line");
  }
  expect_refused(kBareHeader + "0,middle,0,0,0,1\n", "left or right in column 2, found 'middle'");
  for (const char* row :
       {"0,left,0,0", "0,left,0,0,0", "0,left,0,0,nan,1", "0,left,0,,0,1", "0,left,0,0,1e10,1", "0,left,0,0 0,0,1"}) {
    expect_refused(kBareHeader + row + "\n", "expected three coordinates");
  }
  for (const char* row :
       {"0,left,0,0,0,", "0,left,0,0,0,1.5", "0,left,0,0,0,-0.1", "0,left,0,0,0,nan", "0,left,0,0,0,1,1"}) {
    expect_refused(kBareHeader + row + "\n", "expected a confidence of 0 to 1");
  }
  expect_refused(kBareHeader + "0,left,0,0,0,1\n0,right,0,0,0,1\n", "line 3: the side changes within line 0");
  expect_refused(kBareHeader + "1,left,0,0,0,1\n1,left,1,0,0,1\n0,left,0,0,0,1\n", "line 0 comes after line 1");
  expect_refused(kBareHeader + "0,left,0,0,0,1\n1,left,0,0,0,1\n", "line 0 has one vertex");
  expect_refused(kBareHeader + "0,left,0,0,0,1\n", "line 0 has one vertex");
}

TEST(EdgeLinesFile, RefusesToWriteWhatItWouldNotRead) {
  const test::TempFolder folder;
  const auto spoilt = [&](auto&& spoil) {
    std::vector<EdgeLine> lines = test::made_edges();
    spoil(lines[1]);
    EXPECT_THROW(write_edge_lines(folder / "edges.csv", lines), Error);
  };
  spoilt([](EdgeLine& line) { line.vertices.pop_back(); });
  spoilt([](EdgeLine& line) { line.vertices[0].confidence = 1.5; });
  spoilt([](EdgeLine& line) { line.vertices[0].confidence = std::numeric_limits<double>::quiet_NaN(); });
  spoilt([](EdgeLine& line) { line.vertices[0].position_m.y() = std::numeric_limits<double>::quiet_NaN(); });
  spoilt([](EdgeLine& line) { line.vertices[0].position_m.z() = 2e9; });
  spoilt([](EdgeLine& line) { line.vertices[0].berm_height_m = std::numeric_limits<double>::infinity(); });
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace berm
