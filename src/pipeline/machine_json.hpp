#pragma once

#include <nlohmann/json_fwd.hpp>

#include "berm/pipeline/machine.hpp"

namespace berm {

/// Every key of every section, in the order of the file.
[[nodiscard]] nlohmann::ordered_json to_json(const Machine& machine);

}  // namespace berm
