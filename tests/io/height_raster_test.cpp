#include "berm/io/height_raster.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "support/data.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::expect_file_error;

constexpr const char* kGridHeader = "ncols 3\nnrows 2\nxllcorner 100.5\nyllcorner -7\ncellsize 2\nNODATA_value -9999\n";

HeightRaster parse_grid(const std::string& text) {
  return parse_ascii_grid(text, "model.asc");
}

void expect_no_grid(const std::string& text, const std::string& part, ErrorCode code = ErrorCode::malformed) {
  SCOPED_TRACE(text.substr(0, 200));
  expect_file_error(code, part, [&] { (void)parse_grid(text); });
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

const std::string& small_grid() {
  static const std::string text = std::string(kGridHeader) + "1 2 3\n4 -9999 6.25\n";
  return text;
}

TEST(AsciiGrid, TheFirstLineIsTheNorth) {
  const HeightRaster raster = parse_grid(small_grid());
  EXPECT_EQ(raster.columns, 3U);
  EXPECT_EQ(raster.rows, 2U);
  EXPECT_EQ(raster.origin_x_m, 100.5);
  EXPECT_EQ(raster.origin_y_m, -7.0);
  EXPECT_EQ(raster.cell_m, 2.0);
  EXPECT_EQ(raster.at(0, 1), 1.0F);
  EXPECT_EQ(raster.at(0, 0), 4.0F);
  EXPECT_EQ(raster.at(2, 0), 6.25F);
  EXPECT_TRUE(std::isnan(raster.at(1, 0)));
}

TEST(AsciiGrid, CentersLieHalfACellFromTheCorner) {
  const HeightRaster raster =
      parse_grid(replaced(replaced(small_grid(), "xllcorner", "XLLCENTER"), "yllcorner", "YllCenter"));
  EXPECT_EQ(raster.origin_x_m, 99.5);
  EXPECT_EQ(raster.origin_y_m, -8.0);
}

TEST(AsciiGrid, TakesWhatProgramsWrite) {
  // Any case, any order, CRLF, heights over any number of lines, no NODATA, no line end, dx and dy.
  EXPECT_EQ(parse_grid("NROWS 2\r\nNCOLS 2\r\nYLLCORNER 0\r\nXLLCORNER 0\r\nCELLSIZE 1\r\n1 2 3\r\n4").at(1, 0), 4.0F);
  EXPECT_EQ(parse_grid("ncols 2 nrows 2 xllcorner 0 yllcorner 0 dx 5 dy 5\n1\n2\n3\n4\n\n").cell_m, 5.0);
  EXPECT_TRUE(std::isnan(
      parse_grid("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nnodata_value nan\n1 NaN\n3 4").at(1, 1)));
  // NODATA of GDAL for floats, rounded in another way than in the header.
  EXPECT_TRUE(std::isnan(parse_grid("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n"
                                    "NODATA_value -3.4028234663852886e+38\n-3.402823e+38 2\n3 4\n")
                             .at(0, 1)));
}

TEST(AsciiGrid, CountsThatLieAreRefusedBeforeMemoryIsTaken) {
  expect_no_grid(replaced(small_grid(), "ncols 3", "ncols 4"), "the file ends after 6 of 8 heights",
                 ErrorCode::truncated);
  expect_no_grid(replaced(small_grid(), "ncols 3", "ncols 2"), "'-9999' follows the last of 4 heights",
                 ErrorCode::malformed);
  expect_no_grid(replaced(small_grid(), "nrows 2", "nrows 20000000"), "take at least 119999999 bytes",
                 ErrorCode::truncated);
  expect_no_grid(replaced(small_grid(), "nrows 2", "nrows 1000000000"), "3 x 1000000000 cells are more than",
                 ErrorCode::unsupported);
  expect_no_grid(replaced(small_grid(), "nrows 2", "nrows 18446744073709551615"), "are more than",
                 ErrorCode::unsupported);
  expect_no_grid(replaced(small_grid(), "nrows 2", "nrows 18446744073709551616"), "line 2: expected the number");
  for (const char* count : {"0", "-1", "2.5", "1e3", "x", ""}) {
    expect_no_grid(replaced(small_grid(), "nrows 2", std::string("nrows ") + count), "model.asc");
  }
  expect_no_grid("ncols 1\nnrows 1\nxllcorner 0\nyllcorner 0\ncellsize 1\n5\n", "1 x 1 cells are no terrain");
}

TEST(AsciiGrid, OnlyNodataIsRefused) {
  expect_no_grid("ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\nNODATA_value -1\n-1 -1\n-1 -1\n",
                 "holds no height: all of its 2 x 2 cells are NODATA");
}

TEST(AsciiGrid, WhatIsNoHeightIsRefusedWithItsPlace) {
  expect_no_grid(replaced(small_grid(), "6.25", "nan"),
                 "at byte 89: line 8: 'nan' in row 2, column 3 is no height in metres");
  for (const char* word : {"inf", "-inf", "1e6", "-1e30", "1e999", "1,5", "0x10", "4..5", "--4", "\xff"}) {
    expect_no_grid(replaced(small_grid(), "6.25", word), "in row 2, column 3 is no height");
  }
  expect_no_grid(small_grid() + "7\n", "line 9: '7' follows the last");
  expect_no_grid(std::string(kGridHeader) + "1 2 3\n444 555", "the file ends after 5 of 6 heights",
                 ErrorCode::truncated);
}

TEST(AsciiGrid, BrokenHeadersAreRefused) {
  expect_no_grid("", "the header ends here without 'ncols'");
  expect_no_grid("hello world", "'hello' is no key of an ESRI ASCII grid");
  expect_no_grid(replaced(small_grid(), "cellsize 2\n", ""), "without 'cellsize'");
  expect_no_grid(replaced(small_grid(), "xllcorner 100.5\n", ""), "without 'xllcorner'");
  expect_no_grid(replaced(small_grid(), "cellsize 2", "cellsize 2\ncellsize 2"), "line 6: 'cellsize' is given twice");
  expect_no_grid(replaced(small_grid(), "xllcorner 100.5", "xllcorner 1\nxllcenter 1"), "given twice");
  expect_no_grid(replaced(small_grid(), "xllcorner 100.5", "xllcorner 1e10"), "expected a number of metres");
  expect_no_grid(replaced(small_grid(), "NODATA_value -9999", "NODATA_value x"), "line 6: expected a number after");
  for (const char* cell : {"0", "-1", "0.0002777", "1e6"}) {
    expect_no_grid(replaced(small_grid(), "cellsize 2", std::string("cellsize ") + cell), "are no metres",
                   ErrorCode::unsupported);
  }
  expect_no_grid(replaced(small_grid(), "cellsize 2", "dx 2\ndy 3"), "not square", ErrorCode::unsupported);
}

TEST(AsciiGrid, CutAtAnyByteItIsAModelOrOneError) {
  for (std::size_t length = 0; length < small_grid().size() - 2; ++length) {
    try {
      const HeightRaster raster = parse_grid(small_grid().substr(0, length));
      // The last number may have lost digits, which nobody can see.
      EXPECT_EQ(raster.heights_m.size(), 6U) << length;
    } catch (const FileError& error) {
      EXPECT_EQ(error.file(), "model.asc");
    }
  }
}

TEST(AsciiGrid, WhatIsWrittenReadsBackTheSame) {
  const test::TempFolder folder;
  EXPECT_TRUE(rc::check("any model survives", [&] {
    HeightRaster raster;
    raster.columns = *rc::gen::inRange<std::size_t>(2, 9);
    raster.rows = *rc::gen::inRange<std::size_t>(2, 9);
    raster.cell_m = *rc::gen::inRange(1, 4000) / 64.0;
    raster.origin_x_m = *rc::gen::inRange(-900'000'000, 900'000'000) / 7.0;
    raster.origin_y_m = *rc::gen::inRange(-900'000'000, 900'000'000) / 7.0;
    raster.crs = "LOCAL_CS[\"any\"]";
    for (std::size_t i = 0; i < raster.columns * raster.rows; ++i) {
      const bool known = i == 0 || *rc::gen::inRange(0, 4) > 0;
      raster.heights_m.push_back(known ? static_cast<float>(*rc::gen::inRange(-8000 * 8, 9000 * 8)) / 8.0F
                                       : std::numeric_limits<float>::quiet_NaN());
    }
    write_ascii_grid(folder / "model.asc", raster);
    const HeightRaster again = read_height_raster(folder / "model.asc");
    RC_ASSERT(again.columns == raster.columns && again.rows == raster.rows && again.cell_m == raster.cell_m);
    RC_ASSERT(again.origin_x_m == raster.origin_x_m && again.origin_y_m == raster.origin_y_m);
    RC_ASSERT(again.crs == raster.crs);
    for (std::size_t i = 0; i < raster.heights_m.size(); ++i) {
      const float a = raster.heights_m[i];
      const bool same = std::isnan(a) ? std::isnan(again.heights_m[i]) : again.heights_m[i] == a;
      RC_ASSERT(same);
    }
  }));
}

TEST(AsciiGrid, HeightsThatAreNotThereCannotBeWritten) {
  const test::TempFolder folder;
  HeightRaster raster;
  EXPECT_THROW(write_ascii_grid(folder / "model.asc", raster), Error);
  raster.columns = 2;
  raster.rows = 3;
  raster.heights_m.resize(5);
  EXPECT_THROW(write_ascii_grid(folder / "model.asc", raster), Error);
  EXPECT_TRUE(folder.names().empty());
}

TEST(HeightRaster, AModelOfABillionCellsIsRefusedByItsHeader) {
  const test::TempFolder folder;
  test::spill(folder / "large.asc", "ncols 50000\nnrows 20000\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n");
  // Sparse: 8 GB that take no room on the disk, and would be refused for their size if they were read.
  std::filesystem::resize_file(folder / "large.asc", std::uintmax_t{8} << 30U);
  expect_file_error(ErrorCode::unsupported, "50000 x 20000 cells are more than the 100000000",
                    [&] { (void)read_height_raster(folder / "large.asc"); });
}

TEST(HeightRaster, SaysWhatIsWrongWithThePath) {
  const test::TempFolder folder;
  expect_file_error(ErrorCode::not_found, "none.asc", [&] { (void)read_height_raster(folder / "none.asc"); });
  expect_file_error(ErrorCode::unreadable, folder.path().string(), [&] { (void)read_height_raster(folder.path()); });
}

TEST(HeightRaster, RealSlopesAreRead) {
  struct Model {
    const char* name;
    std::size_t columns;
    std::size_t rows;
    double origin_x_m;
    double cell_m;
  };
  BERM_NEED_DATA(folder, "alpine_dem");
  for (const Model& model : {Model{"avaKot.asc", 439, 517, 176973.437998359208, 4.997688906601},
                             Model{"avaPfa.asc", 433, 350, 167739.5, 1.0},
                             Model{"avaWog.asc", 490, 555, 167455.348391387 - 0.5 * 4.997678230579, 4.997678230579}}) {
    SCOPED_TRACE(model.name);
    const HeightRaster raster = read_height_raster(folder / model.name);
    EXPECT_EQ(raster.columns, model.columns);
    EXPECT_EQ(raster.rows, model.rows);
    EXPECT_DOUBLE_EQ(raster.origin_x_m, model.origin_x_m);
    EXPECT_EQ(raster.cell_m, model.cell_m);
    std::size_t known = 0;
    for (const float height_m : raster.heights_m) {
      known += std::isnan(height_m) ? 0U : 1U;
      EXPECT_FALSE(height_m < 500.0F || height_m > 3800.0F) << "no height of the Tyrol";
    }
    EXPECT_GT(known, raster.heights_m.size() / 10);
    EXPECT_LT(known, raster.heights_m.size());
  }
}

}  // namespace
}  // namespace berm
