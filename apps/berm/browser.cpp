#include "browser.hpp"

#include <cstdlib>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace berm::app {

void open_browser(const std::string& address) {
  // Without a desktop xdg-open would take the terminal for a browser of text.
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) {
    return;
  }
  // The shell in between ends at once, so that nobody has to wait for the browser.
  std::string program = "xdg-open \"$1\" &";
  std::string words[] = {"sh", "-c", program, "sh", address};
  char* arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), words[4].data(), nullptr};
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    ::posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", O_RDWR, 0);
  }
  pid_t process = -1;
  if (::posix_spawnp(&process, "sh", &actions, nullptr, arguments, environ) == 0) {
    ::waitpid(process, nullptr, 0);
  }
  ::posix_spawn_file_actions_destroy(&actions);
}

}  // namespace berm::app
