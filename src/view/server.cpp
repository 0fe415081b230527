#include "berm/view/server.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <csignal>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/strand.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/error.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/serializer.hpp>
#include <boost/beast/http/span_body.hpp>
#include <boost/beast/http/write.hpp>

#include "berm/core/error.hpp"

namespace berm {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;
using SystemError = boost::system::error_code;
using Body = http::span_body<const char>;

constexpr std::uint32_t kMaxHeaderBytes = 8192;
/// What a client sends ahead of the next request; a pipeline deeper than that is no browser's.
constexpr std::size_t kMaxBufferBytes = 2 * std::size_t{kMaxHeaderBytes};
/// The front end brings all it needs; pictures of the screen are data and blobs.
constexpr const char* kContentPolicy =
    "default-src 'self'; img-src 'self' data: blob:; object-src 'none'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'";

std::chrono::steady_clock::duration seconds(double value_s) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(value_s));
}

tcp::endpoint find_endpoint(const ServerOptions& options) {
  SystemError code;
  const auto address = asio::ip::make_address(options.host == "localhost" ? "127.0.0.1" : options.host, code);
  if (code) {
    throw Error(ErrorCode::invalid_argument,
                "--host " + options.host + ": expected an address in numbers, such as 127.0.0.1, ::1 or 0.0.0.0");
  }
  return {address, options.port};
}

/// What all connections share. Outlives them.
struct Shared {
  ViewApi& api;
  ServerOptions options;
  std::atomic<std::size_t> connections{0};
};

std::string_view header_of(const http::request<http::empty_body>& request, http::field field) {
  const auto value = request[field];
  return {value.data(), value.size()};
}

std::string_view header_of(const http::request<http::empty_body>& request, const char* name) {
  const auto value = request[name];
  return {value.data(), value.size()};
}

/// One client: reads a request, answers, reads the next. Every wait has an end; the object lives as long as something
/// is waited for.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(tcp::socket socket, Shared& shared) : stream_(std::move(socket)), shared_(shared) {
    shared_.connections.fetch_add(1);
  }
  ~Connection() { shared_.connections.fetch_sub(1); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void start() {
    asio::dispatch(stream_.get_executor(), [self = shared_from_this()] { self->read(); });
  }

 private:
  void read() {
    parser_.emplace();
    parser_->header_limit(kMaxHeaderBytes);
    stream_.expires_after(seconds(shared_.options.request_timeout_s));
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](const SystemError& code, std::size_t) { self->on_read(code); });
  }

  void on_read(const SystemError& code) {
    if (code == http::error::header_limit || code == http::error::buffer_overflow) {
      send(ViewApi::refuse(431, "the header is too large", "8 KiB is the limit"), false, false);
    } else if (code.category() == http::make_error_code(http::error::bad_method).category() &&
               code != http::error::end_of_stream && code != http::error::partial_message) {
      send(ViewApi::refuse(400, "this is no request", "HTTP/1.1 GET without a body is expected"), false, false);
    } else if (!code) {
      answer(parser_->get());
    }
  }

  void answer(const http::request<http::empty_body>& request) {
    const bool is_head = request.method() == http::verb::head;
    ViewRequest view{.reads = is_head || request.method() == http::verb::get,
                     .target = {request.target().data(), request.target().size()},
                     .caller = {.host = header_of(request, http::field::host),
                                .origin = header_of(request, http::field::origin),
                                .fetch_site = header_of(request, "Sec-Fetch-Site")}};
    if (request.count(http::field::host) > 1 || request.count(http::field::origin) > 1) {
      view.caller.host = {};  // nobody can say which of them others would believe
    }
    send(respond(view), is_head, request.keep_alive());
  }

  ViewAnswer respond(const ViewRequest& request) {
    try {
      return shared_.api.answer(request);
    } catch (const std::exception& error) {
      return ViewApi::refuse(500, error.what(), "try again");
    }
  }

  void send(ViewAnswer answer, bool is_head, bool keep_alive) {
    answer_ = std::move(answer);
    response_.emplace(static_cast<http::status>(answer_.status), 11U);
    response_->keep_alive(keep_alive);
    response_->set(http::field::server, "berm");
    const auto set = [this](auto field, std::string_view value) {
      response_->set(field, beast::string_view(value.data(), value.size()));
    };
    set(http::field::content_type, answer_.content_type);
    set(http::field::cache_control, answer_.cache_control);
    set("Content-Security-Policy", kContentPolicy);
    set("X-Content-Type-Options", "nosniff");
    set("Cross-Origin-Resource-Policy", "same-origin");
    set("Referrer-Policy", "no-referrer");
    if (answer_.status == 405) {
      set(http::field::allow, "GET, HEAD");
    }
    response_->body() = beast::span<const char>(answer_.body->data(), answer_.body->size());
    response_->content_length(answer_.body->size());
    serializer_.emplace(*response_);
    stream_.expires_after(seconds(shared_.options.answer_timeout_s));
    auto done = [self = shared_from_this(), keep_alive](const SystemError& code, std::size_t) {
      self->on_sent(code, keep_alive);
    };
    if (is_head) {
      http::async_write_header(stream_, *serializer_, std::move(done));
    } else {
      http::async_write(stream_, *serializer_, std::move(done));
    }
  }

  void on_sent(const SystemError& code, bool keep_alive) {
    serializer_.reset();
    response_.reset();
    answer_ = {};
    if (code) {
      return;  // the client has gone
    }
    if (keep_alive) {
      read();
      return;
    }
    SystemError ignored;
    stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
  }

  beast::tcp_stream stream_;
  Shared& shared_;
  beast::flat_buffer buffer_{kMaxBufferBytes};
  std::optional<http::request_parser<http::empty_body>> parser_;
  ViewAnswer answer_;
  std::optional<http::response<Body>> response_;
  std::optional<http::response_serializer<Body>> serializer_;
};

}  // namespace

