// SPDX-License-Identifier: GPL-3.0-or-later
#include "studio/gateway/gateway.h"

#include <openssl/rand.h>

#include <array>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/strand.hpp>
#include <condition_variable>
#include <future>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "studio/gateway/connection.h"
#include "studio/gateway/listening.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::studio {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;

constexpr int kThreads = 2;
constexpr size_t kTokenBytes = 32;
constexpr std::chrono::milliseconds kAcceptPause{100};

absl::StatusOr<std::string> MakeToken() {
  std::array<unsigned char, kTokenBytes> bytes;
  if (RAND_bytes(bytes.data(), bytes.size()) != 1) return Unavailable("this machine has no random bytes");
  return fmt::format("{:02x}", fmt::join(bytes, ""));
}

}  // namespace

// Accepts connections, and ends them. Its acceptor has a strand; connections_ is guarded.
class Gateway::Server {
 public:
  Server(GatewayLimits limits, Site site, MethodTable methods)
      : shared_{.limits = limits,
                .site = std::move(site),
                .methods = std::move(methods),
                .admission = nullptr,
                .tls = nullptr,
                .budget = ByteBudget(limits.held_bytes)} {}
  ~Server() { Stop(); }

  absl::StatusOr<int> Listen(const tcp::endpoint& endpoint, const std::string& address) {
    error_code error;
    acceptor_.open(endpoint.protocol(), error);
    if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
    if (!error) acceptor_.bind(endpoint, error);
    if (!error) acceptor_.listen(tcp::acceptor::max_listen_connections, error);
    if (error) {
      return Unavailable("listen address \"{}\": {}", address,
                         error == asio::error::address_in_use ? "another program listens there" : error.message());
    }
    return acceptor_.local_endpoint(error).port();
  }

  void Run(std::string token, Listening listening, int port) {
    shared_.admission = std::make_unique<Admission>(std::move(token), listening.scheme(), listening.hosts, port);
    shared_.tls = std::move(listening.tls);
    asio::post(acceptor_.get_executor(), [this] { Accept(); });
    for (int i = 0; i < kThreads; ++i) threads_.emplace_back([this] { context_.run(); });
  }

  void Stop() {
    const std::lock_guard once(stop_mutex_);
    if (std::exchange(stopped_, true)) return;
    if (threads_.empty()) return;
    std::promise<void> told;
    asio::post(acceptor_.get_executor(), [this, &told] {
      accepting_ends_ = true;
      error_code ignored;
      acceptor_.close(ignored);
      pause_.cancel();
      ForEach([](Connection& connection) { connection.Stop(); });
      told.set_value();
    });
    told.get_future().wait();
    if (!AwaitNone(shared_.limits.drain_timeout)) {
      ForEach([](Connection& connection) { connection.Abort(); });
      AwaitNone(absl::InfiniteDuration());
    }
    work_.reset();
    for (std::thread& thread : threads_) thread.join();
  }

 private:
  void Accept() {
    if (accepting_ends_ || accepting_ || open_count_ >= shared_.limits.connections) return;
    accepting_ = true;
    acceptor_.async_accept(asio::make_strand(context_), [this](error_code error, tcp::socket socket) {
      accepting_ = false;
      if (accepting_ends_) return;
      if (error) return AcceptLater();
      Open(std::move(socket));
      Accept();
    });
  }

  // Such as when the process has no file left: asking at once would only burn time.
  void AcceptLater() {
    accepting_ = true;
    pause_.expires_after(kAcceptPause);
    pause_.async_wait([this](error_code) {
      accepting_ = false;
      Accept();
    });
  }

  void Open(tcp::socket socket) {
    ++open_count_;
    // The last to let go of it may be a thread of gRPC's.
    auto* const connection = new Connection(std::move(socket), shared_);
    const std::shared_ptr<Connection> owned(connection, [this](Connection* ended) { Ended(ended); });
    {
      const std::lock_guard lock(mutex_);
      connections_[connection] = owned;
    }
    owned->Start();
  }

  void Ended(Connection* connection) {
    asio::post(acceptor_.get_executor(), [this] {
      --open_count_;
      Accept();
    });
    // Stop goes on when there is none any more, and nothing of it.
    const std::lock_guard lock(mutex_);
    connections_.erase(connection);
    delete connection;
    ended_.notify_all();
  }

  void ForEach(void (*act)(Connection&)) {
    std::vector<std::shared_ptr<Connection>> open;
    {
      const std::lock_guard lock(mutex_);
      for (const auto& [connection, owned] : connections_) open.push_back(owned.lock());
    }
    for (const auto& connection : open) {
      if (connection != nullptr) act(*connection);
    }
  }

  // False when there are still some.
  bool AwaitNone(absl::Duration patience) {
    std::unique_lock lock(mutex_);
    const auto none = [this] { return connections_.empty(); };
    if (patience != absl::InfiniteDuration()) return ended_.wait_for(lock, absl::ToChronoNanoseconds(patience), none);
    ended_.wait(lock, none);
    return true;
  }

  Shared shared_;
  asio::io_context context_{kThreads};
  asio::executor_work_guard<asio::io_context::executor_type> work_{context_.get_executor()};
  tcp::acceptor acceptor_{asio::make_strand(context_)};
  asio::steady_timer pause_{acceptor_.get_executor()};
  // On the acceptor's strand.
  int open_count_ = 0;
  bool accepting_ = false;
  bool accepting_ends_ = false;

  std::mutex mutex_;
  std::condition_variable ended_;
  std::map<Connection*, std::weak_ptr<Connection>> connections_;

  std::mutex stop_mutex_;
  bool stopped_ = false;
  std::vector<std::thread> threads_;
};

Gateway::Gateway(std::unique_ptr<Server> server) : server_(std::move(server)) {}

Gateway::~Gateway() = default;

void Gateway::Stop() { server_->Stop(); }

absl::StatusOr<std::unique_ptr<Gateway>> Gateway::Start(GatewayOptions options) {
  ASSIGN_OR_RETURN(Listening listening, ReadListening(options));
  ASSIGN_OR_RETURN(MethodTable methods, MethodTable::Make(options.services, options.limits));
  ASSIGN_OR_RETURN(Site site, Site::Read(options.page_folder));
  std::string token = options.token;
  if (token.empty()) {
    ASSIGN_OR_RETURN(token, MakeToken());
  }
  auto server = std::make_unique<Server>(options.limits, std::move(site), std::move(methods));
  ASSIGN_OR_RETURN(const int port, server->Listen(listening.endpoint, options.listen_address));
  std::string address = fmt::format("{}://{}:{}/", listening.scheme(), listening.hosts[0], port);
  server->Run(token, std::move(listening), port);
  std::unique_ptr<Gateway> gateway(new Gateway(std::move(server)));
  gateway->port_ = port;
  gateway->address_ = std::move(address);
  gateway->url_ = fmt::format("{}?token={}", gateway->address_, token);
  return gateway;
}

}  // namespace flair::studio
