#include "vehicle_meshes.hpp"

#include <vector>

#include "mesh_builder.hpp"

namespace berm::sim {
namespace {

using Outline = std::vector<Eigen::Vector2d>;

void add_wheel(MeshBuilder& builder, double x, double y, double radius, double width) {
  builder.rod({x, y - 0.5 * width, radius}, {x, y + 0.5 * width, radius}, radius, radius, 14);
}

}  // namespace

VehicleModel make_groomer(std::uint16_t truth_id) {
  VehicleModel model;
  model.length_m = 9.0;
  model.width_m = 5.2;
  MeshBuilder builder(model.mesh);
  builder.set_material({Surface::metal, truth_id});
  const Outline track{{-2.1, 0.0}, {2.1, 0.0}, {2.7, 0.55}, {2.4, 0.95}, {-2.4, 0.95}, {-2.7, 0.55}};
  builder.extrude(track, 0.75, 2.15);
  builder.extrude(track, -2.15, -0.75);
  builder.set_material({Surface::paint, truth_id});
  builder.box({-2.5, -1.25, 0.7}, {2.3, 1.25, 1.45});
  const Outline cab{{0.3, 1.45}, {2.2, 1.45}, {1.9, 2.75}, {0.3, 2.8}};
  builder.extrude(cab, -1.2, 1.2);
  const Outline hood{{-2.5, 1.45}, {0.3, 1.45}, {0.3, 2.1}, {-2.3, 1.95}};
  builder.extrude(hood, -1.1, 1.1);
  builder.rod({0.9, 0.0, 2.7}, {0.9, 0.0, 3.0}, 0.12, 0.1, 8);
  builder.set_material({Surface::metal, truth_id});
  const Outline blade{{3.5, 0.05}, {3.75, 0.02}, {3.62, 0.6}, {3.8, 1.2}, {3.6, 1.25}, {3.4, 0.6}};
  // Convex halves of a curved blade.
  builder.extrude({blade[0], blade[1], blade[2], blade[5]}, -2.6, 2.6);
  builder.extrude({blade[5], blade[2], blade[3], blade[4]}, -2.6, 2.6);
  builder.box({2.2, -0.9, 0.45}, {3.5, -0.65, 0.7});
  builder.box({2.2, 0.65, 0.45}, {3.5, 0.9, 0.7});
  const Outline tiller{{-4.5, 0.02}, {-3.3, 0.05}, {-3.3, 0.75}, {-3.9, 0.8}, {-4.5, 0.2}};
  builder.extrude(tiller, -2.5, 2.5);
  builder.box({-3.4, -0.3, 0.5}, {-2.5, 0.3, 0.75});
  return model;
}

VehicleModel make_haul_truck(std::uint16_t truth_id) {
  VehicleModel model;
  model.length_m = 10.2;
  model.width_m = 6.2;
  MeshBuilder builder(model.mesh);
  builder.set_material({Surface::paint, truth_id});
  // Front wheels single, rear wheels double.
  for (const double side : {1.0, -1.0}) {
    add_wheel(builder, 3.0, side * 2.45, 1.35, 0.9);
    add_wheel(builder, -2.3, side * 2.55, 1.35, 0.9);
    add_wheel(builder, -2.3, side * 1.5, 1.35, 0.9);
  }
  builder.set_material({Surface::metal, truth_id});
  builder.box({-4.0, -0.7, 1.0}, {4.6, 0.7, 1.7});
  builder.rod({-2.3, -1.2, 1.35}, {-2.3, 1.2, 1.35}, 0.5, 0.5, 10);
  builder.box({4.3, -2.6, 0.9}, {5.1, 2.6, 2.6});
  builder.box({2.3, -2.7, 2.5}, {4.9, 2.7, 2.75});
  builder.set_material({Surface::paint, truth_id});
  const Outline cab{{2.9, 2.75}, {4.5, 2.75}, {4.3, 4.4}, {2.9, 4.4}};
  builder.extrude(cab, 0.5, 2.4);
  builder.box({3.0, -2.2, 2.75}, {4.4, -0.6, 3.5});
  builder.set_material({Surface::metal, truth_id});
  // Body: side silhouette of its bed, its sides, and the canopy above the cab.
  const Outline bed{{-5.1, 2.9}, {1.9, 2.0}, {2.3, 2.4}, {2.6, 4.7}, {-4.7, 4.1}};
  builder.extrude(bed, -3.0, 3.0);
  const Outline canopy{{2.4, 4.6}, {5.0, 4.95}, {5.0, 5.15}, {2.3, 4.9}};
  builder.extrude(canopy, -2.9, 2.9);
  return model;
}

VehicleModel make_car(std::uint16_t truth_id, double scale) {
  VehicleModel model;
  model.length_m = 4.4 * scale;
  model.width_m = 1.8 * scale;
  MeshBuilder builder(model.mesh);
  const auto at = [scale](double x, double z) { return Eigen::Vector2d(scale * x, scale * z); };
  builder.set_material({Surface::paint, truth_id});
  const Outline body{at(-2.15, 0.25), at(2.1, 0.25), at(2.2, 0.5), at(2.05, 0.8), at(-2.2, 0.95), at(-2.2, 0.4)};
  builder.extrude(body, -0.9 * scale, 0.9 * scale);
  const Outline cabin{at(-1.9, 0.9), at(1.15, 0.8), at(0.4, 1.45), at(-1.4, 1.48)};
  builder.extrude(cabin, -0.78 * scale, 0.78 * scale);
  builder.set_material({Surface::metal, truth_id});
  for (const double x : {1.35, -1.35}) {
    for (const double y : {0.8, -0.8}) {
      add_wheel(builder, scale * x, scale * y, 0.32 * scale, 0.22 * scale);
    }
  }
  return model;
}

}  // namespace berm::sim