class ViewServer::State {
 public:
  State(ViewApi& api, const ServerOptions& options)
      : shared_{.api = api, .options = options}, acceptor_(io_), signals_(io_), timer_(io_) {
    const tcp::endpoint endpoint = find_endpoint(options);
    try {
      acceptor_.open(endpoint.protocol());
      acceptor_.set_option(asio::socket_base::reuse_address(true));
      acceptor_.bind(endpoint);
      acceptor_.listen();
    } catch (const boost::system::system_error& error) {
      throw FileError(ErrorCode::unreadable, options.host + ":" + std::to_string(options.port), std::nullopt,
                      "cannot listen there: " + error.code().message() + "; --port 0 takes a free port");
    }
    accept();
  }

  [[nodiscard]] tcp::endpoint endpoint() const { return acceptor_.local_endpoint(); }
  [[nodiscard]] std::size_t connections() const { return shared_.connections.load(); }

  void run(bool until_signal) {
    if (until_signal) {
      signals_.add(SIGINT);
      signals_.add(SIGTERM);
      signals_.async_wait([this](const SystemError& code, int) {
        if (!code) {
          stop();
        }
      });
    }
    // A long answer holds a thread: others must still be served.
    const unsigned count = std::clamp(std::thread::hardware_concurrency(), 2U, 4U);
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < count; ++i) {
      threads.emplace_back([this] { io_.run(); });
    }
    io_.run();
    for (std::thread& thread : threads) {
      thread.join();
    }
  }

  void stop() {
    shared_.api.stop();
    io_.stop();
  }

 private:
  void accept() {
    acceptor_.async_accept(asio::make_strand(io_),
                           [this](const SystemError& code, tcp::socket socket) { on_accept(code, std::move(socket)); });
  }

  void on_accept(const SystemError& code, tcp::socket socket) {
    // One too many is closed at once: the destructor of the socket does that.
    if (!code && shared_.connections.load() < shared_.options.max_connections) {
      SystemError ignored;
      socket.set_option(tcp::no_delay(true), ignored);
      std::make_shared<Connection>(std::move(socket), shared_)->start();
    }
    if (!code) {
      accept();
    } else if (code != asio::error::operation_aborted) {
      pause();  // the system is out of descriptors, say: asking again at once would be asked again for ever
    }
  }

  void pause() {
    timer_.expires_after(std::chrono::milliseconds(100));
    timer_.async_wait([this](const SystemError& code) {
      if (!code) {
        accept();
      }
    });
  }

  Shared shared_;
  asio::io_context io_;  // after what its handlers use, so that it goes first
  tcp::acceptor acceptor_;
  asio::signal_set signals_;
  asio::steady_timer timer_;
};

ViewServer::ViewServer(ViewApi& api, const ServerOptions& options) : state_(std::make_unique<State>(api, options)) {}

ViewServer::~ViewServer() = default;

std::uint16_t ViewServer::port() const {
  return state_->endpoint().port();
}

std::string ViewServer::address() const {
  const tcp::endpoint endpoint = state_->endpoint();
  const auto address = endpoint.address();
  const std::string host = address.is_v6() ? "[" + address.to_string() + "]" : address.to_string();
  return "http://" + host + ":" + std::to_string(endpoint.port()) + "/";
}

std::size_t ViewServer::open_connections() const {
  return state_->connections();
}

void ViewServer::run(bool until_signal) {
  state_->run(until_signal);
}

void ViewServer::stop() {
  state_->stop();
}

bool is_loopback(const std::string& host) {
  SystemError code;
  const auto address = asio::ip::make_address(host == "localhost" ? "127.0.0.1" : host, code);
  return !code && address.is_loopback();
}

}  // namespace berm
