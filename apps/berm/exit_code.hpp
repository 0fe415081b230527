#pragma once

#include <stdexcept>

namespace berm::app {

/// What a script can tell from the end of the program. A run that a signal ended gives 128 + its number, as shells do.
enum ExitCode : int {
  kWhole = 0,
  kFailed = 1,
  kWrongUsage = 2,
  kWithLosses = 3,
  kSignalBase = 128,
};

/// The command line asks for something that does not exist; ends the program with `kWrongUsage`.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace berm::app
