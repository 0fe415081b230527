#include "berm/view/server.hpp"

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "view/http_client.hpp"
#include "view/made_run.hpp"

namespace berm {
namespace {

using test::get;
using test::get_request;
using test::HttpClient;
using test::HttpReply;

/// A server for a made run and its recording, and a scan of 4.5 MB, which no socket's buffer holds.
class ViewServerTest : public testing::Test {
 protected:
  static constexpr std::size_t kBigPoints = 330'000;

  void SetUp() override {
    test::make_run(folder_.path());
    test::make_recording(folder_ / "big", 1, kBigPoints);
    std::filesystem::create_directories(folder_ / "web");
    test::spill(folder_ / "web/index.html", "<html>front end</html>");
  }

  void TearDown() override { stop(); }

  void start(ServerOptions options = {}) {
    std::vector<ShownRun> runs;
    for (const char* name : {"out", "recording", "big"}) {
      runs.push_back(ShownRun::open(folder_ / name));
    }
    api_ = std::make_unique<ViewApi>(std::move(runs), Site::load(folder_ / "web"), ViewOptions());
    server_ = std::make_unique<ViewServer>(*api_, options);
    thread_ = std::thread([this] { server_->run(false); });
  }

  void stop() {
    if (thread_.joinable()) {
      server_->stop();
      thread_.join();
    }
  }

  [[nodiscard]] std::uint16_t port() const { return server_->port(); }

