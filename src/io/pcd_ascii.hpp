#pragma once

#include <span>
#include <string>

#include "pcd_decoder.hpp"

namespace berm {

/// Reads the body of an ascii PCD file into `decoder`, one line per point. Throws FileError(malformed or truncated)
/// with the line. Odd things that do not stop the reading are added to `notes`.
void read_pcd_ascii(std::span<const std::byte> body, const PcdHeader& header, const PcdPlan& plan,
                    const std::string& name, PcdDecoder& decoder, std::vector<std::string>& notes);

}  // namespace berm
