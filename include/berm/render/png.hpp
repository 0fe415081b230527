#pragma once

#include <cstddef>
#include <vector>

#include "berm/render/image.hpp"

namespace berm {

/// The bytes of `image` as a PNG file, without a time stamp: the same picture gives the same bytes.
/// Throws Error(invalid_argument) for an empty image.
[[nodiscard]] std::vector<std::byte> encode_png(const Image& image);

}  // namespace berm
