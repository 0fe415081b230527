#pragma once

#include <cstdint>
#include <string_view>

namespace berm {

/// CRC-32 of zlib, PNG and MCAP (polynomial 0xEDB88320, reflected). `crc` is that of what comes before.
[[nodiscard]] std::uint32_t crc32(std::string_view bytes, std::uint32_t crc = 0);

}  // namespace berm
