// SPDX-License-Identifier: GPL-3.0-or-later
// Reading what a model wrote: answers as good models write them, as others do, and a megabyte from someone hostile.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <functional>
#include <string>

#include "flair/model/v1/calls_answers.pb.h"
#include "flair/model/v1/object_answers.pb.h"
#include "llm/answers/read_answer.h"

namespace flair::llm {
namespace {

using model::v1::CallsAnswer;
using model::v1::FloorObjectsAnswer;

constexpr size_t kMegabyte = 999'000;

FieldChoices Zones() { return {{"flair.model.v1.FloorObjectAnswer.zone", {{"sleeping", "storage", "working"}, {}}}}; }

std::string Repeated(const std::string& begin, const std::function<std::string(size_t)>& part, const std::string& end,
                     size_t least_bytes) {
  std::string text = begin;
  for (size_t i = 0; text.size() < least_bytes; ++i) text += part(i);
  return text + end;
}

// Twelve objects, with or without the schema's names.
std::string Objects(bool by_schema) {
  std::string text = by_schema ? "{\"objects\":[" : "Here you are:\n```json\n{'furniture': [ // all of it\n";
  for (int i = 0; i < 12; ++i) {
    text += by_schema
                ? fmt::format(R"({}{{"name":"dining chair {}","zone":"sleeping","primary":false,"count":2,)"
                              R"("width_m":0.45,"depth_m":0.5,"height_m":0.9,"description":"Oak, with a cushion.",)"
                              R"("requested":false}})",
                              i > 0 ? "," : "", i)
                : fmt::format(
                      "{{'Name': 'dining chair {}', 'Zone': 'Sleeping zone', 'Quantity': '2x', "
                      "'Dimensions': '45 x 50 x 90 cm', 'Notes': 'Oak, with a cushion.',}},\n",
                      i);
  }
  return text + (by_schema ? "],\"left_out\":[]}" : "]}\n```\nShall I go on?");
}

template <typename Answer>
void Read(benchmark::State& state, const std::string& text, const FieldChoices& choices) {
  for (auto _ : state) {
    Answer answer;
    benchmark::DoNotOptimize(ReadAnswer(text, choices, answer));
  }
  state.SetBytesProcessed(static_cast<int64_t>(text.size()) * state.iterations());
}

void TwelveObjects(benchmark::State& state) { Read<FloorObjectsAnswer>(state, Objects(true), Zones()); }
void TwelveObjectsInOtherWords(benchmark::State& state) { Read<FloorObjectsAnswer>(state, Objects(false), Zones()); }

void FortyLinesOfCalls(benchmark::State& state) {
  Choices ids;
  std::string text = "{\"sentences\":[";
  for (int i = 0; i < 40; ++i) {
    ids.names.push_back(fmt::format("s{}", i));
    text += fmt::format("{}\"s{}: near(bed, nightstand_1, max_distance_m=0.5); facing(bed, wardrobe)\"",
                        i > 0 ? "," : "", i);
  }
  Read<CallsAnswer>(state, text + "]}", {{"flair.model.v1.SentenceCallsAnswer.id", ids}});
}

void HostileKeys(benchmark::State& state) {
  const auto key = [](size_t i) { return fmt::format("\"k{}\":{{}},", i); };
  Read<FloorObjectsAnswer>(state, Repeated("{\"objects\":[{", key, "\"a\":1}]}", kMegabyte), Zones());
}

void HostileElements(benchmark::State& state) {
  const auto element = [](size_t) { return "{},"; };
  Read<FloorObjectsAnswer>(state, Repeated("{\"objects\":[", element, "{}]}", kMegabyte), Zones());
}

void HostileNames(benchmark::State& state) {
  const auto element = [](size_t i) { return fmt::format("\"k{}\":{{\"width_m\":1}},", i); };
  Read<FloorObjectsAnswer>(state, Repeated("{\"objects\":{", element, "\"a\":1}}", kMegabyte), Zones());
}

void HostileBrackets(benchmark::State& state) {
  const auto open = [](size_t i) { return i % 2 == 0 ? "{\"a\":[" : "[1}"; };
  Read<FloorObjectsAnswer>(state, Repeated("", open, "", kMegabyte), Zones());
}

void HostileQuotes(benchmark::State& state) {
  const auto quote = [](size_t) { return "\" x"; };
  Read<FloorObjectsAnswer>(state, Repeated("{\"objects\":\"", quote, "\"}", kMegabyte), Zones());
}

void HostileLines(benchmark::State& state) {
  const auto line = [](size_t i) { return fmt::format("s{}: near(a, b)\n", i); };
  Read<CallsAnswer>(state, Repeated("", line, "", kMegabyte), {});
}

BENCHMARK(TwelveObjects)->Unit(benchmark::kMicrosecond);
BENCHMARK(TwelveObjectsInOtherWords)->Unit(benchmark::kMicrosecond);
BENCHMARK(FortyLinesOfCalls)->Unit(benchmark::kMicrosecond);
BENCHMARK(HostileKeys)->Unit(benchmark::kMillisecond);
BENCHMARK(HostileElements)->Unit(benchmark::kMillisecond);
BENCHMARK(HostileNames)->Unit(benchmark::kMillisecond);
BENCHMARK(HostileBrackets)->Unit(benchmark::kMillisecond);
BENCHMARK(HostileQuotes)->Unit(benchmark::kMillisecond);
BENCHMARK(HostileLines)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace flair::llm
