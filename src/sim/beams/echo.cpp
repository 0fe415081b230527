#include "echo.hpp"

#include <algorithm>

namespace berm::sim {
namespace {

/// The label of more than half of the energy comes out ahead, in whatever order the parts come (Boyer and Moore 1981).
void vote(Echo& whole, const Echo& part) {
  if (part.label == whole.label) {
    whole.label_lead += part.label_lead;
  } else if (part.label_lead > whole.label_lead) {
    whole.label = part.label;
    whole.label_lead = part.label_lead - whole.label_lead;
  } else {
    whole.label_lead -= part.label_lead;
  }
}

}  // namespace

std::size_t melt(std::span<Echo> echoes, float separation_m) {
  if (echoes.size() < 2) {
    return echoes.size();
  }
  // By insertion: there are few, and std::stable_sort would allocate. Stable, so that equals stay in their order.
  for (auto next = echoes.begin() + 1; next != echoes.end(); ++next) {
    const auto place = std::upper_bound(echoes.begin(), next, next->range_m,
                                        [](float range_m, const Echo& echo) { return range_m < echo.range_m; });
    std::rotate(place, next, next + 1);
  }
  std::size_t last = 0;
  float end_m = echoes[0].range_m;
  for (std::size_t i = 1; i < echoes.size(); ++i) {
    const Echo part = echoes[i];
    const bool apart = part.range_m - end_m >= separation_m;
    end_m = part.range_m;
    if (apart) {
      echoes[++last] = part;
      continue;
    }
    Echo& whole = echoes[last];
    const float energy = whole.energy + part.energy;
    // Without any energy there is nothing to weight: the first stays.
    const float share = energy > 0.0F ? part.energy / energy : 0.0F;
    whole.range_m += share * (part.range_m - whole.range_m);
    whole.variance_m2 += share * (part.variance_m2 - whole.variance_m2);
    whole.energy = energy;
    whole.light += part.light;
    whole.spot_sigma += part.spot_sigma;
    vote(whole, part);
  }
  return last + 1;
}

EchoChoice echo_choice(std::string_view name) {
  if (name == "first") {
    return EchoChoice::first;
  }
  return name == "last" ? EchoChoice::last : EchoChoice::strongest;
}

}  // namespace berm::sim
