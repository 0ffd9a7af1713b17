// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/batch/collector.h"

#include <algorithm>
#include <chrono>

#include "cli/input/artifact_file.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::cli {
namespace {

// How far the batch has been collected, see ResultsFile::State.
constexpr char kAfterSequence[] = "after_sequence";

constexpr std::chrono::milliseconds kRememberEvery{300};
constexpr size_t kRememberAtOnce = 512;

bool HasEnded(const v1::Job& job) {
  return job.state() == v1::JOB_STATE_SUCCEEDED || job.state() == v1::JOB_STATE_FAILED ||
         job.state() == v1::JOB_STATE_CANCELLED;
}

// An artifact that is not there or not whole is this job's fault; everything else would be the same for the next job.
bool IsOfJob(const absl::Status& status) {
  return absl::IsNotFound(status) || absl::IsDataLoss(status) || absl::IsInvalidArgument(status);
}

}  // namespace

Collector::Collector(Session& session, ResultsFile& results, ResultWriter& writer, const Options& options)
    : session_(session), results_(results), writer_(writer), options_(options) {}

absl::StatusOr<int64_t> Collector::FirstSequence() {
  ASSIGN_OR_RETURN(const int64_t after, results_.IntState(kAfterSequence));
  // What could not be fetched before is tried again.
  ASSIGN_OR_RETURN(const int64_t failed,
                   results_.Count("SELECT MIN(end_sequence) FROM jobs WHERE fetch_error IS NOT NULL"));
  return failed > 0 ? std::min(after, failed - 1) : after;
}

absl::StatusOr<bool> Collector::IsNew(const v1::WatchBatchResponse& end) {
  ASSIGN_OR_RETURN(const std::optional<ResultRow> row, results_.Find(end.job().batch_index()));
  return !row.has_value() || row->Int("end_sequence") != end.sequence() || !row->Text("fetch_error").empty();
}

bool Collector::Enqueue(const v1::WatchBatchResponse& end) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] {
    const bool room =
        waiting_.size() < 4 * static_cast<size_t>(options_.fetch_count) && open_.size() < options_.held_limit;
    return room || !status_.ok();
  });
  if (!status_.ok()) return false;
  last_seen_ = end.sequence();
  open_[end.sequence()] = false;
  waiting_.push_back({.sequence = end.sequence(), .job = end.job()});
  changed_.notify_all();
  return true;
}

absl::Status Collector::Watch(const std::string& batch_id) {
  ASSIGN_OR_RETURN(const int64_t after, FirstSequence());
  {
    const std::lock_guard lock(mutex_);
    last_seen_ = after;
  }
  std::set<int64_t> seen;  // only where it is asked for
  absl::Status status;
  const absl::Status watched = session_.WatchBatch(batch_id, after, failed_, [&](const v1::WatchBatchResponse& end) {
    const absl::StatusOr<bool> is_new = IsNew(end);
    status = is_new.status();
    if (!status.ok() || (*is_new && !Enqueue(end))) return false;
    if (!options_.end_after.has_value()) return true;
    seen.insert(end.job().batch_index());
    return static_cast<int64_t>(seen.size()) < *options_.end_after;
  });
  return status.ok() ? watched : status;
}

void Collector::Fail(const absl::Status& status) {
  {
    const std::lock_guard lock(mutex_);
    if (status_.ok()) status_ = status;
    changed_.notify_all();
  }
  failed_.Cancel();
}

absl::StatusOr<std::vector<v1::Artifact>> Collector::FetchArtifacts(const v1::Job& job, ResultRow& row) {
  const bool keeps =
      job.state() == v1::JOB_STATE_SUCCEEDED || (job.state() == v1::JOB_STATE_FAILED && options_.keep_failed);
  std::vector<v1::Artifact> artifacts;
  for (const v1::ArtifactRef& ref : job.artifacts()) {
    const bool is_report = ref.kind() == v1::ARTIFACT_KIND_REPORT;
    if (!is_report && (!keeps || !options_.kept.Needs(ref.kind()))) continue;
    ASSIGN_OR_RETURN(v1::Artifact artifact, session_.GetArtifact(ref.id()));
    RETURN_IF_ERROR(CheckArtifactId(artifact, "artifact " + ref.id()));
    if (is_report) AddReport(artifact.report(), row);
    if (keeps) artifacts.push_back(std::move(artifact));
  }
  return artifacts;
}

