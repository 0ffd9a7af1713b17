// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev bench translate: how well sentences become calls.
#include <cstdio>
#include <memory>
#include <optional>

#include "absl/time/clock.h"
#include "cli/bench/statistics.h"
#include "cli/bench/translate_bench.h"
#include "cli/commands/commands.h"
#include "cli/embedded/embedded_services.h"
#include "cli/input/llm_flags.h"
#include "cli/input/service_flags.h"
#include "cli/output/output_folder.h"
#include "flair/v1/translator_service.grpc.pb.h"
#include "fmt/format.h"
#include "optimizer_worker/constraints/facts.h"
#include "worker_runtime/grpc/channel.h"
#include "worker_runtime/grpc/client_call.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

constexpr absl::Duration kRoomWithin = absl::Minutes(10);

struct BenchTranslateArguments : Options {
  using Options::Options;
  std::string& labels = Required("DIR", "Folder of .jsonl labels, or one file of them");
  std::string& rooms = Text("--rooms DIR", "Folder of the recorded rooms; by default in DIR or beside it");
  bool& misses = Flag("--misses", "List every sentence of which something is not correct");
  std::string& json = Text("--json FILE", "All figures and misses, for programs");
  std::string& address = Text("--translator HOST:PORT", "Translate there, not in this process");
  LlmFlags llm{command()};
  bool& all_types = Flag("--all-types", "Offer the whole catalogue; by default only the types that labels can name");
};

// The model that the flags name; none without them, whatever $FLAIR_LLM says: the grammar is what is measured then.
absl::StatusOr<OptionalLlm> ReadModel(const BenchTranslateArguments& arguments) {
  const std::string given = arguments.llm.Given();
  if (given.empty()) return OptionalLlm();
  if (arguments.address.empty()) return ReadLlmFlags(arguments.llm);
  return absl::InvalidArgumentError(
      fmt::format("{}: not with --translator {}, which has its own model or none; name the model in its config", given,
                  arguments.address));
}

absl::StatusOr<TranslateScore> Measure(const std::vector<LabelledRoom>& rooms, const v1::ConstraintCatalog& catalog,
                                       const std::string& address, const OptionalLlm& model) {
  std::unique_ptr<EmbeddedServices> services;
  std::shared_ptr<grpc::Channel> channel;
  if (address.empty()) {
    ASSIGN_OR_RETURN(services, EmbeddedServices::StartStages(model));
    channel = services->stages().translator.channel;
  } else {
    ASSIGN_OR_RETURN(const runtime::ChannelOptions options, StageConnection());
    ASSIGN_OR_RETURN(channel, runtime::MakeChannel(address, v1::TranslatorService::service_full_name(), options));
  }
  const auto stub = v1::TranslatorService::NewStub(channel);
  size_t asked = 0;
  return MeasureTranslation(rooms, catalog, [&](const v1::TranslateRequest& request) {
    // The grammar is through with all rooms at once, a model takes its time for each.
    if (model.has_value()) fmt::print(stderr, "{} of {}: {}\n", asked + 1, rooms.size(), rooms[asked].name);
    ++asked;
    runtime::CallContext call;
    return runtime::UnaryRequest(*stub, &v1::TranslatorService::StubInterface::Translate, request, call,
                                 absl::Now() + kRoomWithin);
  });
}

absl::Status BenchTranslate(const BenchTranslateArguments& arguments) {
  ASSIGN_OR_RETURN(const TranslateLabels labels, ReadTranslateLabels(arguments.labels, arguments.rooms));
  for (const std::string& failure : labels.failures) fmt::print(stderr, "{}\n", failure);
  ASSIGN_OR_RETURN(const OptionalLlm model, ReadModel(arguments));
  const v1::ConstraintCatalog& all = optimizer::MakeCatalog();
  const double started = ProcessCpu_s();
  ASSIGN_OR_RETURN(
      const TranslateScore score,
      Measure(labels.rooms, arguments.all_types ? all : TypesOfTheReference(all), arguments.address, model));
  const double cpu_ms = 1e3 * (ProcessCpu_s() - started);
  if (arguments.misses) fmt::print("{}\n", TranslateMissesText(score));
  fmt::print("{}", TranslateScoreText(score, cpu_ms));
  std::fflush(stdout);
  if (!arguments.json.empty()) {
    RETURN_IF_ERROR(WriteOutputFile(arguments.json, TranslateScoreToJson(score, labels.failures, cpu_ms)));
  }
  if (labels.failures.empty()) return absl::OkStatus();
  return absl::InvalidArgumentError(fmt::format(
      "{} could not be measured", Counted(std::ssize(labels.failures), "line of labels", "lines of labels")));
}

}  // namespace

void AddBenchTranslate(const Commands& bench) {
  bench.Add("translate", "Translate labelled sentences of recorded rooms: correct, wrong, missed, wrongly refused.",
            BenchTranslate);
}

}  // namespace flair::cli
