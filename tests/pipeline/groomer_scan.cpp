#include "groomer_scan.hpp"

#include <cmath>
#include <filesystem>
#include <random>
#include <utility>

#include "support/made_scan.hpp"

namespace berm::test {

Machine groomer(const std::string& snow, const std::string& ground, const std::string& piste) {
  Machine machine = read_machine(std::filesystem::path(BERM_MACHINES_FOLDER) / "groomer.yaml");
  machine.methods.snow = snow;
  machine.methods.ground = ground;
  machine.methods.piste = piste;
  return machine;
}

Scan groomer_scan(std::uint32_t seed, std::size_t beams) {
  World world;
  world.terrain_m = [](double x_m, double y_m) { return 0.2 * std::sin(0.15 * x_m) + 0.1 * std::cos(0.2 * y_m); };
  for (int i = 0; i < 6; ++i) {
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    world.things.push_back({.x_m = 12.0 + 6.0 * i,
                            .y_m = side * (9.0 + i),
                            .half_length_m = 0.4,
                            .height_m = 8.0,
                            .clearance_m = 0.0,
                            .round = true});
  }
  const MountConfig mount = groomer().mount;
  const MadeScan made = cast(world, rosette_beams(70.4, static_cast<int>(beams)),
                             standing_at_origin(world, mount.height_m, mount.pitch_deg), {.seed = seed});
  Scan scan{.stamp_ns = seed * 100'000'000LL, .cloud = made.cloud, .T_base_sensor = mount.T_base_sensor()};
  change_channels(scan, [&made](PointChannels& channels) {
    const std::size_t n = channels.x.size();
    channels.intensity.resize(n);
    channels.time.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const bool met = !is_no_return(channels.x[i], channels.y[i], channels.z[i]);
      channels.intensity[i] = !met ? 0.0F : (made.is_terrain[i] ? 150.0F : 40.0F) + static_cast<float>(i % 4);
      channels.time[i] = 0.1F * static_cast<float>(i) / static_cast<float>(n);
    }
  });
  return scan;
}

void change_channels(Scan& scan, const std::function<void(PointChannels&)>& change) {
  PointChannels channels = std::move(scan.cloud).release();
  change(channels);
  scan.cloud = PointCloud(std::move(channels));
}

void let_it_snow(Scan& scan, double share) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0.0F, 1.0F);
  change_channels(scan, [&](PointChannels& channels) {
    for (std::size_t i = 0; i < channels.x.size(); ++i) {
      if (unit(random) >= static_cast<float>(share)) {
        continue;
      }
      const float range_m = 1.0F + 9.0F * unit(random) * unit(random);
      const float across = 0.6F * (unit(random) - 0.5F);
      const float up = 0.6F * (unit(random) - 0.5F);
      channels.x[i] = range_m;
      channels.y[i] = range_m * across;
      channels.z[i] = range_m * up;
      channels.intensity[i] = 3.0F * unit(random);
    }
  });
}

}  // namespace berm::test
