// SPDX-License-Identifier: GPL-3.0-or-later
// How a server stops while callers are connected.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <future>
#include <memory>
#include <string>

#include "worker_runtime/grpc/server.h"

namespace flair::runtime {
namespace {

// A caller who has connected, and neither calls nor answers.
class SilentCaller {
 public:
  explicit SilentCaller(const std::string& server) : file_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<uint16_t>(std::stoi(server.substr(server.rfind(':') + 1))));
    // What HTTP/2 begins with, and an empty SETTINGS frame.
    const std::string preface = std::string("PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n") + std::string("\0\0\0\4\0\0\0\0\0", 9);
    connected_ = ::connect(file_, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
                 ::send(file_, preface.data(), preface.size(), MSG_NOSIGNAL) == static_cast<ssize_t>(preface.size()) &&
                 Read(kPatienceMs) > 0;
  }
  ~SilentCaller() { ::close(file_); }
  bool connected() const { return connected_; }

  // Whether the server closes the connection within that time.
  bool IsLeftWithin(int milliseconds) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
    while (true) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
      if (left.count() <= 0) return false;
      const ssize_t count = Read(static_cast<int>(left.count()));
      if (count == 0 || (count < 0 && errno == ECONNRESET)) return true;
    }
  }
  // gRPC's own patience is 20 s: what a test waits for comes well before that.
  static constexpr int kPatienceMs = 10000;

 private:
  // As recv, after waiting; 0 when the server has closed it, -1 when nothing came.
  ssize_t Read(int milliseconds) {
    pollfd events = {.fd = file_, .events = POLLIN, .revents = 0};
    errno = 0;
    if (::poll(&events, 1, milliseconds) <= 0) return -1;
    std::array<char, 4096> buffer;
    return ::recv(file_, buffer.data(), buffer.size(), 0);
  }

  const int file_;
  bool connected_ = false;
};

TEST(ServerStop, WaitsForNoCallerWhoHasNoCall) {
  auto server =
      Server::Start({.listen_address = "127.0.0.1:0", .open_calls = std::make_shared<std::atomic<int>>(0)}, {});
  ASSERT_TRUE(server.ok()) << server.status();
  SilentCaller caller((*server)->address());
  ASSERT_TRUE(caller.connected());
  auto stopped = std::async(std::launch::async, [&] { (*server)->Shutdown(absl::Minutes(10)); });
  EXPECT_TRUE(caller.IsLeftWithin(SilentCaller::kPatienceMs));
  stopped.get();
}

TEST(ServerStop, WaitsForCallsThatAreOpen) {
  const auto open_calls = std::make_shared<std::atomic<int>>(1);
  auto server = Server::Start({.listen_address = "127.0.0.1:0", .open_calls = open_calls}, {});
  ASSERT_TRUE(server.ok()) << server.status();
  SilentCaller caller((*server)->address());
  ASSERT_TRUE(caller.connected());
  auto stopped = std::async(std::launch::async, [&] { (*server)->Shutdown(absl::Minutes(10)); });
  // Some times as long as a caller without a call is waited for.
  EXPECT_FALSE(caller.IsLeftWithin(500));
  *open_calls = 0;
  EXPECT_TRUE(caller.IsLeftWithin(SilentCaller::kPatienceMs));
  stopped.get();
}

TEST(ServerStop, CallsThatNeverEndAreCancelledAfterTheDrain) {
  auto server =
      Server::Start({.listen_address = "127.0.0.1:0", .open_calls = std::make_shared<std::atomic<int>>(1)}, {});
  ASSERT_TRUE(server.ok()) << server.status();
  SilentCaller caller((*server)->address());
  ASSERT_TRUE(caller.connected());
  (*server)->Shutdown(absl::Milliseconds(20));
  EXPECT_TRUE(caller.IsLeftWithin(SilentCaller::kPatienceMs));
}

}  // namespace
}  // namespace flair::runtime
