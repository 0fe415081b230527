#pragma once

#include <cstdint>

#include "berm/core/label.hpp"

namespace berm {

/// A colour as it is stored in a picture: sRGB, 8 bits a channel.
struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

enum class Background : std::uint8_t { dark, light };

/// Colour of `label` on `background`. The six stay apart for people with any of the common colour vision
/// deficiencies (tested).
[[nodiscard]] Rgb label_color(Label label, Background background);

/// Name of `label` as a legend shows it, e.g. "falling snow".
[[nodiscard]] const char* label_name(Label label);

/// Colour of `share` (0..1, clamped; NaN counts as 0) on a scale whose brightness grows evenly.
[[nodiscard]] Rgb scale_color(double share, Background background);

/// `share` (0..1) of `over` on top of `under`.
[[nodiscard]] Rgb mix(Rgb under, Rgb over, double share);

}  // namespace berm
