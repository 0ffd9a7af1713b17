// SPDX-License-Identifier: GPL-3.0-or-later
// flair-dev bench translate: how well sentences become calls.
#include <cstdio>
#include <memory>
#include <optional>

#include "CLI/CLI.hpp"
#include "absl/time/clock.h"
#include "cli/bench/translate_bench.h"
#include "cli/bench/statistics.h"
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
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

constexpr absl::Duration kRoomWithin = absl::Minutes(10);

struct BenchTranslateArguments {
  std::string labels;
  std::string rooms;
  std::string json;
  std::string address;
  LlmFlags llm;
  bool misses = false;
  bool all_types = false;
};

using OptionalModel = std::optional<config::v1::LlmConfig>;

// The model that the flags name; none without them, whatever $FLAIR_LLM says: the grammar is what is measured then.
absl::StatusOr<OptionalModel> ReadModel(const BenchTranslateArguments& arguments) {
  const std::string given = arguments.llm.Given();
  if (given.empty()) return OptionalModel();
  if (arguments.address.empty()) return ReadLlmFlags(arguments.llm);
  return absl::InvalidArgumentError(
      fmt::format("{}: not with --translator {}, which has its own model or none; name the model in its config", given,
                  arguments.address));
}

absl::StatusOr<TranslateScore> Measure(const std::vector<LabelledRoom>& rooms, const v1::ConstraintCatalog& catalog,
                                       const std::string& address, const OptionalModel& model) {
  std::unique_ptr<EmbeddedServices> services;
  std::shared_ptr<grpc::Channel> channel;
  if (address.empty()) {
    absl::StatusOr<std::unique_ptr<EmbeddedServices>> started = EmbeddedServices::StartStages(model);
    if (!started.ok()) return started.status();
    services = *std::move(started);
    channel = services->stages().translator.channel;
  } else {
    const absl::StatusOr<runtime::ChannelOptions> options = StageConnection();
    if (!options.ok()) return options.status();
    absl::StatusOr<std::shared_ptr<grpc::Channel>> made =
        runtime::MakeChannel(address, v1::TranslatorService::service_full_name(), *options);
    if (!made.ok()) return made.status();
    channel = *std::move(made);
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
  const absl::StatusOr<TranslateLabels> labels = ReadTranslateLabels(arguments.labels, arguments.rooms);
  if (!labels.ok()) return labels.status();
  for (const std::string& failure : labels->failures) fmt::print(stderr, "{}\n", failure);
  const absl::StatusOr<OptionalModel> model = ReadModel(arguments);
  if (!model.ok()) return model.status();
  const v1::ConstraintCatalog& all = optimizer::MakeCatalog();
  const double started = ProcessCpu_s();
  const absl::StatusOr<TranslateScore> score =
      Measure(labels->rooms, arguments.all_types ? all : TypesOfTheReference(all), arguments.address, *model);
  if (!score.ok()) return score.status();
  const double cpu_ms = 1e3 * (ProcessCpu_s() - started);
  if (arguments.misses) fmt::print("{}\n", TranslateMissesText(*score));
  fmt::print("{}", TranslateScoreText(*score, cpu_ms));
  std::fflush(stdout);
  if (!arguments.json.empty()) {
    const absl::Status status = WriteOutputFile(arguments.json, TranslateScoreToJson(*score, labels->failures, cpu_ms));
    if (!status.ok()) return status;
  }
  if (labels->failures.empty()) return absl::OkStatus();
  return absl::InvalidArgumentError(fmt::format(
      "{} could not be measured", Counted(std::ssize(labels->failures), "line of labels", "lines of labels")));
}

}  // namespace

void AddBenchTranslate(CLI::App& program, absl::Status& result) {
  auto arguments = std::make_shared<BenchTranslateArguments>();
  CLI::App* command = program.get_subcommand("bench")->add_subcommand(
      "translate", "Translate labelled sentences of recorded rooms: correct, wrong, missed, wrongly refused.");
  command->add_option("DIR", arguments->labels, "Folder of .jsonl labels, or one file of them")->required();
  command->add_option("--rooms", arguments->rooms, "Folder of the recorded rooms; by default in DIR or beside it")
      ->type_name("DIR");
  command->add_flag("--misses", arguments->misses, "List every sentence of which something is not correct");
  command->add_option("--json", arguments->json, "All figures and misses, for programs")->type_name("FILE");
  command->add_option("--translator", arguments->address, "Translate there, not in this process")
      ->type_name("HOST:PORT");
  AddLlmFlags(*command, arguments->llm);
  command->add_flag("--all-types", arguments->all_types,
                    "Offer the whole catalogue; by default only the types that labels can name");
  command->callback([arguments, &result] { result = BenchTranslate(*arguments); });
}

}  // namespace flair::cli
