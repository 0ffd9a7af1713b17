// SPDX-License-Identifier: GPL-3.0-or-later
// flair batch status, watch, pause, resume, cancel, retry, delete, report, list.
#include <algorithm>
#include <cstdio>
#include <memory>

#include "absl/strings/str_join.h"
#include "cli/batch/batch_run.h"
#include "cli/batch/collector.h"
#include "cli/commands/batch_flags.h"
#include "cli/exit_code.h"
#include "cli/input/message_text.h"
#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "orchestrator/batch/work_queue.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct ActionArguments : Options {
  using Options::Options;
  BatchPlaceFlags place{command()};
  bool& json = Flag("--json", "JSON on standard output");
};
struct NamedArguments : ActionArguments {
  using ActionArguments::ActionArguments;
  std::string& id = Required("ID", "Id of the batch, the beginning of it, or the DIR of its results");
};
struct BatchListArguments : ActionArguments {
  using ActionArguments::ActionArguments;
  int& count = Whole("-n,--count N", 1, 100000, 20, "Maximum number of batches to list, 1 to 100000 (20)");
};
struct WatchArguments : NamedArguments {
  using NamedArguments::NamedArguments;
  BatchRunFlags runs{command()};
  std::string& out = Text("-o,--out DIR", "Folder for the results (DIR, when that is ID)");
  CollectFlags collect{command()};
  bool& quiet = Flag("-q,--quiet", "Print nothing but errors");
};
struct RetryArguments : NamedArguments {
  using NamedArguments::NamedArguments;
  std::vector<std::string>& kinds = Commas(
      "--kind A,B", "Only failures of these kinds: input, language, translation, infeasible, worker, timeout, store");
  std::vector<std::string>& jobs = Commas("--job A,B", "Only these jobs: ids, or places in the batch");
};
struct DeleteArguments : NamedArguments {
  using NamedArguments::NamedArguments;
  bool& yes = Flag("-y,--yes", "Do not ask for confirmation");
};
struct ReportArguments : NamedArguments {
  using NamedArguments::NamedArguments;
  std::string& csv = Text("--csv FILE", "Also write a row for each job, with the columns of results.db");
};

void ShowBatch(const v1::Batch& batch, bool json) {
  if (json) {
    fmt::print("{}\n", ToJsonLine(batch));
    return;
  }
  const auto line = [](const char* what, const std::string& text) { fmt::print("{:<11}{}\n", what, text); };
  line("batch", batch.id());
  if (!batch.label().empty()) line("name", Printable(batch.label()));
  line("state", BatchStateWord(batch.state()) + (batch.open() ? ", and more lines may follow" : ""));
  line("jobs", std::to_string(batch.job_count()));
  line("succeeded", std::to_string(batch.succeeded_count()));
  if (batch.failed_count() > 0) line("failed", fmt::format("{}: {}", batch.failed_count(), FailuresText(batch)));
  if (batch.cancelled_count() > 0) line("cancelled", std::to_string(batch.cancelled_count()));
  if (batch.open_count() > 0) {
    line("to do", fmt::format("{}, of which {}", batch.open_count(), Counted(batch.running_count(), "runs", "run")));
  }
  line("created", LocalTimeText(batch.create_time()));
}

// What is refused because the batch was cancelled.
absl::Status InCode(const absl::Status& status) {
  return absl::IsFailedPrecondition(status) ? EndWith(kExitCancelled, std::string(status.message())) : status;
}

absl::Status ListBatches(BatchListArguments& arguments) {
  Interruption interruption;
  ASSIGN_OR_RETURN(const BatchWay way, OpenBatchWay(arguments.place, nullptr, std::nullopt, interruption));
  Session& batches = *way.session;
  ASSIGN_OR_RETURN(const std::vector<v1::Batch> all, batches.ListBatches(arguments.count));
  for (const v1::Batch& listed : all) {
    // The list itself need not have the counts.
    const absl::StatusOr<v1::Batch> counted = batches.GetBatch(listed.id());
    // Deleted just now.
    if (absl::IsNotFound(counted.status())) continue;
    if (!counted.ok()) return counted.status();
    const v1::Batch& batch = *counted;
    if (arguments.json) {
      fmt::print("{}\n", ToJsonLine(batch));
      continue;
    }
    const std::string failed = batch.failed_count() > 0 ? fmt::format("  {} failed", batch.failed_count()) : "";
    const std::string state =
        EndedCount(batch) == batch.job_count() && !batch.open() && batch.state() == v1::BATCH_STATE_ACTIVE
            ? "ended"
            : BatchStateWord(batch.state());
    fmt::print("{}  {:<9}  {}/{}{}  {}  {}\n", batch.id(), state, EndedCount(batch), batch.job_count(), failed,
               LocalTimeText(batch.create_time()), Printable(batch.label()));
  }
  if (all.empty() && !arguments.json) {
    fmt::print(stderr, "No batches yet. Try: flair batch BRIEFS.jsonl --out out/batch\n");
  }
  return absl::OkStatus();
}

