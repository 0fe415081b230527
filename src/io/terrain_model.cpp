#include "berm/io/terrain_model.hpp"

#include <cmath>
#include <utility>

#include "berm/core/error.hpp"
#include "terrain_projection.hpp"

namespace berm {

#ifndef BERM_WITH_GDAL
ToModel projection_to(const std::string& /*crs*/, const std::string& file) {
  throw FileError(ErrorCode::unsupported, file, std::nullopt,
                  "has a coordinate system, which this program was built without (GDAL); install libgdal-dev and build "
                  "again, or bring the model into the world frame of the run and leave its .prj away");
}
#endif

TerrainModel::TerrainModel(HeightRaster raster, double offset_m) : raster_(std::move(raster)), offset_m_(offset_m) {}

TerrainModel TerrainModel::read(const std::filesystem::path& path, const std::optional<Geodetic>& datum,
                                double offset_m) {
  TerrainModel model(read_height_raster(path), offset_m);
  if (datum && !model.raster_.crs.empty()) {
    model.frame_.emplace(*datum);
    model.to_model_ = projection_to(model.raster_.crs, path.string());
  }
  return model;
}

std::optional<double> TerrainModel::model_height_m(double x_m, double y_m) const {
  const double column = (x_m - raster_.origin_x_m) / raster_.cell_m - 0.5;
  const double row = (y_m - raster_.origin_y_m) / raster_.cell_m - 0.5;
  const double left = std::floor(column);
  const double low = std::floor(row);
  if (!(left >= 0.0 && low >= 0.0 && left + 1.0 < static_cast<double>(raster_.columns) &&
        low + 1.0 < static_cast<double>(raster_.rows))) {
    return std::nullopt;
  }
  const auto at = [&](std::size_t across, std::size_t up) {
    return double{raster_.at(static_cast<std::size_t>(left) + across, static_cast<std::size_t>(low) + up)};
  };
  const double u = column - left;
  const double v = row - low;
  const double height_m = (1.0 - v) * ((1.0 - u) * at(0, 0) + u * at(1, 0)) + v * ((1.0 - u) * at(0, 1) + u * at(1, 1));
  return std::isnan(height_m) ? std::nullopt : std::optional(height_m + offset_m_);
}

std::optional<double> TerrainModel::height_m(const Eigen::Vector3d& place_m) const {
  if (!to_model_) {
    return model_height_m(place_m.x(), place_m.y());
  }
  const Geodetic place = frame_->to_geodetic(place_m);
  const auto in_model_m = to_model_(place);
  const auto height_m = in_model_m ? model_height_m(in_model_m->x(), in_model_m->y()) : std::nullopt;
  return height_m ? std::optional(place_m.z() - (place.h_m - *height_m)) : std::nullopt;
}

}  // namespace berm
