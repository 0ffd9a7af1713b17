// SPDX-License-Identifier: GPL-3.0-or-later
// What the client of a language model costs: CPU a call, and memory with many calls in flight. The server is another
// process, so that the CPU column and the resident memory are the client's alone.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "llm/openai/openai_client.h"
#include "tests/benchmarks/llm_server_process.h"

namespace flair::llm {
namespace {

using flair::testing::Http2Proxy;
using flair::testing::LlmServerProcess;
using flair::testing::LongAnswers;
using flair::testing::LongQuestion;
using flair::testing::MakeTestCertificate;
using flair::testing::OptionsFor;
using flair::testing::OwnStatus;
using flair::testing::Script;
using flair::testing::TestCertificate;
using flair::testing::Trust;

// How a server is reached.
enum Way { kPlain = 0, kTls = 1, kHttp2 = 2 };

// A server that is reached in one of the ways; without a base_url when it cannot be.
struct ReachedServer {
  ReachedServer(const Script& script, int64_t way)
      : certificate(way == kPlain ? std::nullopt : std::optional(MakeTestCertificate())),
        server(script, way == kTls ? certificate : std::nullopt, 0),
        proxy(way == kHttp2 ? Http2Proxy::Start(server, *certificate) : nullptr),
        trust(certificate) {
    if (proxy != nullptr) {
      base_url = proxy->base_url();
    } else if (way != kHttp2) {
      base_url = server.base_url();
    }
  }
  std::optional<TestCertificate> certificate;
  LlmServerProcess server;
  std::unique_ptr<Http2Proxy> proxy;
  Trust trust;
  std::string base_url;
};

constexpr char kNoProxy[] = "nghttpx is not there: package nghttp2-proxy, or its path in FLAIR_NGHTTPX";

// As a model that writes a token every so many milliseconds, each piece in a packet and a chunk of its own.
Script Trickling(int pause_milliseconds) {
  Script script = LongAnswers();
  script.exchanges.front().piece_byte_counts = {240};
  script.exchanges.front().piece_pause_milliseconds = pause_milliseconds;
  return script;
}

void TrickledCall(benchmark::State& state) {
  const ReachedServer reached(Trickling(1), state.range(0));
  if (reached.base_url.empty()) return state.SkipWithError(kNoProxy);
  HttpLoop loop;
  OpenAiClient client(OptionsFor(reached.base_url, true), loop, reached.trust.options());
  runtime::CallContext call;
  const ChatRequest request = LongQuestion();
  for (auto _ : state) {
    const auto answer = AskAndWait(client, request, call);
    if (!answer.ok()) state.SkipWithError(std::string(answer.status().message()).c_str());
  }
}
BENCHMARK(TrickledCall)
    ->ArgName("way")
    ->DenseRange(kPlain, kHttp2)
    ->Iterations(4)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

// 500 such at once, at the pace of a model that is busy: a token every 20 ms, 18 s an answer.
void TrickledInFlight(benchmark::State& state) {
  constexpr int kCallCount = 500;
  const ReachedServer reached(Trickling(20), state.range(0));
  if (reached.base_url.empty()) return state.SkipWithError(kNoProxy);
  const std::vector<ChatRequest> requests(kCallCount, LongQuestion());
  double most_mb = 0, thread_count = 0;
  for (auto _ : state) {
    HttpLoop loop;
    OpenAiClient client(OptionsFor(reached.base_url, true), loop, reached.trust.options());
    runtime::CallContext call;
    std::atomic<bool> over = false;
    std::thread watch([&] {
      while (!over) {
        most_mb = std::max(most_mb, OwnStatus("VmRSS"));
        // Without this one.
        thread_count = std::max(thread_count, OwnStatus("Threads") - 1);
        std::this_thread::sleep_for(std::chrono::milliseconds(500));
      }
    });
    const auto answers = AskAllAndWait(client, requests, call);
    over = true;
    watch.join();
    for (const auto& answer : answers) {
      if (!answer.ok()) state.SkipWithError(std::string(answer.status().message()).c_str());
    }
  }
  state.counters["most_mb"] = most_mb;
  state.counters["threads"] = thread_count;
  state.counters["calls"] = kCallCount;
}
BENCHMARK(TrickledInFlight)
    ->ArgName("way")
    ->DenseRange(kPlain, kHttp2)
    ->Iterations(1)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

void Call(benchmark::State& state) {
  const bool stream = state.range(0) != 0;
  const auto certificate = state.range(1) != 0 ? std::optional(MakeTestCertificate()) : std::nullopt;
  LlmServerProcess server(LongAnswers(), certificate, 0);
  HttpLoop loop;
  const Trust trust(certificate);
  OpenAiClient client(OptionsFor(server.base_url(), stream), loop, trust.options());
  runtime::CallContext call;
  const ChatRequest request = LongQuestion();
  for (auto _ : state) {
    const auto answer = AskAndWait(client, request, call);
    if (!answer.ok()) state.SkipWithError(std::string(answer.status().message()).c_str());
  }
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
  LlmServerProcess server(script, certificate, 0);
  HttpLoop loop;
  const Trust trust(system_trust ? std::nullopt : std::optional(certificate));
  OpenAiClient client(OptionsFor(server.base_url(), false), loop, trust.options());
  runtime::CallContext call;
  const ChatRequest request = LongQuestion();
  for (auto _ : state) {
    if (AskAndWait(client, request, call).ok() == system_trust) state.SkipWithError("unexpected trust");
  }
}
BENCHMARK(NewTlsConnection)
    ->ArgName("system_trust")
    ->Arg(0)
    ->Arg(1)
    ->Iterations(20)
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);

void InFlight(benchmark::State& state) {
  const bool stream = state.range(0) != 0;
  const auto certificate = state.range(1) != 0 ? std::optional(MakeTestCertificate()) : std::nullopt;
  const int call_count = 500;
  double waiting_mb = 0, answered_mb = 0;
  const std::vector<ChatRequest> requests(call_count, LongQuestion());
  for (auto _ : state) {
    Script script = LongAnswers();
    script.exchanges.front().gate = "all came";
    LlmServerProcess server(script, certificate, call_count);
    HttpLoop loop;
    const Trust trust(certificate);
    OpenAiClient client(OptionsFor(server.base_url(), stream), loop, trust.options());
    runtime::CallContext call;
    std::thread gate([&] {
      server.WaitForAll();
      waiting_mb = OwnStatus("VmRSS");
      server.OpenGate();
    });
    const auto answers = AskAllAndWait(client, requests, call);
    gate.join();
    answered_mb = OwnStatus("VmRSS");
    for (const auto& answer : answers) {
      if (!answer.ok()) state.SkipWithError(std::string(answer.status().message()).c_str());
    }
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