absl::Status RetryBatch(const RetryArguments& arguments, const NamedBatch& named, const BatchWay& way, Interruption&) {
  v1::RetryBatchRequest request;
  request.set_batch_id(named.batch.id());
  for (const std::string& word : arguments.kinds) {
    const auto* const kind = FindWord(*v1::FailureKind_descriptor(), word);
    if (kind == nullptr) {
      return InvalidArgument("--kind: {}: no such kind of failure; expected one of {}", word,
                             absl::StrJoin(ShortWords(*v1::FailureKind_descriptor()), ", "));
    }
    request.add_kinds(static_cast<v1::FailureKind>(kind->number()));
  }
  for (const std::string& job : arguments.jobs) {
    const bool is_index = !job.empty() && job.size() < 10 && std::ranges::all_of(job, ::isdigit);
    request.add_job_ids(is_index ? orchestrator::BatchJobId(named.batch.id(), std::stoll(job)) : job);
  }
  const absl::StatusOr<v1::RetryBatchResponse> response = way.session->RetryBatch(request);
  if (!response.ok()) return InCode(response.status());
  if (arguments.json) {
    fmt::print("{}\n", ToJsonLine(*response));
    return absl::OkStatus();
  }
  const std::string name = named.folder.empty() ? named.batch.id() + " --out DIR" : named.folder.string();
  fmt::print("{} again{}\n", Counted(response->retried_count(), "job waits", "jobs wait"),
             response->retried_count() > 0 ? "; to run and collect them: flair batch watch " + name : "");
  return absl::OkStatus();
}

// The folder that a watch collects into, with what it remembers from before or is told now.
absl::StatusOr<std::unique_ptr<BatchFolder>> HoldFolder(const WatchArguments& arguments, const NamedBatch& named) {
  const std::string path = arguments.out.empty() ? named.folder.string() : arguments.out;
  if (path.empty()) return InvalidArgument("{}: names no folder to collect into; give --out DIR", arguments.id);
  absl::StatusOr<std::unique_ptr<BatchFolder>> folder = BatchFolder::Hold(path);
  if (!folder.ok()) return folder;
  ASSIGN_OR_RETURN(BatchPlace place, (*folder)->Place());
  if (place.batch_id == named.batch.id()) return folder;
  if (!place.batch_id.empty()) return FileError("{}: holds batch {}; give --out another folder", path, place.batch_id);
  ASSIGN_OR_RETURN(const KeptFiles kept, arguments.collect.Kept());
  BatchPlace made;
  made.batch_id = named.batch.id();
  made.label = named.batch.label();
  FillPlace(arguments.place, made);
  made.kept = kept.Words();
  made.shard_size = arguments.collect.shard_size;
  RETURN_IF_ERROR((*folder)->SetPlace(made));
  return folder;
}

absl::Status WatchBatch(const WatchArguments& arguments, const NamedBatch& named, const BatchWay& way,
                        Interruption& interruption) {
  ASSIGN_OR_RETURN(const std::unique_ptr<BatchFolder> folder, HoldFolder(arguments, named));
  if (named.batch.open() && !arguments.quiet) {
    fmt::print(stderr,
               "batch {}: not all lines are submitted yet; if no command is doing so, give its file again: flair batch "
               "FILE --out DIR\n",
               named.batch.id());
  }
  return RunBatch(named.batch, *way.session, *folder, nullptr, interruption,
                  {.remedy = way.remedy, .quiet = arguments.quiet, .json = arguments.json});
}

absl::Status ShowReport(ResultsFile& results, const ReportArguments& arguments) {
  if (!arguments.csv.empty()) RETURN_IF_ERROR(WriteResultsCsv(results, arguments.csv));
  ASSIGN_OR_RETURN(const BatchReport report, MakeBatchReport(results));
  if (arguments.json) {
    fmt::print("{}\n", JsonText(report, 2));
  } else if (arguments.csv != "-" && arguments.csv != "/dev/stdout") {
    fmt::print("{}", BatchReportText(report));
  }
  return absl::OkStatus();
}

