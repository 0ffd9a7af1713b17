// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/batch_run.h"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <memory>

#include "cli/batch/collector.h"
#include "cli/exit_code.h"
#include "cli/output/artifact_text.h"
#include "cli/output/text.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/status/status_macros.h"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

// Where the handler writes; signals know of no object.
std::atomic<int> signal_pipe = -1;
std::atomic<int> signal_count = 0;

constexpr char kSignal = 's';
constexpr char kEnd = 'e';

void OnSignal(int) {
  if (signal_count.fetch_add(1) > 0) ::_exit(kExitStopped);
  const ssize_t ignored = ::write(signal_pipe, &kSignal, 1);
  (void)ignored;
}

void SetHandler(void (*handler)(int)) {
  struct sigaction action = {};
  action.sa_handler = handler;
  ::sigaction(SIGINT, &action, nullptr);
  ::sigaction(SIGTERM, &action, nullptr);
}

// Rows that may wait for the files of others.
constexpr size_t kHeldRows = 2048;

absl::Status Collect(Session& session, BatchFolder& folder, const std::string& batch_id) {
  ASSIGN_OR_RETURN(const BatchPlace place, folder.Place());
  ASSIGN_OR_RETURN(KeptFiles kept, KeptFiles::Parse(place.kept));
  const auto shard_size = static_cast<size_t>(place.shard_size);
  std::unique_ptr<ResultWriter> writer = MakeJobFolders(folder.path());
  if (shard_size > 0) {
    ASSIGN_OR_RETURN(writer, MakeTarShards(folder.path(), place.shard_size));
  }
  // Shards are for those who train on them: no failures there.
  const Collector::Options options{
      .kept = std::move(kept), .keep_failed = shard_size == 0, .held_limit = kHeldRows + shard_size, .end_after = {}};
  return Collector(session, folder.results(), *writer, options).Run(batch_id);
}

// The submission in a thread of its own; when it fails, everything stops.
class SubmittingThread {
 public:
  SubmittingThread(Submission* submission, const v1::Batch& batch, Interruption& interruption) {
    if (submission == nullptr) return;
    running_ = true;
    thread_ = std::thread([this, submission, &batch, &interruption] {
      status_ = submission->Run(batch);
      running_ = false;
      if (!status_.ok()) interruption.stop().Cancel();
    });
  }
  ~SubmittingThread() { (void)End(); }
  bool running() const { return running_; }
  absl::Status End() {
    if (thread_.joinable()) thread_.join();
    return status_;
  }

 private:
  std::atomic<bool> running_ = false;
  absl::Status status_;
  std::thread thread_;
};

absl::Status GoesOn(const BatchFolder& folder, const v1::Batch& batch, bool with_file) {
  const std::string how =
      with_file ? "give the same command again" : fmt::format("flair batch watch {}", folder.path().string());
  return EndWith(kExitStopped, "stopped; batch {} continues where it was: {}", batch.id(), how);
}

absl::Status Summarize(Session& session, const v1::Batch& batch, BatchFolder& folder, const BatchRunOptions& options) {
  ASSIGN_OR_RETURN(const BatchReport report, MakeBatchReport(folder.results()));
  if (options.json) {
    fmt::print("{}\n", JsonText(report));
  } else if (!options.quiet) {
    fmt::print(stderr, "{}", BatchOutcomeText(report));
  }
  const absl::StatusOr<v1::Batch> now = session.GetBatch(batch.id());
  if (now.ok() && now->state() == v1::BATCH_STATE_CANCELLED) {
    return EndWith(kExitCancelled, "batch {} was cancelled", batch.id());
  }
  return EndOf(report, folder.path().string());
}

std::string NameOfBatch(const v1::Batch& batch) {
  return batch.label().empty() ? batch.id() : fmt::format("{} ({})", batch.id(), Printable(batch.label()));
}

absl::Status Confirm(const v1::Batch& batch) {
  if (::isatty(STDIN_FILENO) == 0 || ::isatty(STDERR_FILENO) == 0) {
    return InvalidArgument(
        "--yes: missing; this deletes {} of batch {} for good, and there is no terminal to confirm it",
        Counted(batch.job_count(), "job"), batch.id());
  }
  fmt::print(stderr, "Delete batch {} with {} and the artifacts that no other job has? This cannot be undone. [y/N] ",
             NameOfBatch(batch), Counted(batch.job_count(), "job"));
  std::string answer;
  std::getline(std::cin, answer);
  if (answer == "y" || answer == "Y" || answer == "yes") return absl::OkStatus();
  return EndWith(kExitStopped, "nothing was deleted");
}

}  // namespace

Interruption::Interruption() {
  if (::pipe2(pipe_, O_CLOEXEC) != 0) return;  // then signals end the process as they always do
  signal_pipe = pipe_[1];
  signal_count = 0;
  thread_ = std::thread([this] {
    char read = kEnd;
    while (::read(pipe_[0], &read, 1) < 0) {
    }
    if (read != kSignal) return;
    by_signal_ = true;
    stop_.Cancel();
  });
  SetHandler(OnSignal);
}

