#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include "berm/core/error.hpp"
#include "quiet_gdal.hpp"
#include "raster_geotiff.hpp"

namespace berm {
namespace {

constexpr double kNodataHeight = -9999.0;

void check(bool good, const char* what) {
  if (!good) {
    throw Error(ErrorCode::write_failed, std::string("the raster ") + what + ": " + QuietGdal::complaint());
  }
}

/// Files in memory have names, too: one per call.
std::string memory_name() {
  static std::atomic<unsigned> calls = 0;
  return fmt::format("/vsimem/berm-raster-{}.tif", ++calls);
}

struct CloseOutput {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

struct MemoryFile {
  std::string name = memory_name();
  MemoryFile() = default;
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { VSIUnlink(name.c_str()); }
};

/// The plane that touches the earth at a datum, as near as a map projection comes: within 1 mm at 1 km, apart from the
/// datum's height, which stretches by 1.6e-7 per metre.
void set_place(GDALDataset& dataset, const RasterFrame& frame) {
  double place[6] = {
      frame.origin_x_m, frame.cell_m, 0.0, frame.origin_y_m + frame.cell_m * static_cast<double>(frame.rows), 0.0,
      -frame.cell_m};
  check(dataset.SetGeoTransform(place) == CE_None, "takes no place");
  if (!frame.datum) {
    return;
  }
  OGRSpatialReference reference;
  const std::string projection = fmt::format("+proj=aeqd +lat_0={} +lon_0={} +x_0=0 +y_0=0 +datum=WGS84 +units=m",
                                             frame.datum->lat_deg, frame.datum->lon_deg);
  check(reference.importFromProj4(projection.c_str()) == OGRERR_NONE && dataset.SetSpatialRef(&reference) == CE_None,
        "takes no coordinate system");
}

void write_band(GDALRasterBand& target, const RasterFrame& frame, const RasterBand& band) {
  target.SetDescription(band.name.c_str());
  target.SetUnitType(band.unit.c_str());
  check(target.SetNoDataValue(kNodataHeight) == CE_None, "takes no NODATA");
  std::vector<float> values(frame.columns);
  for (std::size_t line = 0; line < frame.rows; ++line) {
    values.assign(frame.columns, std::numeric_limits<float>::quiet_NaN());
    band.fill(frame.rows - 1 - line, values);
    for (float& value : values) {
      value = std::isnan(value) ? static_cast<float>(kNodataHeight) : value;
    }
    check(target.RasterIO(GF_Write, 0, static_cast<int>(line), static_cast<int>(frame.columns), 1, values.data(),
                          static_cast<int>(frame.columns), 1, GDT_Float32, 0, 0, nullptr) == CE_None,
          "takes no row");
  }
}

}  // namespace

std::string to_geotiff(const RasterFrame& frame, std::span<const RasterBand> bands) {
  const QuietGdal quiet;
  const MemoryFile file;
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  check(driver != nullptr, "needs the driver GTiff of GDAL");
  CPLStringList options;
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", "3");
  options.SetNameValue("INTERLEAVE", "BAND");
  options.SetNameValue("BIGTIFF", "IF_SAFER");
  {
    const std::unique_ptr<GDALDataset, CloseOutput> dataset(
        driver->Create(file.name.c_str(), static_cast<int>(frame.columns), static_cast<int>(frame.rows),
                       static_cast<int>(bands.size()), GDT_Float32, options.List()));
    check(dataset != nullptr, "cannot be begun");
    set_place(*dataset, frame);
    for (std::size_t i = 0; i < bands.size(); ++i) {
      write_band(*dataset->GetRasterBand(static_cast<int>(i) + 1), frame, bands[i]);
    }
    CPLErrorReset();
  }
  check(CPLGetLastErrorType() < CE_Failure, "cannot be ended");
  vsi_l_offset size = 0;
  const GByte* bytes = VSIGetMemFileBuffer(file.name.c_str(), &size, FALSE);
  check(bytes != nullptr, "was not written");
  return {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)};
}

}  // namespace berm
