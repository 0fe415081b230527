#pragma once

#include <string>

#include "berm/core/config.hpp"

namespace berm::sim {

/// Which world, and what its ground is like away from the route.
struct WorldConfig {
  std::string kind = "piste";
  std::string elevation;
  double elevation_x = 0.5;
  double elevation_y = 0.5;
  double roughness_m = 0.6;
  double side_slope_deg = 10.0;
  double margin_m = 150.0;

  static void fields(auto&& field) {
    field("kind", &WorldConfig::kind, Choices{{"piste", "haul_road", "flat_road", "car_park"}}, "what is built");
    field("elevation", &WorldConfig::elevation, TextLimit{1000},
          "elevation model (ESRI ASCII grid or GeoTIFF) that the world is cut into; empty: procedural terrain");
    field("elevation_x", &WorldConfig::elevation_x, Range{0.0, 1.0},
          "where in the model the route begins, as a share of its width from the west");
    field("elevation_y", &WorldConfig::elevation_y, Range{0.0, 1.0},
          "where in the model the route begins, as a share of its height from the south");
    field("roughness_m", &WorldConfig::roughness_m, Range{0.0, 10.0},
          "standard deviation of the procedural terrain away from the route");
    field("side_slope_deg", &WorldConfig::side_slope_deg, Range{0.0, 30.0},
          "largest slope of the procedural terrain across the route");
    field("margin_m", &WorldConfig::margin_m, Range{40.0, 400.0}, "how far the world reaches beyond the route");
  }
  void check() const { check_fields(*this, "world"); }
};

/// Course of the route: random bends and gradients within limits.
struct RouteConfig {
  double length_m = 500.0;
  double min_radius_m = 30.0;
  double bend_every_m = 70.0;
  double bend_deg = 45.0;
  double min_gradient_deg = -5.0;
  double max_gradient_deg = 25.0;
  double gradient_every_m = 120.0;
  double roller_height_m = 0.6;
  double roller_every_m = 45.0;

  static void fields(auto&& field) {
    field("length_m", &RouteConfig::length_m, Range{50.0, 5000.0}, "length, measured on the map");
    field("min_radius_m", &RouteConfig::min_radius_m, Range{8.0, 1000.0}, "of the sharpest bend, in the middle");
    field("bend_every_m", &RouteConfig::bend_every_m, Range{10.0, 1000.0}, "mean distance from bend to bend");
    field("bend_deg", &RouteConfig::bend_deg, Range{0.0, 120.0}, "turn of the sharpest bend");
    field("min_gradient_deg", &RouteConfig::min_gradient_deg, Range{-40.0, 40.0},
          "least gradient along the route; negative: downhill");
    field("max_gradient_deg", &RouteConfig::max_gradient_deg, Range{-40.0, 40.0}, "greatest gradient along the route");
    field("gradient_every_m", &RouteConfig::gradient_every_m, Range{20.0, 1000.0},
          "distance over which the gradient changes");
    field("roller_height_m", &RouteConfig::roller_height_m, Range{0.0, 3.0},
          "of rollers, crests and hollows, from bottom to top");
    field("roller_every_m", &RouteConfig::roller_every_m, Range{10.0, 200.0}, "mean distance from roller to roller");
  }
  /// Also refuses a least gradient above the greatest.
  void check() const;
};

/// A groomed run.
struct PisteConfig {
  double min_width_m = 16.0;
  double max_width_m = 32.0;
  double cross_fall_deg = 5.0;
  double min_bank_m = 0.2;
  double max_bank_m = 1.2;
  double bank_share = 0.75;
  double bank_slope_deg = 42.0;
  double undulation_m = 0.015;
  double rough_snow_m = 0.10;
  int forks = 1;

