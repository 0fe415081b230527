#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace berm::test {

/// What a server sent back. Names of headers are in lower case.
struct HttpReply {
  unsigned status = 0;  ///< 0: the connection ended without an answer
  std::map<std::string, std::string> headers;
  std::string body;
};

/// A client that sends whatever bytes it is told to, by means other than the server's.
class HttpClient {
 public:
  /// Connects to 127.0.0.1.
  explicit HttpClient(std::uint16_t port);
  ~HttpClient();
  HttpClient(const HttpClient&) = delete;
  HttpClient& operator=(const HttpClient&) = delete;

  /// Sends bytes; false if the server has hung up.
  bool send(std::string_view bytes) const;
  /// Reads one answer; `has_body` is false for that to a HEAD.
  [[nodiscard]] HttpReply read(bool has_body = true);
  /// Waits until the server hangs up, at most `timeout_s`.
  [[nodiscard]] bool waits_for_end(double timeout_s) const;
  /// Ends the connection without a word, whatever is on its way.
  void vanish();

 private:
  int socket_ = -1;
  std::string pending_;
};

/// "GET TARGET" with a Host that the server takes, and more headers.
[[nodiscard]] std::string get_request(std::string_view target, std::string_view headers = {});

/// One request on a connection of its own.
[[nodiscard]] HttpReply get(std::uint16_t port, std::string_view target, std::string_view headers = {});

}  // namespace berm::test
