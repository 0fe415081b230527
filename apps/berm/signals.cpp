#include "signals.hpp"

#include <csignal>

namespace berm::app {
namespace {

volatile std::sig_atomic_t last_signal = 0;

}  // namespace

void catch_signals() {
  struct sigaction action {};
  action.sa_handler = [](int signal) { last_signal = signal; };
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

int received_signal() {
  return last_signal;
}

}  // namespace berm::app