  static void fields(auto&& field) {
    field("min_width_m", &PisteConfig::min_width_m, Range{5.0, 100.0}, "where it is narrowest");
    field("max_width_m", &PisteConfig::max_width_m, Range{5.0, 100.0}, "where it is widest");
    field("cross_fall_deg", &PisteConfig::cross_fall_deg, Range{0.0, 15.0}, "greatest fall to a side");
    field("min_bank_m", &PisteConfig::min_bank_m, Range{0.05, 3.0}, "height of the lowest snow berms at the edges");
    field("max_bank_m", &PisteConfig::max_bank_m, Range{0.05, 3.0}, "height of the highest");
    field("bank_share", &PisteConfig::bank_share, Range{0.0, 1.0}, "share of the edges that has a snow berm");
    field("bank_slope_deg", &PisteConfig::bank_slope_deg, Range{15.0, 70.0}, "of their flanks");
    field("undulation_m", &PisteConfig::undulation_m, Range{0.0, 0.2}, "standard deviation of the groomed snow");
    field("rough_snow_m", &PisteConfig::rough_snow_m, Range{0.0, 1.0}, "standard deviation of the snow beside it");
    field("forks", &PisteConfig::forks, Range{0.0, 4.0}, "other runs that leave it");
  }
  /// Also refuses a least value above the greatest.
  void check() const;
};

/// A road in a mine: berms of dumped heaps, a pit wall on one side, a drop on the other.
struct HaulRoadConfig {
  double min_width_m = 10.0;
  double max_width_m = 28.0;
  double cross_fall_deg = 2.0;
  double min_berm_m = 0.5;
  double max_berm_m = 2.0;
  double min_repose_deg = 33.0;
  double max_repose_deg = 40.0;
  double gap_every_m = 70.0;
  double gap_m = 3.0;
  double wall_height_m = 12.0;
  double wall_slope_deg = 66.0;
  double drop_height_m = 12.0;
  double drop_slope_deg = 50.0;
  double rut_depth_m = 0.06;
  int potholes_per_km = 80;
  int puddles_per_km = 16;
  int rocks_per_km = 80;
  int junctions = 1;

  static void fields(auto&& field) {
    field("min_width_m", &HaulRoadConfig::min_width_m, Range{5.0, 60.0}, "where it is narrowest");
    field("max_width_m", &HaulRoadConfig::max_width_m, Range{5.0, 60.0}, "where it is widest");
    field("cross_fall_deg", &HaulRoadConfig::cross_fall_deg, Range{0.0, 10.0}, "greatest fall to a side");
    field("min_berm_m", &HaulRoadConfig::min_berm_m, Range{0.2, 5.0}, "height of the lowest heaps of the berms");
    field("max_berm_m", &HaulRoadConfig::max_berm_m, Range{0.2, 5.0}, "height of the highest");
    field("min_repose_deg", &HaulRoadConfig::min_repose_deg, Range{20.0, 50.0}, "slope of the flattest heaps");
    field("max_repose_deg", &HaulRoadConfig::max_repose_deg, Range{20.0, 50.0}, "slope of the steepest");
    field("gap_every_m", &HaulRoadConfig::gap_every_m, Range{0.0, 10000.0}, "mean distance of gaps; 0: none");
    field("gap_m", &HaulRoadConfig::gap_m, Range{0.5, 50.0}, "mean width of the gaps in the berms");
    field("wall_height_m", &HaulRoadConfig::wall_height_m, Range{0.0, 60.0}, "of each bench of the pit wall");
    field("wall_slope_deg", &HaulRoadConfig::wall_slope_deg, Range{30.0, 75.0}, "of the pit wall");
    field("drop_height_m", &HaulRoadConfig::drop_height_m, Range{0.0, 60.0}, "of each bench below the road");
    field("drop_slope_deg", &HaulRoadConfig::drop_slope_deg, Range{20.0, 75.0}, "of the drop");
    field("rut_depth_m", &HaulRoadConfig::rut_depth_m, Range{0.0, 0.5}, "of the ruts of the wheels");
    field("potholes_per_km", &HaulRoadConfig::potholes_per_km, Range{0.0, 2000.0}, "holes in the road");
    field("puddles_per_km", &HaulRoadConfig::puddles_per_km, Range{0.0, 500.0}, "water, which mirrors beams away");
    field("rocks_per_km", &HaulRoadConfig::rocks_per_km, Range{0.0, 2000.0}, "stones on the road and beside it");
    field("junctions", &HaulRoadConfig::junctions, Range{0.0, 4.0}, "roads that leave it");
  }
  /// Also refuses a least value above the greatest.
  void check() const;
};

/// A flat road or a car park, for comparison.
struct PavedConfig {
  double road_width_m = 8.0;
  double park_width_m = 56.0;
  double cross_fall_deg = 1.5;
  double verge_m = 0.05;

