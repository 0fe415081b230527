#include "beam_optics.hpp"

namespace berm::sim {

float roughness_of(Surface surface) {
  switch (surface) {
    case Surface::groomed_snow:
    case Surface::rough_snow:
    case Surface::foliage:
    case Surface::net:
      return 0.9F;
    case Surface::gravel:
    case Surface::rock:
    case Surface::bark:
      return 0.6F;
    case Surface::asphalt:
    case Surface::concrete:
      return 0.3F;
    case Surface::water:
    case Surface::metal:
    case Surface::paint:
    case Surface::cloth:
      break;
  }
  return 0.0F;
}

}  // namespace berm::sim