absl::StatusOr<Collector::Fetched> Collector::Fetch(const End& end) {
  Fetched fetched{.sequence = end.sequence, .row = RowOf(end.job)};
  fetched.row.Set("end_sequence", end.sequence);
  if (!HasEnded(end.job)) {
    fetched.row.Set("state", "waiting");  // was retried since; its next end will come
    return fetched;
  }
  const absl::StatusOr<std::vector<v1::Artifact>> artifacts = FetchArtifacts(end.job, fetched.row);
  if (!artifacts.ok()) {
    if (!IsOfJob(artifacts.status())) return artifacts.status();
    fetched.row.Set("fetch_error", std::string(artifacts.status().message()));
    return fetched;
  }
  const bool cancelled = end.job.state() == v1::JOB_STATE_CANCELLED;
  if (cancelled || (end.job.state() == v1::JOB_STATE_FAILED && !options_.keep_failed)) return fetched;
  const std::vector<OutputFile> files = options_.kept.FilesOf(end.job, *artifacts);
  if (files.empty()) return fetched;
  ASSIGN_OR_RETURN(const ResultWriter::Place place, writer_.Write(end.job.batch_index(), files));
  int64_t size_bytes = 0;
  for (const OutputFile& file : files) size_bytes += static_cast<int64_t>(file.content.size());
  fetched.row.Set("path", place.path);
  fetched.row.Set("size_bytes", size_bytes);
  fetched.ticket = place.ticket;
  return fetched;
}

void Collector::FetchEnds() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return !waiting_.empty() || seen_all_ || !status_.ok(); });
    if (!status_.ok() || waiting_.empty()) return;
    const End end = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    absl::StatusOr<Fetched> fetched = Fetch(end);
    if (!fetched.ok()) {
      Fail(fetched.status());
      return;
    }
    lock.lock();
    fetched_.push_back(*std::move(fetched));
    ++fetched_count_;
    changed_.notify_all();
  }
}

absl::Status Collector::Remember(bool all) {
  RETURN_IF_ERROR(writer_.Settle(all));
  std::vector<Fetched> settled;
  int64_t after = 0;
  {
    const std::lock_guard lock(mutex_);
    const auto open = std::ranges::stable_partition(
        fetched_, [this](const Fetched& one) { return one.ticket == 0 || writer_.IsSettled(one.ticket); });
    settled.assign(std::make_move_iterator(fetched_.begin()), std::make_move_iterator(open.begin()));
    fetched_.erase(fetched_.begin(), open.begin());
    std::set<int64_t> sequences;
    for (const Fetched& one : settled) sequences.insert(one.sequence);
    const auto first_open =
        std::ranges::find_if(open_, [&](const auto& one) { return !sequences.contains(one.first); });
    after = first_open == open_.end() ? last_seen_ : first_open->first - 1;
  }
  RETURN_IF_ERROR(results_.Change([&]() -> absl::Status {
    for (const Fetched& one : settled) {
      RETURN_IF_ERROR(results_.ForgetEnd(one.row.Int("batch_index")));
      RETURN_IF_ERROR(results_.Put(one.row));
    }
    return results_.SetState(kAfterSequence, after);
  }));
  const std::lock_guard lock(mutex_);
  for (const Fetched& one : settled) open_.erase(one.sequence);
  changed_.notify_all();
  return absl::OkStatus();
}

void Collector::RememberEnds() {
  size_t unsettled = 0;
  bool all = false;
  while (!all) {
    {
      std::unique_lock lock(mutex_);
      const auto enough = [&] { return fetched_all_ || fetched_.size() >= unsettled + kRememberAtOnce; };
      changed_.wait_for(lock, kRememberEvery, enough);
      all = fetched_all_;
      if (!all && fetched_.size() == unsettled) continue;
    }
    if (const absl::Status status = Remember(all); !status.ok()) {
      Fail(status);
      return;
    }
    const std::lock_guard lock(mutex_);
    unsettled = fetched_.size();
  }
}

absl::Status Collector::Run(const std::string& batch_id) {
  std::thread remember([this] { RememberEnds(); });
  std::vector<std::thread> fetchers;
  for (int i = 0; i < options_.fetch_count; ++i) fetchers.emplace_back([this] { FetchEnds(); });
  if (const absl::Status status = Watch(batch_id); !status.ok()) Fail(status);
  const auto tell = [this](bool Collector::*flag) {
    const std::lock_guard lock(mutex_);
    this->*flag = true;
    changed_.notify_all();
  };
  tell(&Collector::seen_all_);
  for (std::thread& fetcher : fetchers) fetcher.join();
  // What was fetched before something went wrong is remembered all the same.
  tell(&Collector::fetched_all_);
  remember.join();
  const std::lock_guard lock(mutex_);
  return status_;
}

}  // namespace flair::cli
