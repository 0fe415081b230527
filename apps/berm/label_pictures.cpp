#include "label_pictures.hpp"

#include <algorithm>

namespace berm::app {
namespace {

bool is_ground(std::uint32_t raw) {
  const Label label = to_label(raw);
  return label == Label::drivable || label == Label::terrain;
}

/// Truth that does not speak of ground: nothing known, vegetation, falling snow.
bool is_unknown(std::uint32_t raw) {
  const std::uint32_t id = semantic_class(raw);
  return id == 0 || id == 1 || id == 70 || id == 110;
}

}  // namespace

const std::array<PointClass, 5> kGroundComparison = {{{"not judged", {90, 90, 96}},
                                                      {"ground, found", {0, 158, 115}},
                                                      {"other, found", {86, 180, 233}},
                                                      {"ground, missed", {240, 228, 66}},
                                                      {"taken for ground", {213, 94, 0}}}};

std::vector<Label> to_labels(const RawLabels& raw) {
  std::vector<Label> labels(raw.size());
  std::transform(raw.begin(), raw.end(), labels.begin(), to_label);
  return labels;
}

std::vector<std::uint8_t> compare_ground(const RawLabels& output, const RawLabels& truth) {
  std::vector<std::uint8_t> classes(truth.size());
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (is_unknown(truth[i])) {
      classes[i] = 0;
    } else if (is_ground(truth[i])) {
      classes[i] = is_ground(output[i]) ? 1 : 3;
    } else {
      classes[i] = is_ground(output[i]) ? 4 : 2;
    }
  }
  return classes;
}

}  // namespace berm::app
