#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace berm {

/// End of a sentence about an unknown name: ", did you mean 'NAME'?" with the one of `names` that is nearest to `text`,
/// "." if none is near.
[[nodiscard]] std::string did_you_mean(std::string_view text, const std::vector<std::string>& names);

/// "a, b or c"
[[nodiscard]] std::string enumerate(const std::vector<std::string>& names);

}  // namespace berm
