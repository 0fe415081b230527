#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "berm/core/error.hpp"
#include "berm/io/height_raster.hpp"
#include "berm/io/raster_file.hpp"
#include "berm/io/terrain_model.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr RasterFrame kFrame{.origin_x_m = -10.0, .origin_y_m = 5.0, .cell_m = 0.5, .columns = 4, .rows = 3};

float height_m(std::size_t column, std::size_t row) {
  return 100.0F + static_cast<float>(column) + 10.0F * static_cast<float>(row);
}

std::vector<RasterBand> bands() {
  const auto heights = [](std::size_t row, std::span<float> values) {
    for (std::size_t column = 0; column + 1 < values.size(); ++column) {
      values[column] = height_m(column, row);
    }
  };
  const auto depths = [](std::size_t row, std::span<float> values) { values[row] = 0.25F; };
  return {{"height", "m", 3, heights}, {"depth", "m", 3, depths}};
}

void expect_heights(const HeightRaster& read) {
  ASSERT_EQ(read.columns, 4U);
  ASSERT_EQ(read.rows, 3U);
  EXPECT_EQ(read.cell_m, 0.5);
  EXPECT_EQ(read.origin_x_m, -10.0);
  EXPECT_EQ(read.origin_y_m, 5.0);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      EXPECT_EQ(read.at(column, row), height_m(column, row));
    }
    EXPECT_TRUE(std::isnan(read.at(3, row))) << "not known";
  }
}

TEST(SurfaceRasterTest, AsciiGridsAreReadBack) {
  const test::TempFolder folder;
  EXPECT_THAT(write_raster(folder.path(), "ground", kFrame, bands(), RasterFormat::ascii),
              ElementsAre("ground.asc", "ground_depth.asc"));
  expect_heights(read_height_raster(folder / "ground.asc"));
  const HeightRaster depth = read_height_raster(folder / "ground_depth.asc");
  EXPECT_EQ(depth.at(1, 1), 0.25F);
  EXPECT_TRUE(std::isnan(depth.at(0, 1)));
}

TEST(SurfaceRasterTest, NothingToWriteIsRefused) {
  const test::TempFolder folder;
  RasterFrame empty = kFrame;
  empty.rows = 0;
  EXPECT_THROW(write_raster(folder.path(), "a", empty, bands()), Error);
  RasterFrame huge = kFrame;
  huge.rows = kMaxRasterCells;
  EXPECT_THROW(write_raster(folder.path(), "a", huge, bands()), Error);
  EXPECT_THROW(write_raster(folder.path(), "a", kFrame, {}), Error);
}

#ifdef BERM_WITH_GDAL
std::string output_of(const std::string& command) {
  std::string text;
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(::popen(command.c_str(), "r"), ::pclose);
  char piece[256];
  while (pipe && std::fgets(piece, sizeof(piece), pipe.get()) != nullptr) {
    text += piece;
  }
  return text;
}

TEST(SurfaceRasterTest, GeotiffsAreReadBack) {
  const test::TempFolder folder;
  EXPECT_THAT(write_raster(folder.path(), "ground", kFrame, bands()), ElementsAre("ground.tif"));
  expect_heights(read_height_raster(folder / "ground.tif"));
  const std::string first = test::slurp(folder / "ground.tif");
  write_raster(folder.path(), "ground", kFrame, bands());
  EXPECT_TRUE(test::slurp(folder / "ground.tif") == first) << "the same bytes";
  const std::string text = output_of("gdalinfo -stats '" + (folder / "ground.tif").string() + "' 2>/dev/null");
  if (text.empty()) {
    GTEST_SKIP() << "there is no gdalinfo";
  }
  EXPECT_THAT(text, HasSubstr("Size is 4, 3"));
  EXPECT_THAT(text, HasSubstr("Description = height"));
  EXPECT_THAT(text, HasSubstr("Description = depth"));
  EXPECT_THAT(text, HasSubstr("NoData Value=-9999"));
  EXPECT_THAT(text, HasSubstr("Minimum=100.000, Maximum=122.000"));
}

TEST(SurfaceRasterTest, AModelInAProjectionIsFoundByTheDatum) {
  const Geodetic datum{47.0, 11.0, 2000.0};
  const test::TempFolder folder;
  RasterFrame frame{
      .origin_x_m = -50.0, .origin_y_m = -50.0, .cell_m = 1.0, .columns = 100, .rows = 100, .datum = datum};
  const std::vector<RasterBand> slope = {{"height", "m", 3, [](std::size_t row, std::span<float> values) {
                                            std::fill(values.begin(), values.end(),
                                                      2000.0F + 0.1F * static_cast<float>(row));
                                          }}};
  write_raster(folder.path(), "summer", frame, slope);
  const TerrainModel model = TerrainModel::read(folder / "summer.tif", datum, -5.0);
  // 20 m north of the datum: row 70 begins there.
  const auto height = model.height_m({3.0, 20.0, 1.0});
  ASSERT_TRUE(height.has_value());
  EXPECT_NEAR(*height, 0.1 * 69.5 - 5.0, 0.01);
  EXPECT_FALSE(model.height_m({300.0, 20.0, 1.0}).has_value());
  // Without a datum the numbers are those of the world.
  EXPECT_NEAR(*TerrainModel::read(folder / "summer.tif", std::nullopt, 0.0).height_m({3.0, 20.0, 1.0}), 2006.95, 1e-3);
}
#else
TEST(SurfaceRasterTest, WithoutGdalAsciiGridsAreWritten) {
  const test::TempFolder folder;
  EXPECT_THAT(write_raster(folder.path(), "ground", kFrame, bands()), ElementsAre("ground.asc", "ground_depth.asc"));
  EXPECT_THROW(write_raster(folder.path(), "ground", kFrame, bands(), RasterFormat::geotiff), Error);
}
#endif

TEST(TerrainModelTest, BlendsBetweenCellsAndKnowsItsEnds) {
  HeightRaster raster{.origin_x_m = 0.0, .origin_y_m = 0.0, .cell_m = 2.0, .columns = 3, .rows = 2};
  raster.heights_m = {0.0F, 2.0F, 4.0F, 10.0F, 12.0F, std::nanf("")};
  const TerrainModel model(raster, 0.5);
  EXPECT_DOUBLE_EQ(*model.height_m({1.0, 1.0, 99.0}), 0.5);
  EXPECT_DOUBLE_EQ(*model.height_m({2.0, 2.0, 0.0}), 6.5);
  EXPECT_FALSE(model.height_m({4.0, 2.0, 0.0})) << "a corner is not known";
  EXPECT_FALSE(model.height_m({0.9, 1.0, 0.0}));
  EXPECT_FALSE(model.height_m({1.0, 3.1, 0.0}));
  EXPECT_FALSE(model.height_m({std::nan(""), 1.0, 0.0}));
}

}  // namespace
}  // namespace berm
