#include "berm/view/access.hpp"

#include <algorithm>

#include <arpa/inet.h>

namespace berm {
namespace {

bool is_port(std::string_view text) {
  return !text.empty() && text.size() <= 5 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The host of `HOST[:PORT]`, without brackets; empty if it is no such text.
std::string_view host_of(std::string_view text) {
  const bool bracketed = !text.empty() && text.front() == '[';
  const std::size_t end = bracketed ? text.find(']') : std::min(text.find(':'), text.size());
  if (end == std::string_view::npos) {
    return {};
  }
  const std::string_view host = bracketed ? text.substr(1, end - 1) : text.substr(0, end);
  const std::string_view rest = text.substr(bracketed ? end + 1 : end);
  const bool rest_is_port = rest.empty() || (rest.front() == ':' && is_port(rest.substr(1)));
  return rest_is_port ? host : std::string_view();
}

bool equal_ignoring_case(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

bool is_address(std::string_view host) {
  const std::string text(host);
  in6_addr address{};
  return ::inet_pton(AF_INET, text.c_str(), &address) == 1 || ::inet_pton(AF_INET6, text.c_str(), &address) == 1;
}

bool is_own_host(std::string_view host, const ViewAccess& access) {
  const std::string_view own[] = {"localhost", "127.0.0.1", "::1", access.host};
  const bool named = std::any_of(std::begin(own), std::end(own),
                                 [&](std::string_view name) { return equal_ignoring_case(host, name); });
  return !host.empty() && (named || (!access.loopback && is_address(host)));
}

}  // namespace

std::optional<std::string> find_view_refusal(const ViewCaller& caller, const ViewAccess& access, bool is_api) {
  if (!is_own_host(host_of(caller.host), access)) {
    return "the request is for another host";
  }
  if (!caller.origin.empty() && !equal_ignoring_case(caller.origin, "http://" + std::string(caller.host))) {
    return "the request comes from another origin";
  }
  if (is_api && equal_ignoring_case(caller.fetch_site, "cross-site")) {
    return "the request comes from another site";
  }
  return std::nullopt;
}

}  // namespace berm
