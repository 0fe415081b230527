#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "berm/core/label.hpp"

namespace berm {

/// The points that have `label`, in the order of the scan. Reuses the memory of `index`.
inline void list_points(std::span<const Label> labels, Label label, std::vector<std::uint32_t>& index) {
  index.resize(labels.size());
  std::size_t count = 0;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    // Written in any case and kept if it has the label: cheaper than a branch that nobody can foresee.
    index[count] = static_cast<std::uint32_t>(i);
    count += labels[i] == label ? 1U : 0U;
  }
  index.resize(count);
}

}  // namespace berm
