#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "berm/core/error.hpp"
#include "berm/io/trajectory_file.hpp"
#include "geotiff.hpp"
#include "quiet_gdal.hpp"
#include "raster_check.hpp"
#include "to_float.hpp"

namespace berm {
namespace {

struct CloseInput {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseInput>;

class GeotiffReader {
 public:
  explicit GeotiffReader(const std::filesystem::path& path) : name_(path.string()) {}

  HeightRaster read() {
    open();
    check_raster_size(name_, static_cast<std::uint64_t>(dataset_->GetRasterXSize()),
                      static_cast<std::uint64_t>(dataset_->GetRasterYSize()));
    raster_.columns = static_cast<std::size_t>(dataset_->GetRasterXSize());
    raster_.rows = static_cast<std::size_t>(dataset_->GetRasterYSize());
    take_place();
    take_crs();
    take_heights();
    check_has_heights(name_, raster_);
    return std::move(raster_);
  }

 private:
  [[noreturn]] void refuse(ErrorCode code, const std::string& problem) const {
    throw FileError(code, name_, std::nullopt, problem);
  }

  void open() {
    // No other driver: a file must not name a second one, or an address in the network.
    const char* const drivers[] = {"GTiff", nullptr};
    dataset_.reset(
        GDALDataset::Open(name_.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR, drivers));
    if (!dataset_) {
      refuse(ErrorCode::malformed, "this is no GeoTIFF that can be read: " + quiet_.complaint());
    }
    if (dataset_->GetRasterCount() != 1 && !has_named_heights()) {
      refuse(ErrorCode::unsupported,
             fmt::format("holds {} bands, expected one of heights; take it out with gdal_translate -b",
                         dataset_->GetRasterCount()));
    }
    if (GDALDataTypeIsComplex(dataset_->GetRasterBand(1)->GetRasterDataType()) != 0) {
      refuse(ErrorCode::unsupported, "holds complex numbers, expected heights");
    }
  }

  /// As the rasters of berm have them.
  [[nodiscard]] bool has_named_heights() const {
    return dataset_->GetRasterCount() > 1 && dataset_->GetRasterBand(1)->GetDescription() == std::string("height");
  }

  void take_place() {
    double t[6] = {};
    if (dataset_->GetGeoTransform(t) != CE_None) {
      refuse(ErrorCode::malformed, "does not say where it lies (no geotransform)");
    }
    if (t[2] != 0.0 || t[4] != 0.0 || !(t[1] > 0.0) || !(t[5] < 0.0)) {
      refuse(ErrorCode::unsupported,
             "is rotated or mirrored, expected rows from west to east and north first; "
             "straighten it with gdalwarp");
    }
    check_cell_size(name_, t[1]);
    if (!(std::abs(t[1] + t[5]) <= 1e-6 * t[1])) {
      refuse(ErrorCode::unsupported,
             fmt::format("cells of {} x {} m are not square; resample the model with gdalwarp -tr", t[1], -t[5]));
    }
    raster_.cell_m = t[1];
    raster_.origin_x_m = t[0];
    raster_.origin_y_m = t[3] + t[5] * static_cast<double>(raster_.rows);
    if (!(std::abs(raster_.origin_x_m) <= kMaxCoordinate_m && std::abs(raster_.origin_y_m) <= kMaxCoordinate_m)) {
      refuse(ErrorCode::malformed, fmt::format("lies at {}, {} m, beyond +-1e9 m", t[0], t[3]));
    }
  }

  void take_crs() {
    const OGRSpatialReference* reference = dataset_->GetSpatialRef();
    if (reference == nullptr) {
      return;
    }
    if (reference->IsGeographic() != 0) {
      refuse(ErrorCode::unsupported, "is in degrees; reproject it with gdalwarp -t_srs EPSG:326ZZ (UTM zone ZZ)");
    }
    char* text = nullptr;
    if (reference->exportToWkt(&text) == OGRERR_NONE && text != nullptr) {
      raster_.crs = text;
    }
    CPLFree(text);
  }

  void take_heights() {
    GDALRasterBand& band = *dataset_->GetRasterBand(1);
    raster_.heights_m.resize(raster_.columns * raster_.rows);
    int has_nodata = 0;
    const double declared = band.GetNoDataValue(&has_nodata);
    const float nodata = has_nodata != 0 ? to_float(declared) : std::numeric_limits<float>::quiet_NaN();
    const int columns = dataset_->GetRasterXSize();
    for (std::size_t line = 0; line < raster_.rows; ++line) {
      const std::size_t row = raster_.rows - 1 - line;
      float* heights = raster_.heights_m.data() + row * raster_.columns;
      if (band.RasterIO(GF_Read, 0, static_cast<int>(line), columns, 1, heights, columns, 1, GDT_Float32, 0, 0,
                        nullptr) != CE_None) {
        refuse(ErrorCode::malformed, fmt::format("row {} cannot be read: {}", line + 1, quiet_.complaint()));
      }
      for (std::size_t column = 0; column < raster_.columns; ++column) {
        heights[column] = check_height(heights[column], nodata, line, column);
      }
    }
  }

  [[nodiscard]] float check_height(float height_m, float nodata, std::size_t line, std::size_t column) const {
    // The largest double, which some programs declare, arrives as infinity or as the largest float.
    const bool huge = std::isinf(nodata) && std::abs(height_m) >= std::numeric_limits<float>::max();
    const bool is_nodata = std::isnan(nodata) ? std::isnan(height_m) : height_m == nodata || huge;
    if (is_nodata) {
      return std::numeric_limits<float>::quiet_NaN();
    }
    if (!(std::abs(height_m) <= static_cast<float>(kMaxHeight_m))) {
      refuse(ErrorCode::malformed,
             fmt::format("{} in row {}, column {} is no height in metres", height_m, line + 1, column + 1));
    }
    return height_m;
  }

  QuietGdal quiet_;
  std::string name_;
  Dataset dataset_;
  HeightRaster raster_;
};

}  // namespace

HeightRaster read_geotiff(const std::filesystem::path& path) {
  return GeotiffReader(path).read();
}

}  // namespace berm
