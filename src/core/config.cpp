#include "berm/core/config.hpp"

#include <cmath>
#include <sstream>

#include "berm/core/error.hpp"

namespace berm {

void check_value(std::string_view section, std::string_view key, double value, const Range& range) {
  if (std::isfinite(value) && value >= range.min && value <= range.max) {
    return;
  }
  std::ostringstream problem;
  problem << value << " is not allowed, expected " << range.min << " to " << range.max;
  throw ConfigError(std::string(section) + "." + std::string(key), problem.str());
}

}  // namespace berm
