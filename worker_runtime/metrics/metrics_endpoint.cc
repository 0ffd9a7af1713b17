// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <prometheus/text_serializer.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <chrono>
#include <optional>
#include <thread>
#include <utility>

#include "worker_runtime/metrics/prometheus_metrics.h"
#include "worker_runtime/security/security.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::runtime {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;
using boost::system::error_code;

// Connections at a time; more wait in the kernel.
constexpr int kConnectionLimit = 16;
constexpr uint32_t kHeaderLimitBytes = 8192;

using Request = http::request<http::empty_body>;
using Response = http::response<http::string_body>;

Response Answer(http::status status, std::string body) {
  Response response(status, 11, std::move(body));
  response.set(http::field::content_type, "text/plain; charset=utf-8");
  response.keep_alive(false);
  response.prepare_payload();
  return response;
}

Response Answer(const Request& request, const PrometheusMetrics& metrics) {
  const std::string_view target(request.target().data(), request.target().size());
  if (target.substr(0, target.find('?')) != "/metrics") {
    return Answer(http::status::not_found, "Not found; try /metrics.\n");
  }
  if (request.method() != http::verb::get) {
    Response response = Answer(http::status::method_not_allowed, "Only GET.\n");
    response.set(http::field::allow, "GET");
    return response;
  }
  Response response = Answer(http::status::ok, prometheus::TextSerializer().Serialize(metrics.Collect()));
  response.set(http::field::content_type, "text/plain; version=0.0.4; charset=utf-8");
  return response;
}

// One request and its answer. Lives as long as an operation of it is under way, and tells `done` at its end.
class Connection final : public std::enable_shared_from_this<Connection> {
 public:
  Connection(tcp::socket socket, const PrometheusMetrics& metrics, std::function<void()> done)
      : stream_(std::move(socket)), metrics_(metrics), done_(std::move(done)) {
    parser_.header_limit(kHeaderLimitBytes);
    parser_.body_limit(0);
  }
  ~Connection() { done_(); }

  void Start(std::chrono::milliseconds patience) {
    // Once, for all that follows.
    stream_.expires_after(patience);
    http::async_read(stream_, buffer_, parser_, [self = shared_from_this()](error_code error, size_t) {
      if (!error) {
        self->Send(Answer(self->parser_.get(), self->metrics_));
      } else if (error.category() == http::make_error_code(http::error::bad_method).category() &&
                 error != http::error::end_of_stream) {
        self->Send(Answer(http::status::bad_request, "Bad request.\n"));
      }
    });
  }

 private:
  void Send(Response response) {
    response_ = std::move(response);
    http::async_write(stream_, *response_, [self = shared_from_this()](error_code, size_t) {
      error_code ignored;
      self->stream_.socket().shutdown(tcp::socket::shutdown_send, ignored);
    });
  }

  beast::tcp_stream stream_;
  const PrometheusMetrics& metrics_;
  const std::function<void()> done_;
  beast::flat_buffer buffer_{kHeaderLimitBytes};
  http::request_parser<http::empty_body> parser_;
  std::optional<Response> response_;
};

}  // namespace

// All but Listen, Start and the destructor runs on its thread.
class MetricsEndpoint::Server {
 public:
  Server(const PrometheusMetrics& metrics, absl::Duration patience)
      : metrics_(metrics), patience_(absl::ToInt64Milliseconds(patience)) {}
  ~Server() {
    context_.stop();
    if (thread_.joinable()) thread_.join();
    stopped_ = true;
  }

  // The port, or nothing when that does not work.
  std::optional<int> Listen(const std::string& host, const std::string& port) {
    error_code error;
    tcp::resolver resolver(context_);
    const auto found = resolver.resolve(host, port, tcp::resolver::passive, error);
    if (error || found.empty()) return std::nullopt;
    const tcp::endpoint endpoint = found.begin()->endpoint();
    acceptor_.open(endpoint.protocol(), error);
    // A program that has just ended leaves the port for its successor.
    if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(tcp::acceptor::max_listen_connections, error);
    if (error) return std::nullopt;
    return acceptor_.local_endpoint(error).port();
  }

  void Start() {
    Accept();
    thread_ = std::thread([this] { context_.run(); });
  }

 private:
  void Accept() {
    if (stopped_ || accepting_ || open_count_ >= kConnectionLimit) return;
    accepting_ = true;
    acceptor_.async_accept([this](error_code error, tcp::socket socket) {
      if (error) return AcceptLater();
      accepting_ = false;
      ++open_count_;
      std::make_shared<Connection>(std::move(socket), metrics_, [this] {
        --open_count_;
        Accept();
      })->Start(patience_);
      Accept();
    });
  }

  // Such as when the process has no file left: asking at once would only burn time.
  void AcceptLater() {
    pause_.expires_after(std::chrono::milliseconds(100));
    pause_.async_wait([this](error_code) {
      accepting_ = false;
      Accept();
    });
  }

  const PrometheusMetrics& metrics_;
  const std::chrono::milliseconds patience_;
  int open_count_ = 0;
  bool accepting_ = false;
  bool stopped_ = false;
  // Destroyed after what runs on it; destroys the connections, which still call back.
  asio::io_context context_{1};
  tcp::acceptor acceptor_{context_};
  asio::steady_timer pause_{context_};
  std::thread thread_;
};

MetricsEndpoint::MetricsEndpoint(std::unique_ptr<Server> server, std::string address)
    : server_(std::move(server)), address_(std::move(address)) {}

MetricsEndpoint::~MetricsEndpoint() = default;

absl::StatusOr<std::unique_ptr<MetricsEndpoint>> MetricsEndpoint::Start(const std::string& address,
                                                                        const PrometheusMetrics& metrics,
                                                                        absl::Duration patience) {
  if (const absl::Status status = CheckMetricsAddress(address); !status.ok()) {
    return absl::InvalidArgumentError("metrics_address " + std::string(status.message()));
  }
  const size_t colon = address.rfind(':');
  std::string host = address.substr(0, colon);
  if (host.starts_with("[")) host = host.substr(1, host.size() - 2);
  auto server = std::make_unique<Server>(metrics, patience);
  const std::optional<int> port = server->Listen(host, address.substr(colon + 1));
  if (!port.has_value()) {
    return Unavailable(
        "metrics_address {}: cannot listen there: the address is in use, not of this machine, or not permitted",
        address);
  }
  server->Start();
  std::string bound = fmt::format("{}:{}", address.substr(0, colon), *port);
  return std::unique_ptr<MetricsEndpoint>(new MetricsEndpoint(std::move(server), std::move(bound)));
}

}  // namespace flair::runtime
