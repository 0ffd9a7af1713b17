// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands/batch_flags.h"

#include <vector>

#include "fmt/format.h"
#include "orchestrator/batch/job_rules.h"
#include "orchestrator/jetstream/open.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

constexpr int kSearchedBatches = 10000;

// For people and files: without a user, password or token that an address may hold.
std::string ShownEngine(const BatchPlaceFlags& flags) {
  config::v1::QueueConfig queue;
  queue.set_address(flags.engine.address);
  return orchestrator::ShownAddress(queue);
}

std::string RemedyOf(const BatchPlaceFlags& flags, const BatchRunFlags* runs) {
  if (runs == nullptr) return "";
  if (!flags.orchestrator.empty()) {
    return fmt::format("start flair-orchestrator on the queue of {}, without takes_no_jobs", flags.orchestrator);
  }
  if (flags.engine.address.empty() || runs->parallel.has_value()) return "";
  return fmt::format(
      "start flair-orchestrator with queue {{ address: \"{}\" }} in its config, or give --parallel N to run jobs here",
      ShownEngine(flags));
}

}  // namespace

absl::StatusOr<BatchWay> OpenBatchWay(const BatchPlaceFlags& flags, const BatchRunFlags* runs, const OptionalLlm& llm,
                                      Interruption& interruption) {
  RETURN_IF_ERROR(CheckEngineFlags(flags.engine, flags.orchestrator));
  const std::optional<int> parallel = runs == nullptr ? std::nullopt : runs->parallel;
  if (parallel.has_value() && !flags.orchestrator.empty()) {
    return InvalidArgument(
        "--parallel {}: not with --orchestrator {}, whose config says how many jobs it runs: "
        "running_job_limit",
        *parallel, flags.orchestrator);
  }
  config::v1::OrchestratorConfig config;
  SetEngine(flags.engine, config);
  if (!flags.engine.address.empty()) {
    orchestrator::UseNats({orchestrator::OpenJetStreamQueue, orchestrator::OpenJetStreamArtifacts});
    ASSIGN_OR_RETURN(const runtime::ChannelOptions connection, StageConnection());
    if (connection.tls.has_value()) *config.mutable_runtime()->mutable_tls() = *connection.tls;
  }
  config.set_store_path(flags.store);
  config.set_running_job_limit(parallel.value_or(0));
  config.set_takes_no_jobs(runs == nullptr || (!flags.engine.address.empty() && !parallel.has_value()));
  BatchWay way;
  ASSIGN_OR_RETURN(way.session, Session::Open(flags.orchestrator, llm,
                                              runs == nullptr ? StageChoice() : StageChoice(runs->stages), config));
  way.session->SetLimits(
      {.patience = absl::Minutes(2), .answer_within = absl::Minutes(1), .stop = &interruption.stop()});
  way.remedy = RemedyOf(flags, runs);
  return way;
}

void FillPlace(const BatchPlaceFlags& flags, BatchPlace& place) {
  place.orchestrator = flags.orchestrator;
  place.engine = ShownEngine(flags);
  place.queue = flags.engine.queue;
  place.artifacts = flags.engine.artifacts;
  const bool local = place.orchestrator.empty() && place.engine.empty();
  const std::string store = flags.store.empty() ? DefaultStorePath() : flags.store;
  place.store = local ? std::filesystem::absolute(store).string() : "";
}

absl::Status TakePlaceOf(const std::string& name, BatchPlaceFlags& flags) {
  if (!BatchFolder::IsAt(name) || !flags.orchestrator.empty() || !flags.engine.address.empty()) return absl::OkStatus();
  ASSIGN_OR_RETURN(const BatchPlace place, BatchFolder::ReadPlace(name));
  flags.orchestrator = place.orchestrator;
  flags.store = place.store;
  flags.engine.address = place.engine;
  if (flags.engine.queue.empty()) flags.engine.queue = place.queue;
  if (flags.engine.artifacts.empty()) flags.engine.artifacts = place.artifacts;
  return absl::OkStatus();
}

absl::StatusOr<NamedBatch> FindBatch(const std::string& name, Session& session) {
  NamedBatch found;
  std::string id = name;
  if (BatchFolder::IsAt(name)) {
    ASSIGN_OR_RETURN(const BatchPlace place, BatchFolder::ReadPlace(name));
    id = place.batch_id;
    found.folder = name;
  }
  absl::StatusOr<v1::Batch> exact = session.GetBatch(id);
  if (exact.ok()) found.batch = *std::move(exact);
  if (exact.ok()) return found;
  if (!absl::IsNotFound(exact.status()) && !absl::IsInvalidArgument(exact.status())) return exact.status();
  if (!found.folder.empty()) {
    return NotFound("{}: its batch {} is unknown to {}; say where it is with --orchestrator or --engine", name, id,
                    session.address());
  }
  ASSIGN_OR_RETURN(const std::vector<v1::Batch> all, session.ListBatches(kSearchedBatches));
  std::vector<v1::Batch> fitting;
  for (const v1::Batch& batch : all) {
    if (!name.empty() && batch.id().starts_with(name)) fitting.push_back(batch);
  }
  if (fitting.size() == 1) {
    // The list need not have the counts.
    ASSIGN_OR_RETURN(found.batch, session.GetBatch(fitting.front().id()));
    return found;
  }
  if (fitting.empty()) {
    return NotFound(
        "{}: no batch has an id that begins like this, and no folder of that name has results.db; flair "
        "batch list shows all",
        name);
  }
  return InvalidArgument("{}: {} batches have ids that begin like this, such as {} and {}; give more characters", name,
                         fitting.size(), fitting[0].id(), fitting[1].id());
}

}  // namespace flair::cli