// Of a batch that was never collected here: its reports are fetched, and nothing else.
absl::Status ReportOfService(const ReportArguments& arguments, const NamedBatch& named, Session& batches) {
  ASSIGN_OR_RETURN(const std::unique_ptr<ResultsFile> results, ResultsFile::OpenTemporary());
  absl::Status status = results->SetState("batch_id", named.batch.id());
  if (status.ok()) status = results->SetState("label", named.batch.label());
  if (const int64_t ended = EndedCount(named.batch); status.ok() && ended > 0) {
    const std::unique_ptr<ResultWriter> unused = MakeJobFolders("");
    const Collector::Options options{.kept = {}, .end_after = ended};
    status = Collector(batches, *results, *unused, options).Run(named.batch.id());
  }
  return status.ok() ? ShowReport(*results, arguments) : status;
}

absl::Status ReportBatch(ReportArguments& arguments) {
  if (BatchFolder::IsAt(arguments.id)) {
    ASSIGN_OR_RETURN(const std::unique_ptr<ResultsFile> results, ResultsFile::OpenToRead(ResultsPath(arguments.id)));
    return ShowReport(*results, arguments);
  }
  Interruption interruption;
  ASSIGN_OR_RETURN(const BatchWay way, OpenBatchWay(arguments.place, nullptr, std::nullopt, interruption));
  ASSIGN_OR_RETURN(const NamedBatch named, FindBatch(arguments.id, *way.session));
  return ReportOfService(arguments, named, *way.session);
}

absl::Status BatchStatus(const NamedArguments& arguments, const NamedBatch& named, const BatchWay& way, Interruption&) {
  ShowBatch(named.batch, arguments.json);
  if (arguments.json || named.batch.open_count() == 0) return absl::OkStatus();
  // For operators only; others are not told.
  const absl::StatusOr<v1::GetClusterResponse> cluster = way.session->GetCluster();
  const std::string away = cluster.ok() ? StagesAway(*cluster) : "";
  if (!away.empty()) fmt::print("{:<11}{}\n", "waits", away);
  return absl::OkStatus();
}

template <auto kChange>
absl::Status ChangeBatch(const NamedArguments& arguments, const NamedBatch& named, const BatchWay& way, Interruption&) {
  const absl::StatusOr<v1::Batch> batch = ((*way.session).*kChange)(named.batch.id());
  if (!batch.ok()) return InCode(batch.status());
  ShowBatch(*batch, arguments.json);
  return absl::OkStatus();
}

absl::Status DeleteBatch(const DeleteArguments& arguments, const NamedBatch& named, const BatchWay& way,
                         Interruption&) {
  return DeleteWholeBatch(named.batch, *way.session, {.yes = arguments.yes, .json = arguments.json});
}

// Does something with the batch that the arguments name.
template <auto kAction, typename Arguments>
absl::Status Act(Arguments& arguments) {
  RETURN_IF_ERROR(TakePlaceOf(arguments.id, arguments.place));
  const BatchRunFlags* runs = nullptr;
  OptionalLlm llm;
  if constexpr (std::is_same_v<Arguments, WatchArguments>) {
    runs = &arguments.runs;
    ASSIGN_OR_RETURN(llm, ReadDesignModel(runs->llm, {}, arguments.place.orchestrator));
  }
  Interruption interruption;
  ASSIGN_OR_RETURN(const BatchWay way, OpenBatchWay(arguments.place, runs, llm, interruption));
  ASSIGN_OR_RETURN(const NamedBatch named, FindBatch(arguments.id, *way.session));
  return kAction(arguments, named, way, interruption);
}

}  // namespace

void AddBatchActions(const Commands& batch) {
  batch.Add("status", "Show the progress of a batch.", Act<BatchStatus, NamedArguments>);
  batch.Add("watch", "Collect the results of a batch, here or on another machine, until it has ended.",
            Act<WatchBatch, WatchArguments>, "Where jobs wait in this machine's own store, watching runs them.");
  batch.Add("pause", "Start no more jobs of a batch; running ones continue.",
            Act<ChangeBatch<&Session::PauseBatch>, NamedArguments>);
  batch.Add("resume", "Resume a paused batch.", Act<ChangeBatch<&Session::ResumeBatch>, NamedArguments>);
  batch.Add("cancel", "Cancel a batch and all of its jobs.", Act<ChangeBatch<&Session::CancelBatch>, NamedArguments>);
  batch.Add("retry", "Run failed jobs of a batch again, from their stored results.", Act<RetryBatch, RetryArguments>);
  batch.Add("delete",
            "Delete a batch that has ended, its jobs, and the artifacts that no other job has; what was collected in a "
            "DIR stays.",
            Act<DeleteBatch, DeleteArguments>);
  batch.Add("report", "Show the failures, measures, times and tokens of a batch; for a DIR, without a server.",
            ReportBatch);
  batch.Add("list", "List batches, newest first.", ListBatches);
}

}  // namespace flair::cli
