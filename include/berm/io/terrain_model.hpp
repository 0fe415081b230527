#pragma once

#include <filesystem>
#include <functional>
#include <optional>

#include <Eigen/Core>

#include "berm/io/datum.hpp"
#include "berm/io/height_raster.hpp"

namespace berm {

/// Heights of an elevation model at places of the world frame.
class TerrainModel {
 public:
  /// Reads a model as `read_height_raster`. With a coordinate system and a `datum`, places are taken to the model by
  /// way of the earth, and its heights are above the ellipsoid; without either its coordinates are those of the world.
  /// `offset_m` is added to its heights. Throws FileError as `read_height_raster`; unsupported if a coordinate system
  /// has to be taken into account and this program was built without GDAL, or does not know it.
  [[nodiscard]] static TerrainModel read(const std::filesystem::path& path, const std::optional<Geodetic>& datum,
                                         double offset_m);
  TerrainModel(HeightRaster raster, double offset_m);

  /// z of the ground of the model above or below a place, in the world frame; blended between the middles of the four
  /// cells around it. None where one of them is not known.
  [[nodiscard]] std::optional<double> height_m(const Eigen::Vector3d& place_m) const;

 private:
  [[nodiscard]] std::optional<double> model_height_m(double x_m, double y_m) const;

  HeightRaster raster_;
  double offset_m_ = 0.0;
  std::optional<LocalFrame> frame_;
  std::function<std::optional<Eigen::Vector2d>(const Geodetic&)> to_model_;
};

}  // namespace berm
