#pragma once

#include <string>

#include "berm/core/config.hpp"

namespace berm::sim {

/// Which world, and what its ground is like away from the route.
struct WorldConfig {
  std::string kind = "piste";  ///< piste, haul_road, flat_road or car_park
  std::string elevation;  ///< elevation model (ESRI ASCII grid, GeoTIFF), relative to the scenario; empty: procedural
  double elevation_x_m = 0.0;  ///< where in the model the route begins: share 0..1 of its width
  double elevation_y_m = 0.0;
  double roughness_m = 0.5;  ///< of the procedural terrain
  double margin_m = 150.0;   ///< how far the world reaches beyond the route
  // ...
  static void fields(auto&& field);
  void check() const;
};

/// Course of the route: random bends and gradients within limits, or given.
struct RouteConfig {
  double length_m = 500.0;
  double min_radius_m = 25.0;
  double min_gradient_deg = -5.0;  ///< along the route; negative goes down
  double max_gradient_deg = 25.0;
  double bend_every_m = 80.0;
  static void fields(auto&& field);
  void check() const;
};

struct PisteConfig {
  double width_m = 30.0;
  static void fields(auto&& field);
  void check() const;
};
struct HaulRoadConfig {
  double min_width_m = 10.0;
  static void fields(auto&& field);
  void check() const;
};
struct ThingsConfig {
  double trees_per_hectare = 300.0;
  static void fields(auto&& field);
  void check() const;
};
struct TrafficConfig {
  int moving = 1;
  static void fields(auto&& field);
  void check() const;
};
struct DustConfig {
  int plumes = 0;
  static void fields(auto&& field);
  void check() const;
};

}  // namespace berm::sim
