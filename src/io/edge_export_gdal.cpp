#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include "berm/core/error.hpp"
#include "edge_formats.hpp"
#include "quiet_gdal.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

/// What a GeoPackage says of its last change: the time of day would make other bytes of the same lines.
constexpr const char* kLastChange = "2000-01-01T00:00:00.000Z";
constexpr int kWgs84 = 4326;

/// Settings of GDAL for this thread, put back at the end.
class ThreadOption {
 public:
  ThreadOption(const char* key, const char* value) : key_(key) {
    const char* before = CPLGetThreadLocalConfigOption(key, nullptr);
    had_before_ = before != nullptr;
    before_ = had_before_ ? before : "";
    CPLSetThreadLocalConfigOption(key, value);
  }
  ~ThreadOption() { CPLSetThreadLocalConfigOption(key_, had_before_ ? before_.c_str() : nullptr); }
  ThreadOption(const ThreadOption&) = delete;
  ThreadOption& operator=(const ThreadOption&) = delete;

 private:
  const char* key_;
  std::string before_;
  bool had_before_ = false;
};

struct CloseDataset {
  void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};

/// A file that GDAL writes in memory, so that what reaches the disk goes by way of AtomicFile.
class MemoryDataset {
 public:
  MemoryDataset(const char* driver_name, const char* ending) {
    // Names are the process's; files of two threads must not meet.
    static std::atomic<unsigned> count{0};
    name_ = fmt::format("/vsimem/berm-{}.{}", count++, ending);
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_name);
    if (driver == nullptr) {
      throw Error(ErrorCode::unsupported, fmt::format("GDAL was built without its driver {}", driver_name));
    }
    dataset_.reset(driver->Create(name_.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    check(dataset_ != nullptr, "cannot be begun");
  }
  ~MemoryDataset() {
    dataset_.reset();
    VSIUnlink(name_.c_str());
  }
  MemoryDataset(const MemoryDataset&) = delete;
  MemoryDataset& operator=(const MemoryDataset&) = delete;

  OGRLayer& add_layer(const char* name, OGRSpatialReference* reference) {
    OGRLayer* layer = dataset_->CreateLayer(name, reference, wkbLineString25D, nullptr);
    check(layer != nullptr, "takes no layer");
    return *layer;
  }

  /// Ends writing.
  [[nodiscard]] std::string take_bytes() {
    CPLErrorReset();
    dataset_.reset();
    check(CPLGetLastErrorType() < CE_Failure, "cannot be ended");
    vsi_l_offset size = 0;
    const GByte* bytes = VSIGetMemFileBuffer(name_.c_str(), &size, FALSE);
    check(bytes != nullptr, "was not written");
    return {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size)};
  }

  static void check(bool good, const char* what) {
    if (!good) {
      throw Error(ErrorCode::write_failed, std::string("the file of edges ") + what + ": " + QuietGdal::complaint());
    }
  }

 private:
  std::string name_;
  std::unique_ptr<GDALDataset, CloseDataset> dataset_;
};

void add_field(OGRLayer& layer, const char* name, OGRFieldType type) {
  OGRFieldDefn field(name, type);
  MemoryDataset::check(layer.CreateField(&field) == OGRERR_NONE, "takes no field");
}

OGRSpatialReference wgs84() {
  OGRSpatialReference reference;
  MemoryDataset::check(reference.importFromEPSG(kWgs84) == OGRERR_NONE, "has no coordinate system");
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

/// GeoPackage has no lists: all as JSON, and the least as a number that can be filtered by.
void set_confidence(OGRFeature& feature, const GeoLine& line) {
  std::string list;
  double least = 1.0;
  for (const GeoLine::Vertex& vertex : line.vertices) {
    list += list.empty() ? "[" : ",";
    append_fixed(list, vertex.confidence, kConfidenceDecimals);
    least = std::min(least, vertex.confidence);
  }
  feature.SetField("confidence", (list + "]").c_str());
  feature.SetField("min_confidence", rounded(least, kConfidenceDecimals));
}

/// The same for heights; no least where none is known.
void set_height(OGRFeature& feature, const GeoLine& line) {
  std::string list;
  std::optional<double> least_m;
  for (const GeoLine::Vertex& vertex : line.vertices) {
    list += list.empty() ? "[" : ",";
    if (!vertex.berm_height_m) {
      list += "null";
      continue;
    }
    append_fixed(list, *vertex.berm_height_m, kMetreDecimals);
    least_m = std::min(least_m.value_or(*vertex.berm_height_m), *vertex.berm_height_m);
  }
  feature.SetField("berm_height_m", (list + "]").c_str());
  if (least_m) {
    feature.SetField("min_berm_height_m", rounded(*least_m, kMetreDecimals));
  }
}

void add_feature(OGRLayer& layer, OGRFeature& feature, const OGRLineString& geometry) {
  MemoryDataset::check(feature.SetGeometry(&geometry) == OGRERR_NONE, "takes no line");
  MemoryDataset::check(layer.CreateFeature(&feature) == OGRERR_NONE, "takes no feature");
}

}  // namespace

std::string to_geopackage(std::span<const GeoLine> lines) {
  const QuietGdal quiet;
  const ThreadOption date("OGR_CURRENT_DATE", kLastChange);
  MemoryDataset dataset("GPKG", "gpkg");
  OGRSpatialReference reference = wgs84();
  OGRLayer& layer = dataset.add_layer("road_edges", &reference);
  add_field(layer, "line", OFTInteger64);
  add_field(layer, "side", OFTString);
  add_field(layer, "min_confidence", OFTReal);
  add_field(layer, "confidence", OFTString);
  add_field(layer, "min_berm_height_m", OFTReal);
  add_field(layer, "berm_height_m", OFTString);
  for (const GeoLine& line : lines) {
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField("line", static_cast<GIntBig>(line.number));
    feature.SetField("side", std::string(side_name(line.side)).c_str());
    set_confidence(feature, line);
    set_height(feature, line);
    OGRLineString geometry;
    for (const GeoLine::Vertex& vertex : line.vertices) {
      geometry.addPoint(vertex.place.lon_deg, vertex.place.lat_deg, vertex.place.h_m);
    }
    add_feature(layer, feature, geometry);
  }
  return dataset.take_bytes();
}

std::string to_dxf(std::span<const EdgeLine> lines) {
  const QuietGdal quiet;
  MemoryDataset dataset("DXF", "dxf");
  OGRLayer& layer = dataset.add_layer("entities", nullptr);
  for (const EdgeLine& line : lines) {
    OGRFeature feature(layer.GetLayerDefn());
    feature.SetField("Layer", ("road_edge_" + std::string(side_name(line.side))).c_str());
    OGRLineString geometry;
    for (const EdgeLine::Vertex& vertex : line.vertices) {
      geometry.addPoint(rounded(vertex.position_m.x(), kMetreDecimals), rounded(vertex.position_m.y(), kMetreDecimals),
                        rounded(vertex.position_m.z(), kMetreDecimals));
    }
    add_feature(layer, feature, geometry);
  }
  return dataset.take_bytes();
}

}  // namespace berm
