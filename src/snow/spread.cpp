#include "spread.hpp"

#include <algorithm>

namespace berm {

Spread::Spread(const NearPoints& near) : seen_(near.sectors_seen()) {}

/// Of n marks that fall on s sectors by chance, n_i (n_i - 1) add up to n^2 / s.
double Spread::evenness() const {
  double sum = 0.0;
  double pairs = 0.0;
  for (const std::uint32_t marks : marks_) {
    const double n = marks;
    sum += n;
    pairs += n * (n - 1.0);
  }
  return pairs > 0.0 ? std::min(1.0, sum * sum / (seen_ * pairs)) : 1.0;
}

}  // namespace berm
