#include "berm/render/color.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace berm {
namespace {

/// Points of matplotlib's viridis (CC0), equally spaced. The darkest eighth is left out on a dark background.
constexpr std::array<Rgb, 9> kScale = {Rgb{68, 1, 84},    Rgb{71, 44, 122},  Rgb{59, 81, 139},
                                       Rgb{44, 113, 142}, Rgb{33, 144, 141}, Rgb{39, 173, 129},
                                       Rgb{92, 200, 99},  Rgb{170, 220, 50}, Rgb{253, 231, 37}};

std::uint8_t mix_channel(std::uint8_t under, std::uint8_t over, double share) {
  return static_cast<std::uint8_t>(under + (over - under) * share + 0.5);
}

}  // namespace

Rgb label_color(Label label, Background background) {
  // The hues of Okabe and Ito, moved until the closest two of the six are as far apart as they can be for people
  // who lack one kind of cones. A grey for what has no label would look like the green to some.
  const bool dark = background == Background::dark;
  switch (label) {
    case Label::drivable:
      return dark ? Rgb{48, 180, 138} : Rgb{12, 108, 90};
    case Label::terrain:
      return dark ? Rgb{230, 190, 66} : Rgb{220, 164, 8};
    case Label::obstacle:
      return dark ? Rgb{216, 60, 36} : Rgb{190, 62, 8};
    case Label::falling_snow:
      return dark ? Rgb{176, 222, 250} : Rgb{70, 172, 250};
    case Label::no_return:
      return dark ? Rgb{82, 84, 88} : Rgb{172, 174, 178};
    case Label::unlabeled:
      break;
  }
  return dark ? Rgb{156, 116, 178} : Rgb{110, 84, 146};
}

const char* label_name(Label label) {
  switch (label) {
    case Label::drivable:
      return "drivable";
    case Label::terrain:
      return "terrain";
    case Label::obstacle:
      return "obstacle";
    case Label::falling_snow:
      return "falling snow";
    case Label::no_return:
      return "no return";
    case Label::unlabeled:
      break;
  }
  return "unlabeled";
}

Rgb scale_color(double share, Background background) {
  constexpr double kLast = kScale.size() - 1;
  const double inside = share > 0.0 ? std::min(share, 1.0) : 0.0;
  const double first = background == Background::dark ? 1.0 : 0.0;
  const double place = first + inside * (kLast - first);
  const auto below = std::min(static_cast<std::size_t>(place), kScale.size() - 2);
  return mix(kScale[below], kScale[below + 1], place - static_cast<double>(below));
}

Rgb mix(Rgb under, Rgb over, double share) {
  const double inside = share > 0.0 ? std::min(share, 1.0) : 0.0;
  return {mix_channel(under.r, over.r, inside), mix_channel(under.g, over.g, inside),
          mix_channel(under.b, over.b, inside)};
}

}  // namespace berm
