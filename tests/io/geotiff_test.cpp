#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include "berm/io/height_raster.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::expect_file_error;

/// What a GeoTIFF of a test holds; heights are 10 row + column, the northern row first.
struct Made {
  int columns = 4;
  int rows = 3;
  int bands = 1;
  GDALDataType type = GDT_Float64;
  std::vector<double> transform = {500'000.0, 2.0, 0.0, 5'200'000.0, 0.0, -2.0};
  int epsg = 32632;  ///< 0: none
  double nodata = -9999.0;
};

class GeotiffTest : public testing::Test {
 protected:
  void make(const Made& made) {
    GDALAllRegister();
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    ASSERT_NE(driver, nullptr);
    GDALDataset* dataset = driver->Create(file_.c_str(), made.columns, made.rows, made.bands, made.type, nullptr);
    ASSERT_NE(dataset, nullptr);
    if (!made.transform.empty()) {
      std::vector<double> transform = made.transform;
      dataset->SetGeoTransform(transform.data());
    }
    if (made.epsg != 0) {
      OGRSpatialReference reference;
      ASSERT_EQ(reference.importFromEPSG(made.epsg), OGRERR_NONE);
      dataset->SetSpatialRef(&reference);
    }
    GDALRasterBand& band = *dataset->GetRasterBand(1);
    band.SetNoDataValue(made.nodata);
    std::vector<double> line(static_cast<std::size_t>(made.columns));
    for (int row = 0; row < made.rows; ++row) {
      for (int column = 0; column < made.columns; ++column) {
        line[static_cast<std::size_t>(column)] = row == 1 && column == 2 ? made.nodata : 10.0 * row + column;
      }
      ASSERT_EQ(
          band.RasterIO(GF_Write, 0, row, made.columns, 1, line.data(), made.columns, 1, GDT_Float64, 0, 0, nullptr),
          CE_None);
    }
    GDALClose(dataset);
  }

  void expect_refused(ErrorCode code, const std::string& part) const {
    expect_file_error(code, part, [this] { (void)read_height_raster(file_); });
  }

  test::TempFolder folder_;
  std::string file_ = (folder_ / "model.tif").string();
};

TEST_F(GeotiffTest, IsReadLikeAnAsciiGrid) {
  for (const GDALDataType type : {GDT_Float64, GDT_Float32, GDT_Int16}) {
    Made made;
    made.type = type;
    make(made);
    const HeightRaster raster = read_height_raster(file_);
    EXPECT_EQ(raster.columns, 4U);
    EXPECT_EQ(raster.rows, 3U);
    EXPECT_EQ(raster.origin_x_m, 500'000.0);
    EXPECT_EQ(raster.origin_y_m, 5'199'994.0);
    EXPECT_EQ(raster.cell_m, 2.0);
    EXPECT_EQ(raster.at(0, 2), 0.0F);
    EXPECT_EQ(raster.at(3, 0), 23.0F);
    EXPECT_TRUE(std::isnan(raster.at(2, 1)));
    EXPECT_NE(raster.crs.find("UTM zone 32N"), std::string::npos) << raster.crs;
  }
}

TEST_F(GeotiffTest, NeedsNoCoordinateSystem) {
  Made made;
  made.epsg = 0;
  make(made);
  EXPECT_EQ(read_height_raster(file_).at(1, 2), 1.0F);
}

TEST_F(GeotiffTest, RefusesWhatIsNoPlainModel) {
  Made made;
  made.transform = {0.0, 2.0, 0.1, 0.0, 0.1, -2.0};
  make(made);
  expect_refused(ErrorCode::unsupported, "rotated");
  made.transform = {0.0, 2.0, 0.0, 0.0, 0.0, 2.0};
  make(made);
  expect_refused(ErrorCode::unsupported, "rotated or mirrored");
  made.transform = {0.0, 2.0, 0.0, 0.0, 0.0, -3.0};
  make(made);
  expect_refused(ErrorCode::unsupported, "cells of 2 x 3 m are not square");
  made.transform = {11.0, 0.5, 0.0, 47.0, 0.0, -0.5};
  made.epsg = 4326;
  make(made);
  expect_refused(ErrorCode::unsupported, "is in degrees");
  made = {};
  made.bands = 3;
  make(made);
  expect_refused(ErrorCode::unsupported, "holds 3 bands");
  made = {};
  made.transform.clear();
  make(made);
  expect_refused(ErrorCode::malformed, "does not say where it lies");
  made = {};
  made.type = GDT_CFloat32;
  make(made);
  expect_refused(ErrorCode::unsupported, "complex");
}

TEST_F(GeotiffTest, ATileFarTooLargeIsRefusedByItsHeader) {
  GDALAllRegister();
  // Sparse: a billion cells in a file of a few hundred kilobytes.
  const char* const options[] = {"SPARSE_OK=TRUE", "TILED=YES", nullptr};
  GDALDataset* dataset = GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      file_.c_str(), 32'000, 32'000, 1, GDT_Float32, const_cast<char**>(options));
  ASSERT_NE(dataset, nullptr);
  GDALClose(dataset);
  expect_refused(ErrorCode::unsupported, "32000 x 32000 cells are more than");
}

TEST_F(GeotiffTest, CutOrSpoiltItIsOneError) {
  make({});
  const std::string whole = test::slurp(file_);
  for (std::size_t length = 4; length < whole.size(); length += 7) {
    test::spill(file_, whole.substr(0, length));
    try {
      const HeightRaster raster = read_height_raster(file_);
      EXPECT_EQ(raster.heights_m.size(), raster.columns * raster.rows);
    } catch (const FileError& error) {
      EXPECT_EQ(error.file(), file_);
    }
  }
}

}  // namespace
}  // namespace berm
