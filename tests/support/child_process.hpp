#pragma once

#include <exception>
#include <functional>
#include <stdexcept>

#include <sys/wait.h>
#include <unistd.h>

namespace berm::test {

/// Runs `body` in a forked process, so that limits, users and working folders of this one stay as they are. Returns
/// what `body` returns, 97 if it throws, -1 if it is killed.
[[nodiscard]] inline int run_in_child(const std::function<int()>& body) {
  const pid_t child = ::fork();
  if (child < 0) {
    throw std::runtime_error("cannot fork");
  }
  if (child == 0) {
    int result = 97;
    try {
      result = body();
    } catch (const std::exception&) {
    }
    ::_exit(result);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

/// To be called in a child: permission bits do not bind root. False if the user cannot be changed.
[[nodiscard]] inline bool become_ordinary_user() {
  constexpr unsigned kNobody = 65534;
  return ::geteuid() != 0 || (::setgid(kNobody) == 0 && ::setuid(kNobody) == 0);
}

}  // namespace berm::test
