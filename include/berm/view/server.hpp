#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "berm/view/view_api.hpp"

namespace berm {

struct ServerOptions {
  std::string host = "127.0.0.1";  ///< an address in numbers, or "localhost"
  std::uint16_t port = 0;          ///< 0: a free one
  std::size_t max_connections = 64;
  double request_timeout_s = 10.0;  ///< for a header to arrive whole
  double answer_timeout_s = 60.0;   ///< for an answer to leave whole
};

/// An HTTP server for a ViewApi. It has a fixed number of threads, whatever its clients do.
class ViewServer {
 public:
  /// Binds and listens. Throws Error(invalid_argument) for a host that is no address, FileError(unreadable) for an
  /// address or port that cannot be had.
  ViewServer(ViewApi& api, const ServerOptions& options);
  /// Ends what `run` left.
  ~ViewServer();
  ViewServer(const ViewServer&) = delete;
  ViewServer& operator=(const ViewServer&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  /// "http://127.0.0.1:8080/"
  [[nodiscard]] std::string address() const;
  [[nodiscard]] std::size_t open_connections() const;

  /// Serves until `stop` is called, or SIGINT or SIGTERM arrives if these are to be caught.
  void run(bool until_signal);
  /// May be called from any thread, before `run` too.
  void stop();

 private:
  class State;
  std::unique_ptr<State> state_;
};

/// Whether nobody but this machine reaches a server that is bound to `host`.
[[nodiscard]] bool is_loopback(const std::string& host);

}  // namespace berm
