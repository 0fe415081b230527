#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "record_bytes.hpp"

namespace berm {

/// Protobuf's wire format, the few kinds of fields that Foxglove's schemas have.
class ProtoWriter {
 public:
  void add_integer(int field, std::uint64_t value) {
    add_tag(field, 0);
    add_varint(value);
  }
  void add_real(int field, double value) {
    add_tag(field, 1);
    append_number(bytes_, value);
  }
  void add_bytes(int field, std::string_view value) {
    add_tag(field, 2);
    add_varint(value.size());
    bytes_.append(value);
  }
  void add_message(int field, const ProtoWriter& message) { add_bytes(field, message.bytes_); }
  void add_fixed32(int field, std::uint32_t value) {
    add_tag(field, 5);
    append_number(bytes_, value);
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  void add_tag(int field, unsigned kind) { add_varint((static_cast<std::uint64_t>(field) << 3U) | kind); }
  void add_varint(std::uint64_t value) {
    while (value >= 0x80) {
      bytes_ += static_cast<char>(value | 0x80U);
      value >>= 7U;
    }
    bytes_ += static_cast<char>(value);
  }

  std::string bytes_;
};

}  // namespace berm
