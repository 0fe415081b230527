#include "berm/sim/photograph.hpp"

#include <gtest/gtest.h>

#include "caster_worlds.hpp"

namespace berm::sim {
namespace {

struct Color {
  int r;
  int g;
  int b;
};

Color at(const Photograph& picture, int column, int row) {
  const std::size_t first = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width_px) +
                                 static_cast<std::size_t>(column));
  return {picture.rgb[first], picture.rgb[first + 1], picture.rgb[first + 2]};
}

/// From 20 m up, straight ahead, the ground in the lower half.
Camera level_camera() {
  Camera camera;
  camera.eye_m = {-40.0, 0.0, 20.0};
  camera.target_m = {40.0, 0.0, 20.0};
  camera.width_px = 160;
  camera.height_px = 120;
  return camera;
}

TEST(Photograph, ShowsSkyAboveDrivableGroundAndItsOrangeEdges) {
  const RayCaster caster(world_of(plane_terrain(0.0, 0.0, 8.0), 100.0), {});
  const Photograph picture = photograph(caster, level_camera(), 1);
  ASSERT_EQ(picture.rgb.size(), 3U * 160U * 120U);
  const Color sky = at(picture, 80, 5);
  EXPECT_GT(sky.b, sky.r);
  const Color road = at(picture, 80, 110);
  const Color verge = at(picture, 5, 110);
  EXPECT_GT(road.g - road.r, verge.g - verge.r);
  int orange = 0;
  for (int column = 0; column < 160; ++column) {
    const Color c = at(picture, column, 110);
    orange += c.r > 2 * c.b && c.r > c.g ? 1 : 0;
  }
  EXPECT_GE(orange, 2) << "one edge on each side";
  EXPECT_LE(orange, 8);
}

TEST(Photograph, ThingsThrowShade) {
  World world = world_of(plane_terrain(0.0, 0.0, 100.0), 100.0);
  const RayCaster bare(world, {});
  // A roof over everything: the ground below is in its shade.
  add_quad(world.things, {-90, -90, 60}, {90, -90, 60}, {90, 90, 60}, {-90, 90, 60}, {Surface::concrete, 50});
  const RayCaster roofed(world, {});
  EXPECT_LT(at(photograph(roofed, level_camera(), 1), 80, 110).g,
            at(photograph(bare, level_camera(), 1), 80, 110).g - 30);
}

TEST(Photograph, IsTheSameForAnyNumberOfThreads) {
  const RayCaster caster(world_of(berm_terrain(), 60.0), {});
  Camera camera = level_camera();
  camera.target_m.z() = 0.0;
  EXPECT_EQ(photograph(caster, camera, 1).rgb, photograph(caster, camera, 4).rgb);
}

}  // namespace
}  // namespace berm::sim
