#pragma once

#include <string_view>

#include <Eigen/Core>

#include "berm/core/edge.hpp"
#include "line_reader.hpp"

namespace berm {

/// Checks the first line of a table of edges.
void check_edge_header(const LineReader& lines, std::string_view line, std::string_view header);

/// Takes the side off `rest`, which is column `column` of a table with this header.
[[nodiscard]] EdgeSide take_side(const LineReader& lines, std::string_view& rest, int column, std::string_view header);

/// Takes three coordinates off `rest`; whether they are the end of `line` has to be `is_end`.
[[nodiscard]] Eigen::Vector3d take_position_m(const LineReader& lines, std::string_view line, std::string_view& rest,
                                              bool is_end);

/// Appends ",x,y,z" with three decimals.
void append_position(std::string& text, const Eigen::Vector3d& position_m);

}  // namespace berm
