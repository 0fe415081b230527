#pragma once

#include <string_view>

namespace berm {

/// Version of this program and library, "1.2.3".
[[nodiscard]] std::string_view version();

}  // namespace berm
