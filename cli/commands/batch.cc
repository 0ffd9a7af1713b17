// SPDX-License-Identifier: GPL-3.0-or-later
// flair batch: many briefs, started, watched and collected.
#include <unistd.h>

#include <cstdio>
#include <vector>

#include "cli/batch/batch_input.h"
#include "cli/batch/batch_run.h"
#include "cli/batch/collector.h"
#include "cli/commands/batch_flags.h"
#include "cli/commands/commands.h"
#include "cli/exit_code.h"
#include "cli/input/job_options.h"
#include "fmt/format.h"
#include "orchestrator/batch/job_rules.h"
#include "orchestrator/jetstream/open.h"
#include "room/validation/validate.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

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

// What lines take that do not say otherwise.
struct LineFlags : JobFlags {
  explicit LineFlags(CLI::App& command)
      : JobFlags(command,
                 {{"brief.seed", "Random seed for lines without one (0)"},
                  {"renderer.size", "Longer side of the pictures in pixels, 256 to 8192 (plan 1600, views 1024)"},
                  {"optimizer.variants", "Number of visibly different layouts, 1 to 32 (1)"},
                  {"optimizer.restarts"},
                  {"optimizer.threads", "Threads of each solve, 1 to 256 (1); changes no result"}},
                 "Defaults for lines that do not set them") {}
  int& seed_count = Whole("--seeds COUNT", 1, 500, 1, "Jobs per line, with its seed N, N + 1, ..., 1 to 500 (1)");
  std::vector<std::string>& views =
      Commas("--view A,B", "Pictures: plan, birdseye, perspective, separated by commas (plan)");
  bool& no_completion =
      Flag("--no-completion", "Do not add relations that follow from use, such as a chair drawn up to its desk");
  std::vector<std::string>& options =
      List("--set NAME=VALUE", "Any other option, as for flair replay: optimizer.path_width=0.7");
};

struct BatchArguments : Options {
  using Options::Options;
  std::string& briefs = Text("BRIEFS FILE", "A file with one brief per line, or - for standard input");
  std::string& out = Text("-o,--out DIR", "Folder for the results; created if missing");
  CollectFlags collect{command()};
  std::string& name = Text("--name NAME", "Name of the batch (the file's name); another name makes another batch");
  bool& submit_only = Flag("--submit-only", "Submit the lines and do not wait for results");
  LineFlags lines{command()};
  BatchPlaceFlags place{command()};
  BatchRunFlags runs{command()};
  ModelFlags model{command()};
  bool& json = Flag("--json", "The summary as JSON on standard output");
  bool& quiet = Flag("-q,--quiet", "Print nothing but errors");
};

absl::StatusOr<v1::JobSpec> MakeDefaults(const BatchArguments& arguments) {
  v1::JobSpec spec;
  // Many jobs at once use the cores better than many threads of one.
  spec.mutable_solve_options()->set_thread_count(1);
  spec.mutable_model_options();
  spec.set_no_completion(arguments.lines.no_completion);
  RETURN_IF_ERROR(arguments.lines.Set(spec));
  RETURN_IF_ERROR(arguments.model.Set(spec));
  for (const std::string& option : arguments.lines.options) RETURN_IF_ERROR(SetOption(option, spec).status());
  std::vector<v1::RenderOptions> views;
  for (const std::string& name : arguments.lines.views) {
    ASSIGN_OR_RETURN(const v1::PreviewView view, ViewOfName(name));
    views.push_back(spec.render_options());
    views.back().set_view(view);
  }
  SetViews(views, spec);
  v1::JobSpec example = spec;
  example.mutable_brief()->set_text("A room.");
  RETURN_IF_ERROR(Validate(example));
  return spec;
}

// Whether the folder is free for this request: new, or of the same one.
absl::Status CheckFolder(BatchFolder& folder, const std::string& request_id) {
  ASSIGN_OR_RETURN(const BatchPlace place, folder.Place());
  ASSIGN_OR_RETURN(const std::string known, folder.results().State("request_id"));
  if (place.batch_id.empty() || known == request_id) return absl::OkStatus();
  if (known.empty()) {
    return FileError("{}: collects batch {}, which was submitted elsewhere; give --out another folder",
                     folder.path().string(), place.batch_id);
  }
  return FileError("{}: holds batch {} of other briefs or options; give --out another folder, or what it was made with",
                   folder.path().string(), place.batch_id);
}

