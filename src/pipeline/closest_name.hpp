#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace berm {

/// "; did you mean 'NAME'?" for the name that is nearest to `text`, empty if none is near.
[[nodiscard]] std::string did_you_mean(std::string_view text, const std::vector<std::string>& names);

/// "a, b or c"
[[nodiscard]] std::string enumerate(const std::vector<std::string>& names);

}  // namespace berm
