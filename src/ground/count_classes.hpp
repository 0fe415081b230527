#pragma once

#include <span>

#include "berm/ground/ground.hpp"

namespace berm {

/// Class of a point that lies in no cell of a grid around the sensor: a no-return, a bad one, or merely too near or
/// too far to be judged.
[[nodiscard]] GroundClass class_of_stray(float x_m, float y_m, float z_m);

[[nodiscard]] GroundCounts count_classes(std::span<const GroundClass> classes);

}  // namespace berm
