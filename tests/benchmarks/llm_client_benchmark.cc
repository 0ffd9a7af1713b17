// SPDX-License-Identifier: GPL-3.0-or-later
// What the client of a language model costs: CPU a call, and memory with many calls in flight. The server is another
// process, so that the CPU column and the resident memory are the client's alone.
#include <benchmark/benchmark.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "llm/openai/openai_client.h"
#include "tests/fixtures/llm_server/scripted_server.h"

namespace flair::llm {
namespace {

using flair::testing::MakeTestCertificate;
using flair::testing::Script;
using flair::testing::ScriptedServer;
using flair::testing::TestCertificate;

// A scripted server in a process of its own, which ends with this one.
class ServerProcess {
 public:
  // `gate_count`: open the script's gate "all came" when told by OpenGate(), after so many requests came; 0 for none.
  ServerProcess(const Script& script, std::optional<TestCertificate> certificate, int gate_count) {
    int from_child[2], to_child[2];
    if (pipe(from_child) != 0 || pipe(to_child) != 0) std::abort();
    if (fork() == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      close(from_child[0]);
      close(to_child[1]);
      Serve(script, certificate, gate_count, to_child[0], from_child[1]);
    }
    close(from_child[1]);
    close(to_child[0]);
    read_fd_ = from_child[0];
    write_fd_ = to_child[1];
    int port = 0;
    Read(&port, sizeof(port));
    base_url_ = std::string(certificate ? "https" : "http") + "://127.0.0.1:" + std::to_string(port) + "/v1";
  }
  ~ServerProcess() {
    close(read_fd_);
    close(write_fd_);
  }

  const std::string& base_url() const { return base_url_; }
  void WaitForAll() {
    char byte = 0;
    Read(&byte, 1);
  }
  void OpenGate() {
    if (write(write_fd_, "o", 1) != 1) std::abort();
  }

 private:
  [[noreturn]] static void Serve(const Script& script, const std::optional<TestCertificate>& certificate,
                                 int gate_count, int read_fd, int write_fd) {
    ScriptedServer server(script, certificate);
    const int port = server.port();
    char byte = 'a';
    if (write(write_fd, &port, sizeof(port)) != sizeof(port)) _exit(1);
    if (gate_count > 0) {
      server.WaitForRequests(gate_count);
      if (write(write_fd, &byte, 1) != 1 || read(read_fd, &byte, 1) != 1) _exit(1);
      server.OpenGate("all came");
    }
    // Until the benchmark closes its end.
    while (read(read_fd, &byte, 1) > 0) {
    }
    _exit(0);
  }

  void Read(void* data, size_t size) const {
    if (read(read_fd_, data, size) != static_cast<ssize_t>(size)) std::abort();
  }

