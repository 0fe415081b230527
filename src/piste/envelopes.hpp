#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "berm/piste/piste.hpp"

namespace berm {

/// Per petal that has a step, all from its first to its last (P section 2.3). `begins` holds the first point of every
/// petal, `steps` a flag per point.
void find_envelopes(std::span<const std::size_t> begins, std::span<const std::uint8_t> steps,
                    std::vector<Envelope>& envelopes);

}  // namespace berm
