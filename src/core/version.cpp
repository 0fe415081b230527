#include "berm/core/version.hpp"

namespace berm {

std::string_view version() {
  return BERM_VERSION;
}

}  // namespace berm