  static void fields(auto&& field) {
    field("road_width_m", &PavedConfig::road_width_m, Range{3.0, 40.0}, "width of a flat_road");
    field("park_width_m", &PavedConfig::park_width_m, Range{20.0, 200.0}, "width of a car_park");
    field("cross_fall_deg", &PavedConfig::cross_fall_deg, Range{0.0, 10.0}, "fall to the sides");
    field("verge_m", &PavedConfig::verge_m, Range{0.0, 0.5}, "how rough the verge is, standard deviation");
  }
  void check() const { check_fields(*this, "paved"); }
};

/// What stands beside the route.
struct ThingsConfig {
  double trees_per_hectare = 250.0;
  double tree_height_m = 14.0;
  double tree_reach_m = 90.0;
  double fence_share = 0.15;
  double pole_every_m = 30.0;
  double billboard_every_m = 150.0;
  double building_every_m = 250.0;
  double lamp_every_m = 0.0;
  bool lift = true;

  static void fields(auto&& field) {
    field("trees_per_hectare", &ThingsConfig::trees_per_hectare, Range{0.0, 2000.0}, "in the forest at the sides");
    field("tree_height_m", &ThingsConfig::tree_height_m, Range{1.0, 40.0}, "mean height");
    field("tree_reach_m", &ThingsConfig::tree_reach_m, Range{0.0, 200.0}, "how far beyond the edges trees stand");
    field("fence_share", &ThingsConfig::fence_share, Range{0.0, 1.0}, "share of the edges with a net fence");
    field("pole_every_m", &ThingsConfig::pole_every_m, Range{0.0, 1000.0}, "distance of marker poles; 0: none");
    field("billboard_every_m", &ThingsConfig::billboard_every_m, Range{0.0, 10000.0}, "mean distance; 0: none");
    field("building_every_m", &ThingsConfig::building_every_m, Range{0.0, 10000.0}, "mean distance; 0: none");
    field("lamp_every_m", &ThingsConfig::lamp_every_m, Range{0.0, 1000.0}, "distance of lamp posts; 0: none");
    field("lift", &ThingsConfig::lift, "a lift with pylons and a rope along a piste");
  }
  void check() const { check_fields(*this, "things"); }
};

/// Other machines: groomers on a piste, trucks on a haul road, cars elsewhere.
struct TrafficConfig {
  int ahead = 0;
  int oncoming = 1;
  int parked = 2;
  double speed_m_per_s = 3.0;
  double first_m = 60.0;

  static void fields(auto&& field) {
    field("ahead", &TrafficConfig::ahead, Range{0.0, 20.0}, "machines that drive ahead in the same direction");
    field("oncoming", &TrafficConfig::oncoming, Range{0.0, 20.0}, "machines that come towards, on the left");
    field("parked", &TrafficConfig::parked, Range{0.0, 500.0}, "machines that stand beside the way");
    field("speed_m_per_s", &TrafficConfig::speed_m_per_s, Range{0.1, 30.0}, "of the moving ones");
    field("first_m", &TrafficConfig::first_m, Range{10.0, 1000.0}, "where on the route the first begins");
  }
  void check() const { check_fields(*this, "traffic"); }
};

/// Dust: behind the moving machines, and blown up elsewhere along the route.
struct DustConfig {
  int plumes = 0;
  double size_m = 4.0;
  double extinction_per_m = 0.15;

  static void fields(auto&& field) {
    field("plumes", &DustConfig::plumes, Range{0.0, 500.0}, "how many");
    field("size_m", &DustConfig::size_m, Range{0.5, 30.0}, "mean standard deviation along the route");
    field("extinction_per_m", &DustConfig::extinction_per_m, Range{0.0, 5.0}, "in the middle of a plume");
  }
  void check() const { check_fields(*this, "dust"); }
};

/// All that a world is built from: the sections of a scenario that concern it.
struct WorldPlan {
  WorldConfig world;
  RouteConfig route;
  PisteConfig piste;
  HaulRoadConfig haul_road;
  PavedConfig paved;
  ThingsConfig things;
  TrafficConfig traffic;
  DustConfig dust;

  /// All sections, and what they have to do with each other: the sharpest bend must leave room for the width.
  void check() const;
};

}  // namespace berm::sim
