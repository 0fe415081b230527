#pragma once

#include <cstddef>
#include <cstdint>

namespace berm::sim {

/// What a beam can meet, as far as its light is concerned.
enum class Surface : std::uint8_t {
  groomed_snow,
  rough_snow,
  asphalt,
  gravel,
  rock,
  water,    ///< mirrors the beam away
  foliage,  ///< crowns: a volume that a beam enters and mostly does not leave
  bark,
  net,  ///< fences that let most beams through
  metal,
  paint,  ///< bodies of vehicles
  cloth,  ///< billboards
  concrete,
};
constexpr std::size_t kSurfaces = 13;

/// SemanticKITTI ids of the truth.
namespace truth {
constexpr std::uint16_t kNone = 0;
constexpr std::uint16_t kVehicle = 20;
constexpr std::uint16_t kDrivable = 40;
constexpr std::uint16_t kBuilding = 50;
constexpr std::uint16_t kFence = 51;
constexpr std::uint16_t kVegetation = 70;
constexpr std::uint16_t kTerrain = 72;
constexpr std::uint16_t kPole = 80;
constexpr std::uint16_t kFallingSnow = 110;
constexpr std::uint16_t kDust = 1;             ///< outlier, as SemanticKITTI calls it
constexpr std::uint16_t kMovingVehicle = 259;  ///< moving other vehicle
}  // namespace truth

/// How a surface throws light back.
struct SurfaceOptics {
  double reflectivity;        ///< percent; above 100 for what throws light back to where it came from
  double reflectivity_sigma;  ///< from spot to spot
  double relief_m;            ///< standard deviation of what is too small for the mesh, along the normal
  double mirror;              ///< share of beams that are mirrored away at normal incidence
};
[[nodiscard]] const SurfaceOptics& optics_of(Surface surface);

/// What a triangle is made of, and what the truth calls it.
struct Material {
  Surface surface = Surface::rough_snow;
  std::uint16_t truth_id = truth::kTerrain;
};

}  // namespace berm::sim
