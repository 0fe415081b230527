#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mesh_builder.hpp"
#include "things.hpp"

namespace berm::sim {
namespace {

/// On the road they keep out of the way of who drives in the middle.
constexpr double kOnRoadShare = 0.25;
constexpr double kMiddle_m = 3.0;

/// Icosahedron with the golden ratio.
constexpr double kPhi = 1.618033988749895;
constexpr std::array<std::array<double, 3>, 12> kVertices{{{-1, kPhi, 0},
                                                           {1, kPhi, 0},
                                                           {-1, -kPhi, 0},
                                                           {1, -kPhi, 0},
                                                           {0, -1, kPhi},
                                                           {0, 1, kPhi},
                                                           {0, -1, -kPhi},
                                                           {0, 1, -kPhi},
                                                           {kPhi, 0, -1},
                                                           {kPhi, 0, 1},
                                                           {-kPhi, 0, -1},
                                                           {-kPhi, 0, 1}}};
constexpr std::array<std::array<std::size_t, 3>, 20> kFaces{
    {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
     {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
     {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};

void add_rock(MeshBuilder& builder, double size_m, Random& random) {
  std::array<Eigen::Vector3d, 12> vertices;
  const Eigen::Vector3d axes{random.uniform(0.7, 1.2), random.uniform(0.6, 1.0), random.uniform(0.45, 0.8)};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Eigen::Vector3d corner(kVertices[i][0], kVertices[i][1], kVertices[i][2]);
    vertices[i] = 0.5 * size_m * random.uniform(0.75, 1.15) * corner.normalized().cwiseProduct(axes);
  }
  for (const auto& face : kFaces) {
    builder.triangle(vertices[face[0]], vertices[face[1]], vertices[face[2]]);
  }
}

}  // namespace

void add_rocks(const Site& site, TriangleMesh& mesh) {
  if (!site.is("haul_road")) {
    return;
  }
  const double length = site.plan.route.length_m;
  const auto count = static_cast<std::uint64_t>(std::lround(site.plan.haul_road.rocks_per_km * length / 1000.0));
  MeshBuilder builder(mesh);
  builder.set_material({Surface::rock, truth::kTerrain});
  for (std::uint64_t i = 0; i < count; ++i) {
    Random random = random_of(site, ThingRandom::rocks, i);
    const double s = random.uniform(0.0, length);
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    const RoutePoint at = site.main_run().route.at(s);
    const double half = side > 0.0 ? at.left_m : at.right_m;
    const bool on_road = random.chance(kOnRoadShare) && half > kMiddle_m + 0.5;
    const double beyond = on_road ? -random.uniform(0.2, half - kMiddle_m) : random.uniform(0.2, 6.0);
    // Many small ones, few large ones.
    const double most = on_road ? 0.4 : 1.1;
    const double size = std::min(most, 0.15 + 0.2 * random.exponential());
    const RoadsidePlace place = roadside(site, s, side, beyond);
    builder.set_frame(upright_frame(place.ground_m + Eigen::Vector3d(0, 0, 0.12 * size),
                                    random.uniform(0.0, 2.0 * std::numbers::pi)));
    add_rock(builder, size, random);
  }
}

}  // namespace berm::sim