  /// Whether there come to be `count` connections within some seconds.
  [[nodiscard]] bool comes_to(std::size_t count) const {
    for (int i = 0; i < 1000; ++i) {
      if (server_->open_connections() == count) {
        return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  test::TempFolder folder_;
  std::unique_ptr<ViewApi> api_;
  std::unique_ptr<ViewServer> server_;
  std::thread thread_;
};

TEST_F(ViewServerTest, ServesPageAndDataOfTwoRunsWithItsHeaders) {
  start();
  const HttpReply page = get(port(), "/");
  EXPECT_EQ(page.status, 200U);
  EXPECT_EQ(page.body, "<html>front end</html>");
  EXPECT_EQ(page.headers.at("content-type"), "text/html; charset=utf-8");
  EXPECT_EQ(page.headers.at("x-content-type-options"), "nosniff");
  EXPECT_EQ(page.headers.at("content-security-policy").find("default-src 'self'"), 0U);
  EXPECT_EQ(page.headers.count("access-control-allow-origin"), 0U);
  for (const char* target : {"/api/runs/0/scans/0", "/api/runs/1/scans/0"}) {
    const HttpReply scan = get(port(), target);
    EXPECT_EQ(scan.status, 200U);
    EXPECT_EQ(scan.headers.at("content-type"), "application/octet-stream");
    EXPECT_EQ(scan.headers.at("cache-control"), "no-store");
    EXPECT_EQ(scan.body.size(), 16 + 16 * test::kMadeReturns);
  }
}

TEST_F(ViewServerTest, AnswersOneRequestAfterTheOtherOnOneConnection) {
  start();
  HttpClient client(port());
  client.send(get_request("/api/runs") + "HEAD / HTTP/1.1\r\nHost: localhost\r\n\r\n" + get_request("/nothing"));
  EXPECT_EQ(client.read().status, 200U);
  const HttpReply head = client.read(false);
  EXPECT_EQ(head.status, 200U);
  EXPECT_EQ(head.headers.at("content-length"), "22");
  EXPECT_EQ(client.read().status, 404U);
}

TEST_F(ViewServerTest, NoPathLeadsOut) {
  test::spill(folder_ / "secret", "secret");
  start();
  for (const char* target :
       {"/../secret", "/..%2fsecret", "/%2e%2e/secret", "//secret", "/web/../../secret", "/./secret", "/..\\secret",
        "/etc/passwd", "/%00", "/api/runs/0/../../secret", "/api/runs/0/scans/../0", "/api/runs/0/scans/%30",
        "http://localhost/secret", "*", "/run.json", "/out/run.json"}) {
    const HttpReply reply = get(port(), target);
    EXPECT_TRUE(reply.status == 400 || reply.status == 404) << target << ' ' << reply.status;
    EXPECT_EQ(reply.body.find("secret\""), std::string::npos);
  }
}

TEST_F(ViewServerTest, RefusesOtherHostsAndOrigins) {
  start();
  const auto status = [this](const std::string& head) {
    HttpClient client(port());
    client.send(head);
    return client.read().status;
  };
  EXPECT_EQ(status("GET /api/runs HTTP/1.1\r\nHost: evil.example\r\n\r\n"), 403U);
  EXPECT_EQ(status("GET /api/runs HTTP/1.1\r\n\r\n"), 403U);
  EXPECT_EQ(status("GET /api/runs HTTP/1.0\r\n\r\n"), 403U);
  EXPECT_EQ(status("GET /api/runs HTTP/1.1\r\nHost: localhost\r\nHost: evil.example\r\n\r\n"), 403U);
  EXPECT_EQ(get(port(), "/api/runs", "Origin: http://evil.example\r\n").status, 403U);
  EXPECT_EQ(get(port(), "/api/runs", "Origin: http://localhost:1\r\n").status, 403U);
  EXPECT_EQ(get(port(), "/api/runs", "Origin: null\r\n").status, 403U);
  EXPECT_EQ(get(port(), "/api/runs", "Sec-Fetch-Site: cross-site\r\n").status, 403U);
  EXPECT_EQ(get(port(), "/api/runs", "Origin: http://localhost\r\n").status, 200U);
}

TEST_F(ViewServerTest, BoundsWhatIsSent) {
  start();
  HttpClient large(port());
  large.send("GET / HTTP/1.1\r\nHost: localhost\r\nX: " + std::string(20'000, 'x') + "\r\n\r\n");
  EXPECT_EQ(large.read().status, 431U);
  HttpClient body(port());
  body.send("GET / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 5\r\n\r\nhello");
  EXPECT_EQ(body.read().status, 400U);
  HttpClient post(port());
  post.send("POST /api/runs HTTP/1.1\r\nHost: localhost\r\nContent-Length: 0\r\n\r\n");
  EXPECT_EQ(post.read().status, 405U);
  HttpClient noise(port());
  noise.send(std::string("\x16\x03\x01\0\0", 5) + "hello, is this TLS?\r\n\r\n");
  EXPECT_EQ(noise.read().status, 400U);
  EXPECT_EQ(get(port(), "/" + std::string(4000, 'a')).status, 400U);
}

TEST_F(ViewServerTest, HangsUpOnASlowClient) {
  start({.request_timeout_s = 0.3});
  HttpClient client(port());
  client.send("GET / HTTP/1.1\r\nHo");
  EXPECT_TRUE(comes_to(1));
  EXPECT_TRUE(client.waits_for_end(10.0));
  EXPECT_TRUE(comes_to(0));
}

TEST_F(ViewServerTest, AClientThatReadsNothingIsLetGo) {
  start({.answer_timeout_s = 0.5});
  HttpClient client(port());
  client.send(get_request("/api/runs/2/scans/0"));
  EXPECT_TRUE(comes_to(1));
  EXPECT_TRUE(comes_to(0));
  EXPECT_EQ(get(port(), "/").status, 200U);
}

TEST_F(ViewServerTest, AClientThatVanishesLeavesNothingBehind) {
  start();
  for (int i = 0; i < 20; ++i) {
    HttpClient client(port());
    client.send(get_request("/api/runs/2/scans/0"));
    client.vanish();
  }
  EXPECT_TRUE(comes_to(0));
  EXPECT_EQ(get(port(), "/api/runs/2/scans/0").body.size(), 16 + 16 * (kBigPoints - kBigPoints / 7));
}

TEST_F(ViewServerTest, TakesNoMoreConnectionsThanItShould) {
  start({.max_connections = 3});
  std::vector<std::unique_ptr<HttpClient>> clients;
  for (int i = 0; i < 3; ++i) {
    clients.push_back(std::make_unique<HttpClient>(port()));
    ASSERT_TRUE(comes_to(static_cast<std::size_t>(i) + 1));
  }
  const HttpClient more(port());
  EXPECT_TRUE(more.waits_for_end(10.0));
  EXPECT_EQ(server_->open_connections(), 3U);
  clients.clear();
  ASSERT_TRUE(comes_to(0));
  EXPECT_EQ(get(port(), "/").status, 200U);
}

TEST_F(ViewServerTest, ServesManyAtOnceTheSame) {
  start();
  const std::string expected = get(port(), "/api/runs/0/scans/1").body;
  std::vector<std::thread> threads;
  for (int i = 0; i < 8; ++i) {
    threads.emplace_back([&] {
      for (int k = 0; k < 20; ++k) {
        EXPECT_EQ(get(port(), "/api/runs/0/scans/1").body, expected);
      }
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
}

TEST_F(ViewServerTest, StopsInTheMiddleOfAnAnswer) {
  start();
  HttpClient client(port());
  client.send(get_request("/api/runs/2/scans/0"));
  EXPECT_TRUE(comes_to(1));
  stop();
}

TEST_F(ViewServerTest, SaysWhyItCannotListen) {
  start();
  EXPECT_THROW(ViewServer(*api_, {.host = "nowhere"}), Error);
  EXPECT_THROW(ViewServer(*api_, {.host = "203.0.113.1"}), FileError);
  EXPECT_THROW(ViewServer(*api_, {.port = port()}), FileError);
  EXPECT_EQ(server_->address(), "http://127.0.0.1:" + std::to_string(port()) + "/");
  EXPECT_TRUE(is_loopback("localhost"));
  EXPECT_TRUE(is_loopback("::1"));
  EXPECT_FALSE(is_loopback("0.0.0.0"));
}

}  // namespace
}  // namespace berm
