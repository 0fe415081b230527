#include "envelopes.hpp"

#include <algorithm>

namespace berm {

void find_envelopes(std::span<const std::size_t> begins, std::span<const std::uint8_t> steps,
                    std::vector<Envelope>& envelopes) {
  envelopes.clear();
  for (std::size_t petal = 0; petal < begins.size(); ++petal) {
    const std::size_t begin = begins[petal];
    const std::size_t end = petal + 1 < begins.size() ? begins[petal + 1] : steps.size();
    const std::span<const std::uint8_t> own = steps.subspan(begin, end - begin);
    const auto first = std::find(own.begin(), own.end(), 1);
    if (first == own.end()) {
      continue;
    }
    const auto after_last = std::find(own.rbegin(), own.rend(), 1).base();
    envelopes.push_back({.first = begin + static_cast<std::size_t>(first - own.begin()),
                         .last = begin + static_cast<std::size_t>(after_last - own.begin()) - 1});
  }
}

}  // namespace berm
