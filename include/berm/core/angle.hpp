#pragma once

#include <numbers>

namespace berm {

/// Angles are in radians everywhere inside; degrees are for people and files and turned where they come in or go out.
inline constexpr double kRadPerDeg = std::numbers::pi / 180.0;
inline constexpr double kDegPerRad = 180.0 / std::numbers::pi;

}  // namespace berm
