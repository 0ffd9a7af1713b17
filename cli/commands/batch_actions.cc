// SPDX-License-Identifier: GPL-3.0-or-later
// flair batch status, watch, pause, resume, cancel, retry, delete, report, list.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>

#include "absl/strings/str_join.h"
#include "cli/batch/batch_monitor.h"
#include "cli/batch/batch_run.h"
#include "cli/batch/collector.h"
#include "cli/batch/kept_files.h"
#include "cli/commands/batch_flags.h"
#include "cli/exit_code.h"
#include "cli/input/command_line.h"
#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "orchestrator/batch/work_queue.h"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

struct ActionArguments {
  std::string id;
  BatchFlags flags;
  // watch
  std::string out;
  std::string kept = KeptFiles::kDefault;
  int shard_size = 0;
  bool quiet = false;
  // retry
  std::vector<std::string> kinds;
  std::vector<std::string> jobs;
  // report
  std::string csv;
  // delete
  bool yes = false;
  // list
  int count = 20;
  bool json = false;
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

absl::Status ShowOr(const absl::StatusOr<v1::Batch>& batch, bool json) {
  if (!batch.ok()) return InCode(batch.status());
  ShowBatch(*batch, json);
  return absl::OkStatus();
}

absl::Status List(const ActionArguments& arguments, BatchSession& batches) {
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

absl::Status Retry(const ActionArguments& arguments, const NamedBatch& named, BatchSession& batches) {
  v1::RetryBatchRequest request;
  request.set_batch_id(named.batch.id());
  for (const std::string& word : arguments.kinds) {
    const v1::FailureKind kind = FailureKindOf(word);
    if (kind == v1::FAILURE_KIND_UNSPECIFIED) {
      return absl::InvalidArgumentError(fmt::format("--kind: {}: there is no such kind of failure; one of {}", word,
                                                    absl::StrJoin(FailureKindWords(), ", ")));
    }
    request.add_kinds(kind);
  }
  for (const std::string& job : arguments.jobs) {
    const bool is_index = !job.empty() && job.size() < 10 && std::ranges::all_of(job, ::isdigit);
    request.add_job_ids(is_index ? orchestrator::BatchJobId(named.batch.id(), std::stoll(job)) : job);
  }
  const absl::StatusOr<v1::RetryBatchResponse> response = batches.RetryBatch(request);
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
absl::StatusOr<std::unique_ptr<BatchFolder>> HoldFolder(const ActionArguments& arguments, const NamedBatch& named) {
  const std::string path = arguments.out.empty() ? named.folder.string() : arguments.out;
  if (path.empty()) {
    return absl::InvalidArgumentError(fmt::format("{}: says no folder to collect into; give --out DIR", arguments.id));
  }
  absl::StatusOr<std::unique_ptr<BatchFolder>> folder = BatchFolder::Hold(path);
  if (!folder.ok()) return folder;
  ASSIGN_OR_RETURN(BatchPlace place, (*folder)->Place());
  if (place.batch_id == named.batch.id()) return folder;
  if (!place.batch_id.empty()) {
    return FileError(fmt::format("{}: holds batch {}; give --out another folder", path, place.batch_id));
  }
  ASSIGN_OR_RETURN(const KeptFiles kept, KeptFiles::Parse(arguments.kept));
  BatchPlace made;
  made.batch_id = named.batch.id();
  made.label = named.batch.label();
  FillPlace(arguments.flags, made);
  made.kept = kept.Words();
  made.shard_size = arguments.shard_size;
  RETURN_IF_ERROR((*folder)->SetPlace(made));
  return folder;
}

absl::Status Watch(const ActionArguments& arguments, const NamedBatch& named, const BatchWay& way,
                   Interruption& interruption) {
  ASSIGN_OR_RETURN(const std::unique_ptr<BatchFolder> folder, HoldFolder(arguments, named));
  if (named.batch.open() && !arguments.quiet) {
    fmt::print(stderr,
               "batch {}: not all lines are submitted yet; if nobody does, give its file again: flair batch FILE "
               "--out DIR\n",
               named.batch.id());
  }
  return RunBatch(named.batch, *way.batches, *folder, nullptr, interruption,
                  {.remedy = way.remedy, .quiet = arguments.quiet, .json = arguments.json});
}

absl::Status ShowReport(ResultsFile& results, const ActionArguments& arguments) {
  if (!arguments.csv.empty()) {
    RETURN_IF_ERROR(WriteResultsCsv(results, arguments.csv));
  }
  ASSIGN_OR_RETURN(const BatchReport report, MakeBatchReport(results));
  if (arguments.json) {
    fmt::print("{}\n", BatchReportJson(report).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else if (arguments.csv != "-" && arguments.csv != "/dev/stdout") {
    fmt::print("{}", BatchReportText(report));
  }
  return absl::OkStatus();
}

// Of a batch that was never collected here: its reports are fetched, and nothing else.
absl::Status ReportOfService(const ActionArguments& arguments, const NamedBatch& named, BatchSession& batches) {
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

absl::Status Report(const ActionArguments& arguments) {
  if (BatchFolder::IsAt(arguments.id)) {
    const absl::StatusOr<std::unique_ptr<ResultsFile>> results = ResultsFile::OpenToRead(ResultsPath(arguments.id));
    return results.ok() ? ShowReport(**results, arguments) : results.status();
  }
  Interruption interruption;
  ASSIGN_OR_RETURN(const BatchWay way, OpenBatchWay(arguments.flags, false, std::nullopt, interruption));
  const absl::StatusOr<NamedBatch> named = FindBatch(arguments.id, *way.batches);
  return named.ok() ? ReportOfService(arguments, *named, *way.batches) : named.status();
}

// Does something with the batch that the arguments name.
using BatchAction =
    std::function<absl::Status(const ActionArguments&, const NamedBatch&, const BatchWay&, Interruption&)>;

absl::Status Act(ActionArguments& arguments, bool runs_jobs, const BatchAction& action) {
  RETURN_IF_ERROR(TakePlaceOf(arguments.id, arguments.flags));
  const absl::StatusOr<OptionalLlm> llm =
      runs_jobs ? ReadDesignModel(arguments.flags.llm, {}, arguments.flags.orchestrator) : OptionalLlm();
  if (!llm.ok()) return llm.status();
  Interruption interruption;
  ASSIGN_OR_RETURN(const BatchWay way, OpenBatchWay(arguments.flags, runs_jobs, *llm, interruption));
  const absl::StatusOr<NamedBatch> named = FindBatch(arguments.id, *way.batches);
  return named.ok() ? action(arguments, *named, way, interruption) : named.status();
}

// A subcommand with the flags that all have.
struct Added {
  CLI::App* command;
  std::shared_ptr<ActionArguments> arguments;
};
Added Add(CLI::App& batch, const std::string& name, const std::string& help, bool takes_id, bool runs_jobs) {
  Added added{batch.add_subcommand(name, help), std::make_shared<ActionArguments>()};
  if (takes_id) {
    added.command
        ->add_option("ID", added.arguments->id, "Id of the batch, the beginning of it, or the DIR of its results")
        ->required();
  }
  AddBatchFlags(*added.command, added.arguments->flags, runs_jobs);
  added.command->add_flag("--json", added.arguments->json, "JSON on standard output");
  return added;
}

void OnCall(const Added& added, absl::Status& result, bool runs_jobs, const BatchAction& action) {
  added.command->callback([arguments = added.arguments, &result, runs_jobs, action] {
    result = Act(*arguments, runs_jobs, action);
    std::fflush(stdout);
  });
}

void AddStateChange(CLI::App& batch, absl::Status& result, const char* name, const char* help,
                    absl::StatusOr<v1::Batch> (BatchSession::*change)(const std::string&)) {
  OnCall(Add(batch, name, help, true, false), result, false,
         [change](const ActionArguments& arguments, const NamedBatch& named, const BatchWay& way, Interruption&) {
           return ShowOr(((*way.batches).*change)(named.batch.id()), arguments.json);
         });
}

void AddWatch(CLI::App& batch, absl::Status& result) {
  const Added watch = Add(
      batch, "watch", "Collect the results of a batch, here or on another machine, until it has ended.", true, true);
  watch.command->add_option("-o,--out", watch.arguments->out, "Folder for the results (DIR, when that is ID)")
      ->type_name("DIR");
  watch.command
      ->add_option("--keep", watch.arguments->kept,
                   "Files of each job, see flair batch --help (layout,pictures,report)")
      ->type_name("A,B");
  watch.command
      ->add_option("--shards", watch.arguments->shard_size,
                   "Tar files of so many jobs, 1 to 1000000, instead of a folder for each job")
      ->type_name("JOBS")
      ->check(WholeNumber(1, 1000000));
  watch.command->add_flag("-q,--quiet", watch.arguments->quiet, "Print nothing unless something goes wrong");
  watch.command->footer("Where jobs wait in this machine's own store, watching runs them.");
  OnCall(watch, result, true, Watch);
}

void AddRetry(CLI::App& batch, absl::Status& result) {
  const Added retry =
      Add(batch, "retry", "Run failed jobs of a batch again, from the results that they have.", true, false);
  retry.command
      ->add_option("--kind", retry.arguments->kinds,
                   "Only failures of this kind: input, language, translation, infeasible, worker, timeout, store")
      ->type_name("A,B")
      ->delimiter(',')
      ->allow_extra_args(false);
  retry.command->add_option("--job", retry.arguments->jobs, "Only these jobs: ids, or places in the batch")
      ->type_name("A,B")
      ->delimiter(',')
      ->allow_extra_args(false);
  OnCall(retry, result, false,
         [](const ActionArguments& arguments, const NamedBatch& named, const BatchWay& way, Interruption&) {
           return Retry(arguments, named, *way.batches);
         });
}

void AddDelete(CLI::App& batch, absl::Status& result) {
  const Added deletion =
      Add(batch, "delete",
          "Delete a batch that has ended, its jobs, and the artifacts that no other job has; what was "
          "collected in a DIR stays.",
          true, false);
  deletion.command->add_flag("-y,--yes", deletion.arguments->yes, "Do not ask");
  OnCall(deletion, result, false,
         [](const ActionArguments& arguments, const NamedBatch& named, const BatchWay& way, Interruption&) {
           return DeleteWholeBatch(named.batch, *way.batches, {.yes = arguments.yes, .json = arguments.json});
         });
}

void AddReport(CLI::App& batch, absl::Status& result) {
  const Added report =
      Add(batch, "report", "Failures, measures, times and tokens of a batch; of a DIR without asking anybody.", true,
          false);
  report.command
      ->add_option("--csv", report.arguments->csv, "Also write a row for each job, with the columns of results.db")
      ->type_name("FILE");
  report.command->callback([arguments = report.arguments, &result] {
    result = Report(*arguments);
    std::fflush(stdout);
  });
}

void AddList(CLI::App& batch, absl::Status& result) {
  const Added list = Add(batch, "list", "Batches, newest first.", false, false);
  list.command->add_option("-n,--count", list.arguments->count, "Most batches to list, 1 to 100000 (20)")
      ->type_name("N")
      ->check(WholeNumber(1, 100000));
  list.command->callback([arguments = list.arguments, &result] {
    Interruption interruption;
    const absl::StatusOr<BatchWay> way = OpenBatchWay(arguments->flags, false, std::nullopt, interruption);
    result = way.ok() ? List(*arguments, *way->batches) : way.status();
    std::fflush(stdout);
  });
}

}  // namespace

void AddBatchActions(CLI::App& batch, absl::Status& result) {
  OnCall(Add(batch, "status", "Show the progress of a batch.", true, false), result, false,
         [](const ActionArguments& arguments, const NamedBatch& named, const BatchWay&, Interruption&) {
           ShowBatch(named.batch, arguments.json);
           return absl::OkStatus();
         });
  AddWatch(batch, result);
  AddStateChange(batch, result, "pause", "Start no more jobs of a batch; running ones continue.",
                 &BatchSession::PauseBatch);
  AddStateChange(batch, result, "resume", "Resume a paused batch.", &BatchSession::ResumeBatch);
  AddStateChange(batch, result, "cancel", "Cancel a batch and all of its jobs.", &BatchSession::CancelBatch);
  AddRetry(batch, result);
  AddDelete(batch, result);
  AddReport(batch, result);
  AddList(batch, result);
}

}  // namespace flair::cli
