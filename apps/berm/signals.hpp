#pragma once

namespace berm::app {

/// From here on the first SIGINT or SIGTERM asks for a clean end, see `received_signal`; a second one ends the program
/// as it always would.
void catch_signals();

/// Number of the signal that came in since, 0 for none.
[[nodiscard]] int received_signal();

}  // namespace berm::app
