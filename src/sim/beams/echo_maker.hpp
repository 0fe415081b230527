#pragma once

#include <cstdint>
#include <span>

#include "beam_footprint.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/weather.hpp"
#include "echo.hpp"

namespace berm::sim {

/// What a beam gives: nothing if the range is 0.
struct Return {
  float range_m = 0.0F;
  float reflectivity = 0.0F;
  std::uint32_t label = 0;
};

/// Turns what the rays of a beam met into what the sensor reports.
class EchoMaker {
 public:
  EchoMaker(const RayCaster& caster, const Weather& weather, const OpticsConfig& optics)
      : caster_(caster),
        weather_(weather),
        optics_(optics),
        choice_(echo_choice(optics.echo)),
        weathers_(!weather.is_clear()),
        detection_limit_(static_cast<float>(optics.detection_limit())) {}

  /// `rays` are settled and share the energy of the beam equally; `height_m` is that of the sensor above the ground.
  /// `memory` has room for one echo of every ray and one of the air.
  [[nodiscard]] Return echo_of(std::span<const TracedRay> rays, double height_m, Random& random,
                               std::span<Echo> memory) const;

 private:
  struct Echoes {
    std::span<Echo> parts;
    std::size_t count = 0;
    float nearest_m = 0.0F;  ///< where the first of the rays ends
    bool on_ground = false;  ///< whether that is the terrain
  };

  void add_surface(const TracedRay& ray, float share, Random& random, Echoes& echoes) const;
  void add_air(AirBeam& beam, double height_m, Random& random, Echoes& echoes) const;
  /// The echo that the sensor takes, nullptr if it detects none.
  [[nodiscard]] const Echo* choose(std::span<const Echo> echoes, Random& random) const;
  [[nodiscard]] Return report(const Echo& echo, Random& random) const;

  const RayCaster& caster_;
  const Weather& weather_;
  const OpticsConfig& optics_;
  EchoChoice choice_;
  bool weathers_;
  float detection_limit_;
};

}  // namespace berm::sim
