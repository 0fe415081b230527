#pragma once

#include <cstdint>
#include <string_view>

namespace berm {

/// Name of a SemanticKITTI class, with the two that WADS added; "?" for an id that neither defines.
[[nodiscard]] std::string_view class_name(std::uint32_t id);

}  // namespace berm
