#include "label_colors.hpp"

#include "berm/render/color.hpp"

namespace berm {

LabelColors dark_label_colors() {
  LabelColors colors{};
  for (std::size_t label = 0; label < colors.size(); ++label) {
    const Rgb color = label_color(static_cast<Label>(label), Background::dark);
    colors[label] = {color.r, color.g, color.b};
  }
  return colors;
}

}  // namespace berm
