#pragma once

#include <string>
#include <string_view>

namespace berm {

/// Throws FileError as `parse_ascii_grid` if the header is broken or announces more than is read. `head` is the start
/// of the file with the whole header in it, so that a file that is too large is refused before it is read.
void check_ascii_grid_header(std::string_view head, const std::string& name);

}  // namespace berm
