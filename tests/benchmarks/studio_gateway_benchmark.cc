// SPDX-License-Identifier: GPL-3.0-or-later
// Round trips through the studio's gateway on one connection that is kept: from the request's first byte to the
// answer's last, with a service in the same process that answers at once. The counters are percentiles in microseconds.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

#include "studio/gateway/gateway.h"
#include "studio/gateway/testing/browser.h"
#include "studio/gateway/testing/fake_studio.h"

namespace flair::studio::testing {
namespace {

double At(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<size_t>(share * static_cast<double>(sorted.size() - 1))];
}

void RoundTrips(benchmark::State& state, const std::string& path, const std::string& body) {
  FakeStudio studio;
  GatewayOptions options;
  options.services = {
      {.full_name = kService, .channel = studio.channel(), .methods = {}, .upload_methods = {"CreateDocument"}}};
  options.token = TestToken();
  const auto gateway = Gateway::Start(std::move(options));
  Browser browser(**gateway);
  const std::string request = browser.Post(path, body);
  std::vector<double> micros;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    const Answer answer = browser.Ask(request);
    micros.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count());
    if (answer.status != 200) return state.SkipWithError("no answer");
  }
  std::sort(micros.begin(), micros.end());
  state.counters["p50_us"] = At(micros, 0.5);
  state.counters["p95_us"] = At(micros, 0.95);
}

// A call of a hundred bytes each way; an answer of 100 kB; an upload of 3 MB.
BENCHMARK_CAPTURE(RoundTrips, Small, kGetDocument, R"({"documentId":"a"})")->UseRealTime()->MinWarmUpTime(0.2);
BENCHMARK_CAPTURE(RoundTrips, Answer100kB, kListDocuments, R"({"pageSize":100})")->UseRealTime()->MinWarmUpTime(0.2);
BENCHMARK_CAPTURE(RoundTrips, Upload3MB, kCreateDocument, R"({"file":")" + std::string(3'000'000, 'A') + "\"}")
    ->UseRealTime()
    ->MinWarmUpTime(0.2);

}  // namespace
}  // namespace flair::studio::testing
