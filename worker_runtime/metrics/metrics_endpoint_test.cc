// SPDX-License-Identifier: GPL-3.0-or-later
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <string>
#include <vector>

#include "worker_runtime/metrics/prometheus_metrics.h"
#include "worker_runtime/security/security.h"

namespace flair::runtime {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// A connection that may say what it likes.
class Caller {
 public:
  explicit Caller(const std::string& address) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in to = {};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = ::htonl(INADDR_LOOPBACK);
    to.sin_port = ::htons(static_cast<uint16_t>(std::stoi(address.substr(address.rfind(':') + 1))));
    connected_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0;
  }
  ~Caller() { ::close(socket_); }
  Caller(const Caller&) = delete;
  Caller& operator=(const Caller&) = delete;

  bool connected() const { return connected_; }
  void Say(const std::string& text) { (void)::send(socket_, text.data(), text.size(), MSG_NOSIGNAL); }
  // All until the server closes.
  std::string Listen() {
    std::string heard;
    char buffer[4096];
    for (ssize_t n; (n = ::recv(socket_, buffer, sizeof buffer, 0)) > 0;) heard.append(buffer, static_cast<size_t>(n));
    return heard;
  }

 private:
  int socket_;
  bool connected_ = false;
};

std::string Get(const std::string& address, const std::string& path = "/metrics") {
  Caller caller(address);
  caller.Say("GET " + path + " HTTP/1.1\r\nHost: flair\r\nConnection: close\r\n\r\n");
  return caller.Listen();
}

std::unique_ptr<MetricsEndpoint> Start(const PrometheusMetrics& metrics, absl::Duration patience = absl::Seconds(3)) {
  auto endpoint = MetricsEndpoint::Start("127.0.0.1:0", metrics, patience);
  EXPECT_TRUE(endpoint.ok()) << endpoint.status();
  return *std::move(endpoint);
}

TEST(MetricsEndpoint, AnswersOverHttp) {
  PrometheusMetrics metrics;
  const ProcessMetrics process(metrics, "flair-test", "abc");
  const auto endpoint = Start(metrics);
  EXPECT_THAT(endpoint->address(), StartsWith("127.0.0.1:"));
  const std::string answer = Get(endpoint->address());
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200"));
  EXPECT_THAT(answer, AllOf(HasSubstr("Content-Type: text/plain"),
                            HasSubstr("flair_build_info{build=\"abc\",program=\"flair-test\"} 1"),
                            HasSubstr("# TYPE process_cpu_seconds_total counter\nprocess_cpu_seconds_total ")));
  for (const std::string name : {"process_resident_memory_bytes", "process_open_fds", "process_max_fds",
                                 "process_threads", "process_start_time_seconds"}) {
    const size_t at = answer.find("\n" + name + " ");
    ASSERT_NE(at, std::string::npos) << name;
    EXPECT_GT(std::stod(answer.substr(at + name.size() + 2)), 0) << name;
  }
}

TEST(MetricsEndpoint, HasNothingElse) {
  const PrometheusMetrics metrics;
  const auto endpoint = Start(metrics);
  EXPECT_THAT(Get(endpoint->address(), "/"), StartsWith("HTTP/1.1 404"));
  EXPECT_THAT(Get(endpoint->address(), "/../../etc/passwd"), StartsWith("HTTP/1.1 4"));
}

TEST(MetricsEndpoint, SaysWhatIsWrongWithAnAddress) {
  const PrometheusMetrics metrics;
  for (const std::string address : {"", "9090", ":9090", "127.0.0.1", "127.0.0.1:", "127.0.0.1:x", "127.0.0.1:65536",
                                    "127.0.0.1:1,0.0.0.0:2", "+9090", "127.0.0.1:9090s", "unix:/tmp/x", "a b:1"}) {
    const auto endpoint = MetricsEndpoint::Start(address, metrics);
    EXPECT_EQ(endpoint.status().code(), absl::StatusCode::kInvalidArgument) << address;
    EXPECT_THAT(std::string(endpoint.status().message()),
                StartsWith("metrics_address \"" + address + "\": expected HOST:PORT"));
  }
  EXPECT_TRUE(CheckMetricsAddress("localhost:0").ok());
  EXPECT_TRUE(CheckMetricsAddress("[::1]:9090").ok());
}

TEST(MetricsEndpoint, SaysThatAnAddressIsTaken) {
  const PrometheusMetrics metrics;
  const auto first = Start(metrics);
  const auto second = MetricsEndpoint::Start(first->address(), metrics);
  EXPECT_EQ(second.status().code(), absl::StatusCode::kUnavailable);
  EXPECT_THAT(std::string(second.status().message()), HasSubstr(first->address() + ": cannot listen there"));
}

TEST(MetricsEndpoint, OutlivesCallersWhoSpeakNoHttp) {
  const PrometheusMetrics metrics;
  const auto endpoint = Start(metrics, absl::Milliseconds(300));
  for (const std::string& said : std::vector<std::string>{
           "\x16\x03\x01\x02", std::string(100000, 'A'),
           "GET /metrics HTTP/1.1\r\nX: " + std::string(1000000, 'x') + "\r\n\r\n", "GET /metrics HTTP/9.9\r\n\r\n",
           "\r\n\r\n\r\n", "POST /metrics HTTP/1.1\r\nContent-Length: 99999999999999999999\r\n\r\n",
           std::string("GET /\0metrics HTTP/1.1\r\n\r\n", 26)}) {
    Caller caller(endpoint->address());
    caller.Say(said);
    EXPECT_EQ(caller.Listen().find("flair_"), std::string::npos);
    EXPECT_THAT(Get(endpoint->address()), StartsWith("HTTP/1.1 200"));
  }
}

TEST(MetricsEndpoint, CallersWhoNeverFinishKeepFewFilesAndAreLeftInTheEnd) {
  const PrometheusMetrics metrics;
  const auto endpoint = Start(metrics, absl::Milliseconds(300));
  constexpr int kSlowCallers = 40;
  std::vector<std::unique_ptr<Caller>> slow;
  for (int i = 0; i < kSlowCallers; ++i) {
    slow.push_back(std::make_unique<Caller>(endpoint->address()));
    ASSERT_TRUE(slow.back()->connected());
    slow.back()->Say("GET /metrics HTTP/1.1\r\nX-Slow: ");
  }
  // The smallest free number: those of the callers, and what the endpoint has taken of them.
  const int next_file = ::dup(STDIN_FILENO);
  ::close(next_file);
  EXPECT_LT(next_file, kSlowCallers + 30);
  // Waits until all before it have been left.
  EXPECT_THAT(Get(endpoint->address()), StartsWith("HTTP/1.1 200"));
}

}  // namespace
}  // namespace flair::runtime