  int read_fd_ = -1;
  int write_fd_ = -1;
  std::string base_url_;
};

// About as long as the longest step of a room: 5,000 tokens of question, 1,000 of answer.
std::string Text(size_t byte_count) {
  const std::string sentence = "The bed stands with its head against the north wall, away from the door. ";
  std::string text;
  while (text.size() < byte_count) text += sentence;
  return text;
}

Script LongAnswers() {
  Script script = flair::testing::AlwaysAnswers(Text(4000));
  // A token a piece.
  script.exchanges.front().answer["delta_bytes"] = {4};
  return script;
}

ChatRequest LongQuestion() {
  return {.step = "objects",
          .messages = {{Role::kSystem, Text(10000)}, {Role::kUser, Text(8000)}},
          .schema = R"({"type":"object","properties":{"objects":{"type":"array","items":{"type":"string"}}}})",
          .schema_name = "objects"};
}

OpenAiOptions Options(const ServerProcess& server, bool stream) {
  OpenAiOptions options;
  options.base_url = server.base_url();
  options.model = "some-model";
  options.stream = stream;
  return options;
}

HttpOptions Trusting(const std::optional<TestCertificate>& certificate) {
  HttpOptions options;
  if (!certificate.has_value()) return options;
  options.ca_path = "/tmp/flair_benchmark_ca_" + std::to_string(getpid()) + ".pem";
  std::ofstream(options.ca_path) << certificate->certificate_pem;
  return options;
}

// As a model that writes a token every millisecond.
void TrickledCall(benchmark::State& state) {
  const auto certificate = state.range(0) != 0 ? std::optional(MakeTestCertificate()) : std::nullopt;
  Script script = LongAnswers();
  script.exchanges.front().piece_byte_counts = {240};
  script.exchanges.front().piece_pause_milliseconds = 1;
  ServerProcess server(script, certificate, 0);
  HttpLoop loop;
  const HttpOptions http = Trusting(certificate);
  OpenAiClient client(Options(server, true), loop, http);
  runtime::CallContext call;
  const ChatRequest request = LongQuestion();
  for (auto _ : state) {
    const auto answer = AskAndWait(client, request, call);
    if (!answer.ok()) state.SkipWithError(std::string(answer.status().message()).c_str());
  }
  if (!http.ca_path.empty()) unlink(http.ca_path.c_str());
}
BENCHMARK(TrickledCall)
    ->ArgName("tls")
    ->Arg(0)
    ->Arg(1)
    ->Iterations(4)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

void Call(benchmark::State& state) {
  const bool stream = state.range(0) != 0;
  const auto certificate = state.range(1) != 0 ? std::optional(MakeTestCertificate()) : std::nullopt;
  ServerProcess server(LongAnswers(), certificate, 0);
  HttpLoop loop;
  const HttpOptions http = Trusting(certificate);
  OpenAiClient client(Options(server, stream), loop, http);
  runtime::CallContext call;
  const ChatRequest request = LongQuestion();
  for (auto _ : state) {
    const auto answer = AskAndWait(client, request, call);
    if (!answer.ok()) state.SkipWithError(std::string(answer.status().message()).c_str());
  }
  if (!http.ca_path.empty()) unlink(http.ca_path.c_str());
}
BENCHMARK(Call)
    ->ArgNames({"stream", "tls"})
    ->ArgsProduct({{0, 1}, {0, 1}})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

// A connection for each call. With the system's certificates the test's is not trusted, which is found out when the
// handshake is nearly over; it shows what loading them takes.
void NewTlsConnection(benchmark::State& state) {
  const bool system_trust = state.range(0) != 0;
  const TestCertificate certificate = MakeTestCertificate();
  Script script = LongAnswers();
  script.exchanges.front().end = flair::testing::ConnectionEnd::kClose;
  ServerProcess server(script, certificate, 0);
  HttpLoop loop;
  const HttpOptions http = system_trust ? HttpOptions() : Trusting(certificate);
  OpenAiClient client(Options(server, false), loop, http);
  runtime::CallContext call;
  const ChatRequest request = LongQuestion();
  for (auto _ : state) {
    if (AskAndWait(client, request, call).ok() == system_trust) state.SkipWithError("unexpected trust");
  }
  if (!http.ca_path.empty()) unlink(http.ca_path.c_str());
}
BENCHMARK(NewTlsConnection)
    ->ArgName("system_trust")
    ->Arg(0)
    ->Arg(1)
    ->Iterations(20)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

double ResidentMegabytes() {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word) {
    double kilobytes = 0;
    if (word == "VmRSS:" && status >> kilobytes) return kilobytes / 1024;
  }
  return 0;
}

void InFlight(benchmark::State& state) {
  const bool stream = state.range(0) != 0;
  const auto certificate = state.range(1) != 0 ? std::optional(MakeTestCertificate()) : std::nullopt;
  const int call_count = 500;
  double waiting_mb = 0, answered_mb = 0;
  const std::vector<ChatRequest> requests(call_count, LongQuestion());
  for (auto _ : state) {
    Script script = LongAnswers();
    script.exchanges.front().gate = "all came";
    ServerProcess server(script, certificate, call_count);
    HttpLoop loop;
    const HttpOptions http = Trusting(certificate);
    OpenAiClient client(Options(server, stream), loop, http);
    runtime::CallContext call;
    std::thread gate([&] {
      server.WaitForAll();
      waiting_mb = ResidentMegabytes();
      server.OpenGate();
    });
    const auto answers = AskAllAndWait(client, requests, call);
    gate.join();
    answered_mb = ResidentMegabytes();
    for (const auto& answer : answers) {
      if (!answer.ok()) state.SkipWithError(std::string(answer.status().message()).c_str());
    }
    if (!http.ca_path.empty()) unlink(http.ca_path.c_str());
  }
  state.counters["waiting_mb"] = waiting_mb;
  state.counters["answered_mb"] = answered_mb;
  state.counters["calls"] = call_count;
}
BENCHMARK(InFlight)
    ->ArgNames({"stream", "tls"})
    ->ArgsProduct({{0, 1}, {0, 1}})
    ->Iterations(1)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flair::llm
