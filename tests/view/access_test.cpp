#include "berm/view/access.hpp"

#include <gtest/gtest.h>

namespace berm {
namespace {

const ViewAccess kHome;
const ViewAccess kOpen{.host = "0.0.0.0", .loopback = false};

bool is_refused(const ViewCaller& caller, const ViewAccess& access = kHome, bool is_api = true) {
  return find_view_refusal(caller, access, is_api).has_value();
}

TEST(ViewAccess, TakesItsOwnNamesAtAnyPort) {
  for (const char* host : {"localhost", "LocalHost:8080", "127.0.0.1", "127.0.0.1:8080", "[::1]", "[::1]:9"}) {
    EXPECT_FALSE(is_refused({.host = host})) << host;
  }
}

TEST(ViewAccess, RefusesNamesThatWereMadeToPointHere) {
  for (const char* host : {"", "evil.example", "evil.example:8080", "localhost.evil.example", "127.0.0.1.evil.example",
                           "192.168.1.7", "[::2]", "[::1", "::1", "localhost:80x", "localhost:", "localhost:123456",
                           "localhost@evil.example", "127.0.0.2"}) {
    EXPECT_TRUE(is_refused({.host = host})) << host;
  }
}

TEST(ViewAccess, TakesAnyAddressBeyondTheLoopbackButNoName) {
  EXPECT_FALSE(is_refused({.host = "192.168.1.7:8080"}, kOpen));
  EXPECT_FALSE(is_refused({.host = "[fe80::1]:8080"}, kOpen));
  EXPECT_FALSE(is_refused({.host = "localhost:8080"}, kOpen));
  EXPECT_TRUE(is_refused({.host = "evil.example:8080"}, kOpen));
  EXPECT_TRUE(is_refused({.host = "1.2.3.4.evil.example"}, kOpen));
  EXPECT_FALSE(is_refused({.host = "10.0.0.5"}, {.host = "10.0.0.5", .loopback = false}));
}

TEST(ViewAccess, RefusesOtherOrigins) {
  EXPECT_FALSE(is_refused({.host = "localhost:8080", .origin = "http://localhost:8080"}));
  for (const char* origin : {"http://localhost:3000", "https://localhost:8080", "http://evil.example", "null",
                             "http://localhost:8080.evil.example", "http://localhost"}) {
    EXPECT_TRUE(is_refused({.host = "localhost:8080", .origin = origin})) << origin;
    EXPECT_TRUE(is_refused({.host = "localhost:8080", .origin = origin}, kHome, false)) << origin;
  }
}

TEST(ViewAccess, ALinkMayLeadToThePageButNoOtherSiteLoadsData) {
  const ViewCaller caller{.host = "localhost:8080", .origin = {}, .fetch_site = "cross-site"};
  EXPECT_TRUE(is_refused(caller, kHome, true));
  EXPECT_FALSE(is_refused(caller, kHome, false));
  EXPECT_FALSE(is_refused({.host = "localhost:8080", .origin = {}, .fetch_site = "same-origin"}));
}

}  // namespace
}  // namespace berm