absl::Status RememberPlace(const BatchArguments& arguments, const v1::Batch& batch, const std::string& kept,
                           BatchFolder& folder) {
  ASSIGN_OR_RETURN(const BatchPlace before, folder.Place());
  if (!before.batch_id.empty() && before.batch_id != batch.id()) {
    return FileError(
        "{}: holds batch {}, but here these briefs are batch {}; give the same --orchestrator, --engine or "
        "FLAIR_HOME as before, or another folder to --out",
        folder.path().string(), before.batch_id, batch.id());
  }
  BatchPlace place;
  place.batch_id = batch.id();
  place.label = batch.label();
  FillPlace(arguments.place, place);
  place.kept = kept;
  place.shard_size = arguments.collect.shard_size;
  return folder.SetPlace(place);
}

absl::Status Submit(const BatchArguments& arguments) {
  for (const auto& [name, value] :
       {std::pair("BRIEFS, or one of the subcommands", &arguments.briefs), std::pair("--out", &arguments.out)}) {
    if (!value->empty()) continue;
    return InvalidArgument("{}: missing; flair batch --help says more", name);
  }
  ASSIGN_OR_RETURN(const v1::JobSpec defaults, MakeDefaults(arguments));
  ASSIGN_OR_RETURN(const KeptFiles kept, arguments.collect.Kept());
  const std::string& orchestrator = arguments.place.orchestrator;
  RETURN_IF_ERROR(CheckStageFlags(arguments.runs.stages, orchestrator, arguments.runs.llm));
  ASSIGN_OR_RETURN(const OptionalLlm llm, ReadDesignModel(arguments.runs.llm, defaults.model_options(), orchestrator));
  Interruption interruption;
  // A name of its own: another process may be reading its copy.
  const std::filesystem::path copy = std::filesystem::path(arguments.out) / fmt::format("input-{}.jsonl", ::getpid());
  ASSIGN_OR_RETURN(const BatchInput input, OpenBatchInput(arguments.briefs, copy, interruption.stop()));
  ASSIGN_OR_RETURN(const std::unique_ptr<BatchFolder> folder, BatchFolder::Hold(arguments.out));
  const std::string label = arguments.name.empty() ? input.name : arguments.name;
  Submission::Options options{.defaults = defaults, .seed_count = arguments.lines.seed_count, .folder = folder->path()};
  const std::string request_id = Submission::RequestId(input, options, arguments.name);
  RETURN_IF_ERROR(CheckFolder(*folder, request_id));
  ASSIGN_OR_RETURN(BatchWay way,
                   OpenBatchWay(arguments.place, arguments.submit_only ? nullptr : &arguments.runs, llm, interruption));
  ASSIGN_OR_RETURN(const v1::Batch batch, way.session->CreateBatch(request_id, label));
  if (batch.state() == v1::BATCH_STATE_CANCELLED) {
    return EndWith(
        kExitCancelled,
        fmt::format("these briefs are batch {}, which was cancelled; to run them anyway, give another --name",
                    batch.id()));
  }
  RETURN_IF_ERROR(RememberPlace(arguments, batch, kept.Words(), *folder));
  RETURN_IF_ERROR(folder->results().SetState("request_id", request_id));
  if (!arguments.quiet) {
    fmt::print(stderr, "batch {}{}\n", batch.id(), batch.job_count() > 0 ? ", which exists and continues" : "");
  }
  Submission submission(*way.session, folder->results(), input, options);
  const absl::Status status = RunBatch(
      batch, *way.session, *folder, &submission, interruption,
      {.remedy = way.remedy, .submit_only = arguments.submit_only, .quiet = arguments.quiet, .json = arguments.json});
  std::error_code ignored;
  std::filesystem::remove(copy, ignored);  // of standard input, which is given again where it is needed again
  if (status.ok() && arguments.submit_only && !arguments.quiet) {
    fmt::print(stderr, "{} submitted, {} rejected; to collect: flair batch watch {}\n",
               Counted(submission.submitted_count(), "job"), Counted(submission.rejected_count(), "line"),
               arguments.out);
  }
  return status;
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
  way.session->SetLimits({.patience = absl::Minutes(2),
                          .outage = absl::Hours(24),
                          .answer_within = absl::Minutes(1),
                          .stop = &interruption.stop()});
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

void AddBatch(const Commands& program) {
  const Commands batch = program.Add(
      "batch", "Design rooms from a file of briefs, on one machine or many.", Submit,
      "A line is a sentence, or a JSON object with the fields of a Brief and id, variants, views, solve, "
      "render, models:\n"
      "    A bedroom that is 4m x 5m.\n"
      "    {\"id\": \"k17\", \"text\": \"A small kitchen.\", \"views\": [\"plan\", \"birdseye\"]}\n"
      "DIR gets a folder for each job under jobs/ (or shards/), results.db with a row for each job, and rejected.jsonl "
      "with the invalid lines. After ^C or a crash the same command continues where "
      "it stopped; the same file with the same options is the same batch. ID is the batch's id, the beginning "
      "of it, or DIR. See docs/batches.md.");
  AddBatchActions(batch);
}

}  // namespace flair::cli
