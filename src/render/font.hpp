#pragma once

#include <string_view>

namespace berm::font {

/// Nodes of a letter lie on a raster of this many columns and rows; the last two rows are below the base line.
constexpr int kColumns = 5;
constexpr int kRows = 9;
/// Rows of a capital letter.
constexpr int kCapitalRows = 7;
/// From one letter to the next, in columns.
constexpr int kAdvance = 6;

/// Rows from the top, each of kColumns characters, '#' where a stroke passes; separated by '/', empty rows at the end
/// are left out. Characters outside of printable ASCII give the glyph of '?'.
[[nodiscard]] std::string_view glyph(char character);

/// Whether a stroke passes through a node of `rows`; false outside of the raster.
[[nodiscard]] bool has_node(std::string_view rows, int column, int row);

}  // namespace berm::font
