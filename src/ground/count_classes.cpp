#include "count_classes.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace berm {
namespace {

/// No sensor sees 10 km; coordinates beyond are noise of a broken file.
constexpr float kAbsurd_m = 1e4F;

}  // namespace

GroundClass class_of_stray(float x_m, float y_m, float z_m) {
  if (is_no_return(x_m, y_m, z_m)) {
    return GroundClass::no_return;
  }
  const bool sane = std::fabs(x_m) < kAbsurd_m && std::fabs(y_m) < kAbsurd_m && std::fabs(z_m) < kAbsurd_m;
  return sane ? GroundClass::not_ground : GroundClass::invalid;
}

GroundCounts count_classes(std::span<const GroundClass> classes) {
  const auto count = [classes](GroundClass wanted) {
    return static_cast<std::size_t>(std::count(classes.begin(), classes.end(), wanted));
  };
  return {.ground = count(GroundClass::ground),
          .not_ground = count(GroundClass::not_ground),
          .no_return = count(GroundClass::no_return),
          .invalid = count(GroundClass::invalid)};
}

}  // namespace berm
