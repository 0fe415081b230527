#pragma once

#include "berm/io/cloud_writer.hpp"

namespace berm {

/// The colours of berm draw on a dark background.
[[nodiscard]] LabelColors dark_label_colors();

}  // namespace berm
