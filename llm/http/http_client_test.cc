// SPDX-License-Identifier: GPL-3.0-or-later
// What a server may do to a request, seen from the HTTP client.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "llm/testing/test_http.h"
#include "worker_runtime/testing/fakes.h"

namespace flair::llm {
namespace {

using absl::StatusCode;
using ::flair::testing::ScriptedServer;
using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST_F(HttpClientTest, GivesStatusHeadersAndBody) {
  ScriptedServer server(
      One(R"({"status": 429, "headers": {"Retry-After": "7", "Content-Type": "text/plain"}, "body": "later"})"));
  const auto response = Ask(server.address());
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_EQ(response->status, 429);
  EXPECT_EQ(response->header("retry-after"), "7");
  EXPECT_EQ(response->body, "later");
}

TEST_F(HttpClientTest, SendsHeadersAndBodyAsTheyAre) {
  ScriptedServer server(One(R"({"body": "ok"})"));
  ASSERT_TRUE(Ask(server.address()).ok());
  const auto request = server.requests().front();
  EXPECT_EQ(request.method, "POST");
  EXPECT_EQ(request.target, "/v1/chat/completions");
  EXPECT_EQ(request.body, kQuestion);
  EXPECT_EQ(request.header("authorization"), "Bearer secret-key");
  EXPECT_EQ(request.header("content-type"), "application/json");
  EXPECT_EQ(request.header("accept-encoding"), "gzip, deflate");
}

TEST_F(HttpClientTest, UsesAConnectionAgain) {
  ScriptedServer server(One(R"({"body": "ok"})"));
  HttpClient client({});
  for (int i = 0; i < 3; ++i) ASSERT_TRUE(client.Send(Question(server.address()), call_).ok());
  EXPECT_EQ(server.connection_count(), 1);
}

TEST_F(HttpClientTest, RunsRequestsAtTheSameTime) {
  ScriptedServer server(One(R"({"body": "ok", "gate": "all came"})"));
  HttpClient client({});
  std::atomic<int> ok_count = 0;
  constexpr int kCount = 50;
  std::vector<std::thread> threads;
  for (int i = 0; i < kCount; ++i) {
    threads.emplace_back([&] { ok_count += client.Send(Question(server.address()), call_).ok() ? 1 : 0; });
  }
  server.WaitForRequests(kCount);
  EXPECT_EQ(ok_count, 0);
  server.OpenGate("all came");
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(ok_count, kCount);
}

TEST_F(HttpClientTest, DoesNotFollowARedirect) {
  ScriptedServer elsewhere(One(R"({"body": "gave away the key"})"));
  ScriptedServer server(
      One(R"({"status": 307, "headers": {"Location": ")" + elsewhere.base_url() + R"(/chat/completions"}})"));
  const auto response = Ask(server.address());
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_EQ(response->status, 307);
  EXPECT_EQ(elsewhere.connection_count(), 0);
}

TEST_F(HttpClientTest, UnpacksGzip) {
  ScriptedServer server(One(R"({"body": "a long answer", "fill_bytes": 100000, "gzip": true})"));
  const auto response = Ask(server.address());
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_EQ(response->body, "a long answer" + std::string(100000, 'x'));
}

TEST_F(HttpClientTest, BrokenGzipIsNoAnswer) {
  ScriptedServer server(One(R"({"body": "not gzip at all", "headers": {"Content-Encoding": "gzip"}})"));
  const auto response = Ask(server.address());
  EXPECT_EQ(response.status().code(), StatusCode::kDataLoss) << response.status();
}

TEST_F(HttpClientTest, ABodyOfAGigabyteIsLeftWhereItIs) {
  ScriptedServer server(One(R"({"fill_bytes": 1073741824})"));
  const auto response = Ask(server.address());
  EXPECT_EQ(response.status().code(), StatusCode::kDataLoss) << response.status();
  EXPECT_THAT(response.status().message(), HasSubstr("more than 16777216 bytes"));
  server.WaitForClosedByClient(1);
}

TEST_F(HttpClientTest, ABodyThatUnpacksToTooMuchIsLeftWhereItIs) {
  ScriptedServer server(One(R"({"fill_bytes": 100000000, "gzip": true})"));
  EXPECT_EQ(Ask(server.address()).status().code(), StatusCode::kDataLoss);
}

TEST_F(HttpClientTest, ALongErrorPageIsCutAndStillAnError) {
  ScriptedServer server(One(R"({"status": 503, "fill_bytes": 1073741824})"));
  const auto response = Ask(server.address());
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_EQ(response->status, 503);
  EXPECT_EQ(response->body.size(), 64u << 10);
  server.WaitForClosedByClient(1);
}

TEST_F(HttpClientTest, HeadersWithoutEndAreNoAnswer) {
  ScriptedServer server(One(R"({"headers": {"X-Long": ")" + std::string(70000, 'h') + R"("}, "body": "ok"})"));
  EXPECT_EQ(Ask(server.address()).status().code(), StatusCode::kDataLoss);
}

TEST_F(HttpClientTest, AResetInTheBodyIsABrokenConnection) {
  ScriptedServer server(One(R"({"body": "half of an answer", "cut_after_bytes": 8, "end": "reset"})"));
  const auto response = Ask(server.address());
  EXPECT_EQ(response.status().code(), StatusCode::kUnavailable) << response.status();
}

TEST_F(HttpClientTest, AContentLengthBeyondTheBodyIsABrokenConnection) {
  ScriptedServer server(One(R"({"body": "short", "content_length": 500, "end": "close"})"));
  const auto response = Ask(server.address());
  EXPECT_EQ(response.status().code(), StatusCode::kUnavailable) << response.status();
}

TEST_F(HttpClientTest, AConnectionClosedBeforeTheAnswerIsBroken) {
  ScriptedServer server(One(R"({"chunked": true, "body": "ok", "cut_after_bytes": 0, "end": "close"})"));
  EXPECT_EQ(Ask(server.address()).status().code(), StatusCode::kUnavailable);
}

TEST_F(HttpClientTest, NobodyListeningIsUnavailable) {
  int port = 0;
  {
    ScriptedServer server(One(R"({"body": "ok"})"));
    port = server.port();
  }
  const auto response = Ask("http://user:password@127.0.0.1:" + std::to_string(port));
  EXPECT_EQ(response.status().code(), StatusCode::kUnavailable) << response.status();
  EXPECT_THAT(response.status().message(), Not(HasSubstr("password")));
}

TEST_F(HttpClientTest, AServerThatNeverAnswersIsGivenUp) {
  ScriptedServer server(One(R"({"body": "ok", "gate": "never"})"));
  const auto response = AskWithin(server.address(), {.first_byte = absl::Milliseconds(20)});
  EXPECT_EQ(response.status().code(), StatusCode::kUnavailable);
  EXPECT_THAT(response.status().message(), HasSubstr("silent for 20ms"));
  server.WaitForClosedByClient(1);
}

TEST_F(HttpClientTest, AServerThatStopsInTheMiddleIsGivenUp) {
  ScriptedServer server(One(R"({"body": "half", "cut_after_bytes": 2, "gate_at_cut": "never"})"));
  const auto response = AskWithin(server.address(), {.first_byte = absl::Milliseconds(40)});
  EXPECT_THAT(response.status().message(), HasSubstr("silent for 40ms"));
}

TEST_F(HttpClientTest, AServerThatDripsIsGivenUpAtTheTotalTime) {
  ScriptedServer server(One(R"({"fill_bytes": 1000000, "piece_bytes": [1], "piece_pause_ms": 1})"));
  const auto response = AskWithin(server.address(), {.total = absl::Milliseconds(60)});
  EXPECT_EQ(response.status().code(), StatusCode::kUnavailable);
  EXPECT_THAT(response.status().message(), HasSubstr("no complete answer within 60ms"));
  server.WaitForClosedByClient(1);
}

TEST_F(HttpClientTest, AServerThatTakesItsTimeButNeverFallsSilentIsHeardOut) {
  ScriptedServer server(One(R"({"fill_bytes": 60, "piece_bytes": [1], "piece_pause_ms": 1})"));
  const auto response = AskWithin(server.address(), {.first_byte = absl::Seconds(20)});
  ASSERT_TRUE(response.ok()) << response.status();
  EXPECT_EQ(response->body.size(), 60u);
}

// A socket to which clients can connect, but that nobody serves.
class DeafSocket {
 public:
  DeafSocket() : fd_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    EXPECT_EQ(bind(fd_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(listen(fd_, 4), 0);
    getsockname(fd_, reinterpret_cast<sockaddr*>(&address), &size);
    port_ = ntohs(address.sin_port);
  }
  ~DeafSocket() { close(fd_); }
  std::string port() const { return std::to_string(port_); }

 private:
  const int fd_;
  int port_ = 0;
};

TEST_F(HttpClientTest, ConnectingIncludesTls) {
  const DeafSocket server;
  const auto response = AskWithin("https://127.0.0.1:" + server.port(), {.connect = absl::Milliseconds(20)});
  EXPECT_EQ(response.status().code(), StatusCode::kUnavailable);
  EXPECT_THAT(response.status().message(), HasSubstr("no connection within 20ms"));
}

TEST_F(HttpClientTest, ACancelledCallClosesItsConnection) {
  ScriptedServer server(One(R"({"body": "ok", "gate": "never"})"));
  HttpClient client({});
  absl::Status status;
  std::thread sender([&] { status = client.Send(Question(server.address()), call_).status(); });
  server.WaitForRequests(1);
  call_.cancellation().Cancel();
  sender.join();
  EXPECT_EQ(status.code(), StatusCode::kCancelled);
  server.WaitForClosedByClient(1);
}

TEST_F(HttpClientTest, ACallThatIsOverSendsNothing) {
  ScriptedServer server(One(R"({"body": "ok"})"));
  HttpClient client({});
  runtime::CallContext cancelled;
  cancelled.cancellation().Cancel();
  EXPECT_EQ(client.Send(Question(server.address()), cancelled).status().code(), StatusCode::kCancelled);
  runtime::CallContext late("", absl::InfinitePast(), runtime::SystemClock());
  EXPECT_EQ(client.Send(Question(server.address()), late).status().code(), StatusCode::kDeadlineExceeded);
  EXPECT_EQ(server.connection_count(), 0);
}

TEST_F(HttpClientTest, ASilentServerIsNamedBeforeTheCallsDeadline) {
  ScriptedServer server(One(R"({"body": "ok", "gate": "never"})"));
  const runtime::FakeClock clock;
  HttpClient client({}, clock);
  runtime::CallContext call("", clock.Now() + absl::Milliseconds(60), clock);
  const absl::Status status = client.Send(Question(server.address()), call).status();
  EXPECT_EQ(status.code(), StatusCode::kUnavailable);
  // On a busy machine its whole time may be over before its silence is noticed.
  EXPECT_THAT(
      std::string(status.message()),
      AllOf(HasSubstr("http://127.0.0.1:"), AnyOf(HasSubstr("silent for "), HasSubstr("no complete answer within "))));
  server.WaitForClosedByClient(1);
}

TEST_F(HttpClientTest, ACancelledCallEndsAStreamInItsMiddle) {
  ScriptedServer server(One(R"({"fill_bytes": 1000000, "piece_bytes": [1], "piece_pause_ms": 1, "chunked": true})"));
  absl::Status status;
  std::thread asker([&] { status = HttpClient({}).Send(Question(server.address()), call_).status(); });
  server.WaitForRequests(1);
  call_.cancellation().Cancel();
  asker.join();
  EXPECT_EQ(status.code(), StatusCode::kCancelled);
  server.WaitForClosedByClient(1);
}

}  // namespace
}  // namespace flair::llm
