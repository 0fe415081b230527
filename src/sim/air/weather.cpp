#include "berm/sim/weather.hpp"

#include <algorithm>
#include <utility>

#include "air_lanes.hpp"
#include "dust.hpp"
#include "snow.hpp"

namespace berm::sim {

struct Weather::Air {
  Snow snow;
  Dust dust;
};

Weather::Weather(const SnowfallConfig& snowfall, const OpticsConfig& optics, std::vector<Plume> plumes,
                 std::uint64_t seed) {
  snowfall.check();
  optics.check();
  air_ = std::make_shared<const Air>(Air{Snow(snowfall, optics, seed), Dust(std::move(plumes), optics)});
}

bool Weather::is_clear() const {
  return air_->snow.is_empty() && air_->dust.is_empty();
}

double Weather::expected_flakes(double range_m) const {
  return air_->snow.expected(range_m);
}

void Weather::along(AirLanes& beams) const {
  if (beams.count == 0) {
    return;
  }
  beams.pad();
  std::fill_n(beams.has_echo.begin(), beams.count, false);
  if (air_->snow.is_empty()) {
    std::fill_n(beams.transmission.begin(), beams.count, 1.0F);
  } else {
    air_->snow.pass(beams);
  }
  if (!air_->dust.is_empty()) {
    air_->dust.pass(beams);
  }
}

AirPath Weather::along(const AirBeam& beam, Random& random) const {
  AirLanes beams;
  beams.count = 1;
  beams.height_m = beam.height_m;
  beams.x_m[0] = static_cast<float>(beam.origin_m.x());
  beams.y_m[0] = static_cast<float>(beam.origin_m.y());
  beams.z_m[0] = static_cast<float>(beam.origin_m.z());
  beams.dx[0] = static_cast<float>(beam.direction.x());
  beams.dy[0] = static_cast<float>(beam.direction.y());
  beams.dz[0] = static_cast<float>(beam.direction.z());
  beams.end_m[0] = static_cast<float>(beam.end_m);
  beams.slope[0] = static_cast<float>(beam.slope);
  beams.time_s[0] = beam.time_s;
  beams.random[0] = &random;
  along(beams);
  AirPath path;
  path.transmission = static_cast<double>(beams.transmission[0]);
  path.has_echo = beams.has_echo[0];
  if (path.has_echo) {
    path.echo = beams.echo[0];
  }
  return path;
}

}  // namespace berm::sim
