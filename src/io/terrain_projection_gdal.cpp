#include <memory>

#include <ogr_spatialref.h>

#include "berm/core/error.hpp"
#include "quiet_gdal.hpp"
#include "terrain_projection.hpp"

namespace berm {
namespace {

constexpr int kWgs84Code = 4326;

struct DestroyTransformation {
  void operator()(OGRCoordinateTransformation* t) const { OGRCoordinateTransformation::DestroyCT(t); }
};

}  // namespace

ToModel projection_to(const std::string& crs, const std::string& file) {
  const QuietGdal quiet;
  OGRSpatialReference earth;
  OGRSpatialReference model;
  const bool known =
      earth.importFromEPSG(kWgs84Code) == OGRERR_NONE && model.SetFromUserInput(crs.c_str()) == OGRERR_NONE;
  earth.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  model.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  std::shared_ptr<OGRCoordinateTransformation> transformation(
      known ? OGRCreateCoordinateTransformation(&earth, &model) : nullptr, DestroyTransformation());
  if (!transformation) {
    throw FileError(ErrorCode::unsupported, file, std::nullopt,
                    "has a coordinate system that cannot be used: " + QuietGdal::complaint());
  }
  return [transformation](const Geodetic& place) -> std::optional<Eigen::Vector2d> {
    double x = place.lon_deg;
    double y = place.lat_deg;
    if (transformation->Transform(1, &x, &y) == FALSE) {
      return std::nullopt;
    }
    return Eigen::Vector2d(x, y);
  };
}

}  // namespace berm
