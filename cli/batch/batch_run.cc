// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/batch_run.h"

#include <cstdio>
#include <memory>
#include <thread>

#include "cli/batch/batch_monitor.h"
#include "cli/batch/collector.h"
#include "cli/exit_code.h"
#include "fmt/format.h"
#include "nlohmann/json.hpp"
#include "worker_runtime/text/counted.h"

namespace flair::cli {
namespace {

// Rows that may wait for the files of others.
constexpr size_t kHeldRows = 2048;

absl::Status Collect(BatchSession& session, BatchFolder& folder, const std::string& batch_id) {
  const absl::StatusOr<BatchPlace> place = folder.Place();
  if (!place.ok()) return place.status();
  absl::StatusOr<KeptFiles> kept = KeptFiles::Parse(place->kept);
  if (!kept.ok()) return kept.status();
  const auto shard_size = static_cast<size_t>(place->shard_size);
  std::unique_ptr<ResultWriter> writer = MakeJobFolders(folder.path());
  if (shard_size > 0) {
    absl::StatusOr<std::unique_ptr<ResultWriter>> shards = MakeTarShards(folder.path(), place->shard_size);
    if (!shards.ok()) return shards.status();
    writer = *std::move(shards);
  }
  // Shards are for those who train on them: no failures there.
  const Collector::Options options{
      .kept = *std::move(kept), .keep_failed = shard_size == 0, .held_limit = kHeldRows + shard_size, .end_after = {}};
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
  return EndWith(kExitStopped, fmt::format("stopped; batch {} goes on where it was: {}", batch.id(), how));
}

absl::Status Summarize(BatchSession& session, const v1::Batch& batch, BatchFolder& folder,
                       const BatchRunOptions& options) {
  const absl::StatusOr<BatchReport> report = MakeBatchReport(folder.results());
  if (!report.ok()) return report.status();
  if (options.json) {
    fmt::print("{}\n", BatchReportJson(*report).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
  } else if (!options.quiet) {
    fmt::print(stderr, "{}", BatchOutcomeText(*report));
  }
  const absl::StatusOr<v1::Batch> now = session.GetBatch(batch.id());
  if (now.ok() && now->state() == v1::BATCH_STATE_CANCELLED) {
    return EndWith(kExitCancelled, fmt::format("batch {} was cancelled", batch.id()));
  }
  return EndOf(*report, folder.path().string());
}

}  // namespace

absl::Status EndOf(const BatchReport& report, const std::string& name) {
  if (report.failed_count > 0) {
    return EndWith(kExitSomeFailed,
                   fmt::format("{} of {} failed; more: flair batch report {}; again: flair batch retry {}",
                               report.failed_count, Counted(report.job_count, "job"), name, name));
  }
  if (report.not_fetched_count > 0) {
    return EndWith(kExitSomeFailed, fmt::format("the results of {} could not be fetched; again: flair batch watch {}",
                                                Counted(report.not_fetched_count, "job"), name));
  }
  if (report.rejected_count > 0) {
    return EndWith(kExitSomeFailed, fmt::format("{} rejected; {}/rejected.jsonl says why",
                                                Counted(report.rejected_count, "line was", "lines were"), name));
  }
  if (report.cancelled_count > 0) {
    return EndWith(kExitSomeFailed, Counted(report.cancelled_count, "job was cancelled", "jobs were cancelled"));
  }
  return absl::OkStatus();
}

absl::Status RunBatch(const v1::Batch& batch, BatchSession& session, BatchFolder& folder, Submission* submission,
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

}  // namespace flair::cli
