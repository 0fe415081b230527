#pragma once

#include <string>

namespace berm::app {

/// Opens `address` in the user's browser; does nothing where there is no desktop or no xdg-open.
void open_browser(const std::string& address);

}  // namespace berm::app
