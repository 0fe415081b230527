#include "view/http_client.hpp"

#include <algorithm>
#include <cctype>
#include <stdexcept>

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace berm::test {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

void parse_head(const std::string& head, HttpReply& reply) {
  reply.status = static_cast<unsigned>(std::stoul(head.substr(head.find(' ') + 1, 3)));
  std::size_t begin = head.find("\r\n") + 2;
  while (begin < head.size()) {
    const std::size_t end = head.find("\r\n", begin);
    const std::size_t colon = head.find(": ", begin);
    reply.headers[lower(head.substr(begin, colon - begin))] = head.substr(colon + 2, end - colon - 2);
    begin = end + 2;
  }
}

}  // namespace

HttpClient::HttpClient(std::uint16_t port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  // A server that does not answer is a failure, not a test that hangs.
  const timeval limit{.tv_sec = 30, .tv_usec = 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof(limit));
  if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
    throw std::runtime_error("cannot connect");
  }
}

HttpClient::~HttpClient() {
  if (socket_ >= 0) {
    ::close(socket_);
  }
}

bool HttpClient::send(std::string_view bytes) const {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) {
      return false;
    }
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  return true;
}

HttpReply HttpClient::read(bool has_body) {
  HttpReply reply;
  char piece[65536];
  const auto more = [&] {
    const ssize_t got = ::recv(socket_, piece, sizeof(piece), 0);
    pending_.append(piece, got > 0 ? static_cast<std::size_t>(got) : 0);
    return got > 0;
  };
  while (pending_.find("\r\n\r\n") == std::string::npos) {
    if (!more()) {
      return reply;
    }
  }
  const std::size_t head_end = pending_.find("\r\n\r\n");
  parse_head(pending_.substr(0, head_end + 2), reply);
  pending_.erase(0, head_end + 4);
  const std::size_t length = has_body ? std::stoul(reply.headers.at("content-length")) : 0;
  while (pending_.size() < length) {
    if (!more()) {
      throw std::runtime_error("the answer was cut");
    }
  }
  reply.body = pending_.substr(0, length);
  pending_.erase(0, length);
  return reply;
}

bool HttpClient::waits_for_end(double timeout_s) const {
  pollfd state{.fd = socket_, .events = POLLIN, .revents = 0};
  char byte = 0;
  return ::poll(&state, 1, static_cast<int>(timeout_s * 1e3)) == 1 && ::recv(socket_, &byte, 1, 0) <= 0;
}

void HttpClient::vanish() {
  const linger reset{.l_onoff = 1, .l_linger = 0};
  ::setsockopt(socket_, SOL_SOCKET, SO_LINGER, &reset, sizeof(reset));
  ::close(socket_);
  socket_ = -1;
}

std::string get_request(std::string_view target, std::string_view headers) {
  std::string request = "GET ";
  request += target;
  request += " HTTP/1.1\r\nHost: localhost\r\n";
  request += headers;
  return request + "\r\n";
}

HttpReply get(std::uint16_t port, std::string_view target, std::string_view headers) {
  HttpClient client(port);
  client.send(get_request(target, headers));
  return client.read();
}

}  // namespace berm::test
