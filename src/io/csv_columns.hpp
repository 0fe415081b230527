#pragma once

#include <string_view>

namespace berm {

/// Takes what stands before the next comma off `line`, without the blanks around it. The last column is the rest.
[[nodiscard]] std::string_view take_column(std::string_view& line);

}  // namespace berm
