#include "ticks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace berm {

double nice_step(double span, int at_most) {
  if (!(span > 0.0) || !std::isfinite(span)) {
    return 1.0;
  }
  const double smallest = span / std::max(at_most, 1);
  const double power = std::pow(10.0, std::floor(std::log10(smallest)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= smallest) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

std::vector<double> multiples(double low, double high, double step) {
  constexpr int kMost = 1000;
  std::vector<double> values;
  // Counted, not added up, so that no error accumulates.
  const double first = std::ceil(low / step - 1e-9);
  for (int i = 0; i < kMost; ++i) {
    const double value = (first + i) * step;
    if (!(value <= high + 1e-9 * step)) {
      break;
    }
    values.push_back(value);
  }
  return values;
}

std::string number_text(double value, double step) {
  const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 9);
  const double rounded = std::abs(value) < 0.5 * std::pow(10.0, -decimals) ? 0.0 : value;
  char text[64];
  std::snprintf(text, sizeof(text), "%.*f", decimals, rounded);
  return text;
}

std::string count_text(std::size_t count) {
  std::string text = std::to_string(count);
  for (std::size_t place = text.size(); place > 3;) {
    place -= 3;
    text.insert(place, 1, ',');
  }
  return text;
}

}  // namespace berm
