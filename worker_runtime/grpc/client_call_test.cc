// SPDX-License-Identifier: GPL-3.0-or-later
#include "worker_runtime/grpc/client_call.h"

#include <gmock/gmock.h>
#include <grpc/grpc.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include "absl/time/clock.h"
#include "flair/v1/worker_service.grpc.pb.h"
#include "fmt/format.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::runtime {
namespace {

// A port of 127.0.0.1 that is nobody else's while this lives; connections are refused until it listens.
class HeldPort {
 public:
  HeldPort() : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    port_ = ntohs(address.sin_port);
  }
  HeldPort(const HeldPort&) = delete;
  HeldPort& operator=(const HeldPort&) = delete;
  ~HeldPort() { ::close(socket_); }

  void Listen() { EXPECT_EQ(::listen(socket_, 8), 0); }
  int port() const { return port_; }

 private:
  const int socket_;
  int port_ = 0;
};

// What a call to `address` ends with.
absl::Status Call(const std::string& address, absl::Duration within = absl::Seconds(30)) {
  ASSIGN_OR_RETURN(const auto channel, MakeChannel(address, v1::WorkerService::service_full_name()));
  const auto stub = v1::WorkerService::NewStub(channel);
  CallContext call;
  absl::Status status = UnaryRequest(*stub, &v1::WorkerService::StubInterface::GetWorker, v1::GetWorkerRequest(), call,
                                     absl::Now() + within)
                            .status();
  EXPECT_TRUE(IsOfConnection(status)) << status;
  return absl::Status(status.code(), status.message());
}

TEST(ConnectionErrors, NamesTheAddressWhereNothingListens) {
  const HeldPort port;
  const auto words =
      absl::UnavailableError(fmt::format("connection refused, nothing listens on 127.0.0.1:{}", port.port()));
  EXPECT_EQ(Call(fmt::format("127.0.0.1:{}", port.port())), words);
  EXPECT_EQ(Call(fmt::format("dns:///127.0.0.1:{}", port.port())), words);
  EXPECT_EQ(Call("unix:/nowhere/socket"), absl::UnavailableError("there is no socket unix:/nowhere/socket"));
}

TEST(ConnectionErrors, ASilentServerGivesNoAnswerInTime) {
  HeldPort port;
  port.Listen();
  EXPECT_EQ(Call(fmt::format("127.0.0.1:{}", port.port()), absl::Milliseconds(50)),
            absl::DeadlineExceededError("no answer in time"));
}

// Sentences that gRPC 1.51.1 ended calls with.
TEST(ConnectionErrors, TlsNamesAndOtherServersAreNamedInPlainWords) {
  const std::string tried = "failed to connect to all addresses; last error: ";
  EXPECT_EQ(InPlainWords(tried + "UNKNOWN: ipv6:%5B::1%5D:59999: Failed to connect to remote host: Connection refused"),
            "connection refused, nothing listens on [::1]:59999");
  EXPECT_EQ(InPlainWords(tried + "UNKNOWN: ipv4:10.0.0.1:7: Tls handshake failed: SSL_ERROR_SSL: "
                                 "error:0A00010B:SSL routines::wrong version number"),
            "10.0.0.1:7 does not use TLS");
  EXPECT_EQ(InPlainWords(tried + "UNKNOWN: ipv4:10.0.0.1:7: Custom verification check failed with error: "
                                 "UNAUTHENTICATED: Hostname Verification Check failed."),
            "the certificate of 10.0.0.1:7 is for another name");
  EXPECT_EQ(InPlainWords(tried + "UNAVAILABLE: ipv4:10.0.0.1:7: Socket closed"),
            "10.0.0.1:7 closed the connection at once; does it expect TLS, or another certificate?");
  EXPECT_EQ(InPlainWords("DNS resolution failed for no.such:80: C-ares status is not ARES_SUCCESS qtype=A name=no.such "
                         "is_balancer=0: Domain name not found"),
            "the host name no.such:80 is unknown");
  EXPECT_EQ(InPlainWords("Received RST_STREAM with error code 11"),
            "the server has no room for so large a message at the moment; try again later");
  EXPECT_EQ(InPlainWords("Received http2 header with status: 404"),
            "a web server or proxy answers there (status 404), not a gRPC server");
}

TEST(ConnectionErrors, HandshakeTimeoutsDifferFromRefusedConnections) {
  const std::string tried = "failed to connect to all addresses; last error: UNKNOWN: ipv4:10.0.0.1:7: ";
  const auto ends = [&](const std::string& what) {
    return HandshakeTimedOut(absl::UnavailableError(InPlainWords(tried + what)));
  };
  EXPECT_TRUE(ends("connection attempt timed out before receiving SETTINGS frame"));
  EXPECT_TRUE(ends("Handshake read failed"));
  EXPECT_FALSE(ends("Failed to connect to remote host: Connection refused"));
  EXPECT_FALSE(HandshakeTimedOut(absl::OkStatus()));
}

TEST(Channel, TheLastOneDoesNotWaitForTheLibraryToEnd) {
  ASSERT_TRUE(MakeChannel("127.0.0.1:1", "").ok());
  EXPECT_EQ(grpc_is_initialized(), 1);
}

TEST(ConnectionErrors, KeepsWhatItDoesNotKnow) {
  const std::string tried = "failed to connect to all addresses; last error: ";
  EXPECT_EQ(InPlainWords(tried + "UNKNOWN: ipv4:10.0.0.1:7: the moon is full"),
            "no connection to 10.0.0.1:7: the moon is full");
  for (const char* message : {"", "all threads are busy", "failed to connect to all addresses; last error: ",
                              "failed to connect to all addresses; last error: a: b", "DNS resolution failed for ",
                              "DNS resolution failed for a: b", "Connection refused"}) {
    EXPECT_EQ(InPlainWords(message), message);
  }
}

}  // namespace
}  // namespace flair::runtime