Interruption::~Interruption() {
  if (!thread_.joinable()) return;
  SetHandler(SIG_DFL);
  const ssize_t ignored = ::write(pipe_[1], &kEnd, 1);
  (void)ignored;
  thread_.join();
  ::close(pipe_[0]);
  ::close(pipe_[1]);
}

absl::Status EndOf(const BatchReport& report, const std::string& name) {
  const auto count = [&report](const char* field) { return CountIn(report, field); };
  if (count("failed_count") > 0) {
    return EndWith(kExitSomeFailed, "{} of {} failed; more: flair batch report {}; again: flair batch retry {}",
                   count("failed_count"), Counted(count("job_count"), "job"), name, name);
  }
  if (count("not_fetched_count") > 0) {
    return EndWith(kExitSomeFailed, "the results of {} could not be fetched; again: flair batch watch {}",
                   Counted(count("not_fetched_count"), "job"), name);
  }
  if (count("rejected_count") > 0) {
    return EndWith(kExitSomeFailed, "{} rejected; {}/rejected.jsonl says why",
                   Counted(count("rejected_count"), "line was", "lines were"), name);
  }
  if (count("cancelled_count") > 0) {
    return EndWith(kExitSomeFailed, Counted(count("cancelled_count"), "job was cancelled", "jobs were cancelled"));
  }
  return absl::OkStatus();
}

absl::Status RunBatch(const v1::Batch& batch, Session& session, BatchFolder& folder, Submission* submission,
                      Interruption& interruption, const BatchRunOptions& options) {
  absl::Status collected;
  absl::Status submitted;
  {
    SubmittingThread submitting(submission, batch, interruption);
    const BatchMonitor monitor(
        session, batch.id(),
        {.quiet = options.quiet || options.json, .remedy = options.remedy, .complete = [&](BatchStanding& standing) {
           standing.submitting = submitting.running();
           if (submission != nullptr) standing.rejected_count = submission->rejected_count();
         }});
    if (!options.submit_only) {
      collected = Collect(session, folder, batch.id());
      if (!collected.ok()) interruption.stop().Cancel();
    }
    submitted = submitting.End();
  }
  if (interruption.by_signal()) return GoesOn(folder, batch, submission != nullptr);
  // What went wrong first stopped the other one.
  if (!submitted.ok() && !absl::IsCancelled(submitted)) return submitted;
  if (!collected.ok()) return collected;
  if (options.submit_only) return absl::OkStatus();
  return Summarize(session, batch, folder, options);
}

absl::Status CheckHasEnded(const v1::Batch& batch) {
  if (!batch.open() && batch.open_count() == 0) return absl::OkStatus();
  const std::string why = batch.open_count() > 0 ? Counted(batch.open_count(), "of its jobs is waiting or running",
                                                           "of its jobs are waiting or running")
                                                 : "lines may still be added to it";
  return EndWith(kExitBadInput, "batch {} has not ended: {}; end it first: flair batch cancel {}", batch.id(), why,
                 batch.id());
}

absl::Status DeleteWholeBatch(const v1::Batch& batch, Session& batches, const DeletionOptions& options) {
  RETURN_IF_ERROR(CheckHasEnded(batch));
  RETURN_IF_ERROR(options.yes ? absl::OkStatus() : Confirm(batch));
  v1::DeleteBatchResponse all;
  {
    SlowNote note("deleting");
    while (!all.done()) {
      const absl::StatusOr<v1::DeleteBatchResponse> some = batches.DeleteBatch(batch.id());
      // Somebody else was faster with the rest of it.
      if (absl::IsNotFound(some.status()) && all.deleted_job_count() > 0) break;
      if (batches.stopped()) return EndWith(kExitStopped, "stopped; to continue: flair batch delete {}", batch.id());
      if (absl::IsFailedPrecondition(some.status())) {
        return EndWith(kExitBadInput, std::string(some.status().message()));
      }
      if (!some.ok()) return some.status();
      all.set_deleted_job_count(all.deleted_job_count() + some->deleted_job_count());
      all.set_deleted_artifact_count(all.deleted_artifact_count() + some->deleted_artifact_count());
      all.set_done(some->done());
      note.Set(fmt::format("deleted {} of {}, {}", std::min<int64_t>(batch.job_count(), all.deleted_job_count()),
                           Counted(batch.job_count(), "job"), Counted(all.deleted_artifact_count(), "artifact")));
    }
  }
  all.set_done(true);
  if (options.json) {
    fmt::print("{}\n", ToJsonLine(all));
  } else {
    fmt::print("deleted batch {}: {}, and {} that no other job had\n", NameOfBatch(batch),
               Counted(all.deleted_job_count(), "job"), Counted(all.deleted_artifact_count(), "artifact"));
  }
  return absl::OkStatus();
}

}  // namespace flair::cli
