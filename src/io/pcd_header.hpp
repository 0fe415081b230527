#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "berm/io/pcd.hpp"

namespace berm {

struct PcdField {
  std::string name;
  char type = 'F';         ///< F, I or U
  std::size_t size = 4;    ///< bytes of one value
  std::size_t count = 1;   ///< values per point
  std::size_t offset = 0;  ///< of the first value in the record of a point, bytes

  [[nodiscard]] std::size_t bytes() const { return size * count; }
  /// "F4"
  [[nodiscard]] std::string type_name() const { return type + std::to_string(size); }
};

/// The header of a PCD file, consistent in itself; what it says of the body is not checked yet.
struct PcdHeader {
  std::vector<PcdField> fields;  ///< at least 1, of types F4 F8 I1..I8 U1..U8
  std::size_t points = 0;        ///< < 2^48
  std::size_t point_bytes = 0;   ///< length of a record
  PcdEncoding encoding = PcdEncoding::ascii;
  std::size_t data_offset = 0;  ///< of the body in the file
  std::size_t lines = 0;        ///< of the header, the DATA line included
  std::vector<std::string> notes;
};

/// Throws FileError(truncated, malformed or unsupported) with the offset of the line.
[[nodiscard]] PcdHeader parse_pcd_header(std::span<const std::byte> bytes, const std::string& name);

}  // namespace berm
