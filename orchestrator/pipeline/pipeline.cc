// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/pipeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <latch>
#include <set>

#include "google/protobuf/util/time_util.h"
#include "orchestrator/store/artifact_id.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::orchestrator {
namespace {

using Output = StageRunner::Output;

// What the stages of one job have made so far, by stage index.
class Progress {
 public:
  explicit Progress(const v1::JobSpec& spec) : spec_(spec), outputs_(Stages().size()) {}

  // Stages that are wanted and not done and whose inputs are.
  std::vector<int> Ready() const {
    std::vector<int> ready;
    const int solve = StageIndex(kSolve);
    for (int i = 0; i < static_cast<int>(outputs_.size()); ++i) {
      const Stage& stage = Stages()[i];
      // All between the brief and a layout is there for the layout.
      const bool too_late = 0 < i && i < solve && outputs_[solve].has_value();
      const bool wanted = !too_late && (stage.wanted == nullptr || stage.wanted(spec_));
      if (wanted && !outputs_[i].has_value() && InputsOf(i).size() == stage.inputs.size()) ready.push_back(i);
    }
    return ready;
  }

  std::vector<const v1::Artifact*> InputsOf(int stage_index) const {
    std::vector<const v1::Artifact*> inputs;
    for (const v1::ArtifactKind kind : Stages()[stage_index].inputs) {
      // The first stage that makes the kind: further views are nobody's input.
      const size_t i = std::ranges::find(Stages(), kind, &Stage::output) - Stages().begin();
      if (outputs_[i].has_value()) inputs.push_back(&outputs_[i]->artifact);
    }
    return inputs;
  }

  std::vector<v1::StageTiming> Timings() const {
    std::vector<v1::StageTiming> timings;
    for (const std::optional<Output>& output : outputs_) {
      if (output.has_value()) timings.push_back(output->timing);
    }
    return timings;
  }

  // Of what was made for this job, not used again.
  v1::ModelUsage ModelUsage() const {
    v1::ModelUsage usage;
    for (const std::optional<Output>& output : outputs_) {
      if (output.has_value() && !output->timing.reused()) AddUsage(output->artifact, usage);
    }
    return usage;
  }

  std::vector<v1::ArtifactRef> Artifacts() const {
    std::vector<v1::ArtifactRef> artifacts;
    for (const std::optional<Output>& output : outputs_) {
      if (output.has_value()) artifacts.emplace_back().set_id(output->artifact.id());
    }
    return artifacts;
  }

  void Set(int stage_index, Output output) { outputs_[stage_index] = std::move(output); }

 private:
  const v1::JobSpec& spec_;
  std::vector<std::optional<Output>> outputs_;
};

// Work of a job that a crash may take with it, beside the stages that run. A write takes less than a hundredth of it.
constexpr absl::Duration kWorkKeptBack = absl::Milliseconds(500);

google::protobuf::Duration ToProto(absl::Duration duration) {
  return google::protobuf::util::TimeUtil::MicrosecondsToDuration(absl::ToInt64Microseconds(duration));
}

std::vector<std::string> InputIds(const StageRun& run) {
  std::vector<std::string> ids;
  for (const v1::Artifact* input : run.inputs) ids.push_back(input->id());
  return ids;
}

}  // namespace

// Calls `task` with 0, 1, ... count - 1, at once, and returns when all calls have.
void Pipeline::ForAll(size_t count, const std::function<void(size_t)>& task) const {
  // Shared with those who count down, as they may still be in there when the last one has.
  const auto others = std::make_shared<std::latch>(static_cast<std::ptrdiff_t>(count - 1));
  for (size_t i = 1; i < count; ++i) {
    const auto run = [&task, others, i] {
      task(i);
      others->count_down();
    };
    if (!threads_->TrySubmit(run)) run();
  }
  task(0);
  others->wait();
}

PipelineResult Pipeline::Run(Lease& lease) const {
  StepLog steps(lease, artifacts_);
  PipelineResult result = RunStages(lease, steps);
  // The next run goes on from there; what cannot be stored it makes again.
  if (!result.status.ok()) (void)steps.Store();
  return result;
}

PipelineResult Pipeline::RunStages(Lease& lease, StepLog& steps) const {
  const v1::Job& job = lease.job();
  StageRunner runner(queue_, artifacts_, clients_, catalogs_, clock_, options_, lease, steps);
  Progress progress(job.spec());
  const v1::ArtifactRef* const given = GivenLayout(job);
  if (given != nullptr) {
    absl::StatusOr<Output> layout = runner.Reuse(StageIndex(kSolve), *given);
    if (!layout.ok()) return {layout.status(), std::string(kSolve)};
    progress.Set(StageIndex(kSolve), *std::move(layout));
  }
  for (std::vector<int> ready = progress.Ready(); !ready.empty(); ready = progress.Ready()) {
    const std::vector<v1::StageTiming> timings = progress.Timings();
    const v1::ModelUsage usage = progress.ModelUsage();
    // Stages that share a budget go one after the other, so that each knows what the others left of it.
    if (job.spec().model_options().has_budget()) ready.resize(1);
    std::vector<absl::StatusOr<Output>> outputs(ready.size());
    ForAll(ready.size(),
           [&](size_t i) { outputs[i] = runner.Run(ready[i], progress.InputsOf(ready[i]), timings, usage); });
    for (size_t i = 0; i < ready.size(); ++i) {
      // Of several failures the first in stage order counts, whichever came first.
      if (!outputs[i].ok()) return {outputs[i].status(), std::string(Stages()[ready[i]].name)};
      progress.Set(ready[i], *std::move(outputs[i]));
    }
  }
  absl::StatusOr<std::vector<StageRecord>> last = steps.TakeLast();
  absl::Status status = last.status();
  if (status.ok()) status = artifacts_.Flush(progress.Artifacts());
  // Of a given layout nothing is reported but the picture.
  const std::string stage = given == nullptr ? "report" : "render";
  if (!status.ok()) return {OfStore(status), stage};
  return {absl::OkStatus(), stage, *std::move(last)};
}

absl::Status StepLog::Add(StageRecord record, std::optional<SealedArtifact> artifact, Urgency urgency) {
  const google::protobuf::Duration& took = record.event.duration();
  std::lock_guard lock(mutex_);
  work_ += absl::Seconds(took.seconds()) + absl::Nanoseconds(took.nanos());
  kept_.push_back(std::move(record));
  if (artifact.has_value()) kept_artifacts_.push_back(*std::move(artifact));
  return urgency == Urgency::kAtOnce || work_ > kWorkKeptBack ? StoreKept() : absl::OkStatus();
}

absl::Status StepLog::Store() {
  std::lock_guard lock(mutex_);
  return StoreKept();
}

absl::StatusOr<std::vector<StageRecord>> StepLog::TakeLast() {
  std::lock_guard lock(mutex_);
  return TakeKept();
}

// What is recorded is there: first the artifacts.
absl::StatusOr<std::vector<StageRecord>> StepLog::TakeKept() {
  work_ = absl::ZeroDuration();
  std::vector<StageRecord> records = std::exchange(kept_, {});
  // Nobody deletes what is stored before it is recorded.
  RETURN_IF_ERROR(lease_.Announce(records));
  RETURN_IF_ERROR(artifacts_.PutAll(std::exchange(kept_artifacts_, {})));
  return records;
}

absl::Status StepLog::StoreKept() {
  const absl::StatusOr<std::vector<StageRecord>> records = TakeKept();
  return records.ok() ? lease_.RecordAll(*records) : records.status();
}

StageRunner::StageRunner(WorkQueue& queue, ArtifactStore& artifacts, StageClients& clients, CatalogCache& catalogs,
                         const runtime::Clock& clock, const PipelineOptions& options, Lease& lease, StepLog& steps)
    : queue_(queue),
      artifacts_(artifacts),
      clients_(clients),
      catalogs_(catalogs),
      clock_(clock),
      options_(options),
      steps_(steps),
      job_(lease.job()),
      cancellation_(lease.cancellation()) {
  for (const v1::JobEvent& event : lease.history()) {
    const bool ended =
        event.kind() == v1::JOB_EVENT_KIND_STAGE_FINISHED || event.kind() == v1::JOB_EVENT_KIND_STAGE_REUSED;
    if (ended) history_[event.stage()] = event;
  }
}

absl::StatusOr<StageRunner::Output> StageRunner::Run(int stage_index, std::span<const v1::Artifact* const> inputs,
                                                     std::span<const v1::StageTiming> timings,
                                                     const v1::ModelUsage& model_usage) const {
  const Stage& stage = Stages()[static_cast<size_t>(stage_index)];
  if (job_.spec().has_replay() && stage_index < FirstStageOf(job_.spec().replay())) {
    return TakeFromEarlierJob(stage_index);
  }
  StageClients::Call no_deadline;
  StageRun run{stage.name,     job_.id(), job_.spec(), inputs,   "",        "",
               options_.build, timings,   model_usage, clients_, catalogs_, no_deadline};
  StageOptions options;
  if (stage.options != nullptr) {
    ASSIGN_OR_RETURN(options, Retry<StageOptions>(stage.options, run));
  } else if (stage.asked != nullptr) {
    options.bytes = stage.asked(job_.spec());
  }
  const std::string options_digest = options.bytes.empty() ? "" : runtime::Sha256Hex(options.bytes);
  run.options = options.bytes;
  run.options_digest = options_digest;
  run.catalog = options.catalog.get();
  ASSIGN_OR_RETURN(
      const Revision revision,
      Retry<Revision>(
          [&stage](const StageRun& current) { return current.clients.Revision(stage.output, current.call); }, run));
  const std::string key = KeyOf(stage, run, revision);
  auto known = queue_.FindResult(key);
  if (!known.ok()) return OfStore(known.status());
  if (known->has_value()) {
    absl::StatusOr<Output> reused = Reuse(stage_index, **known);
    // A file that is gone or damaged is made again.
    if (reused.ok() || (!absl::IsNotFound(reused.status()) && !absl::IsDataLoss(reused.status()))) return reused;
  }
  return MakeAndStore(stage_index, run, revision);
}

std::string StageRunner::KeyOf(const Stage& stage, const StageRun& run, const Revision& revision) const {
  // A replay uses nothing again but what it made itself before it was interrupted. The same holds for what a worker
  // made that does not say which it is.
  const bool of_this_job_only = run.spec.has_replay() || !revision.has_value();
  return ResultKey(stage.name, revision.value_or(""), run.options_digest, InputIds(run),
                   of_this_job_only ? run.job_id : "");
}

// What the replayed job had. Without it there is nothing to go on from.
absl::StatusOr<StageRunner::Output> StageRunner::TakeFromEarlierJob(int stage_index) const {
  const v1::Replay& replay = job_.spec().replay();
  ASSIGN_OR_RETURN(const v1::ArtifactRef ref, ArtifactToTake(replay, stage_index, queue_));
  absl::StatusOr<Output> taken = Reuse(stage_index, ref);
  if (taken.ok()) return taken;
  return absl::Status(
      taken.status().code(),
      fmt::format("{}; it should have come from job {}: run that job again from \"{}\" or an earlier stage",
                  std::string(taken.status().message()), replay.job_id(),
                  Stages()[static_cast<size_t>(stage_index)].name));
}

absl::StatusOr<StageRunner::Output> StageRunner::MakeAndStore(int stage_index, const StageRun& run,
                                                              Revision revision) const {
  const Stage& stage = Stages()[static_cast<size_t>(stage_index)];
  // Somebody watches a job that stands alone; in a batch it would be half of all that is stored.
  if (job_.batch_id().empty()) {
    RETURN_IF_ERROR(Record({Event(v1::JOB_EVENT_KIND_STAGE_STARTED, stage), stage_index, ""}, {}));
  }
  const absl::Duration start = clock_.Elapsed();
  ASSIGN_OR_RETURN(v1::Artifact artifact, Make(stage, run, revision));
  // The first stage is made from what it is asked; that is its content.
  if (!run.inputs.empty()) artifact.set_options_digest(std::string(run.options_digest));
  const std::vector<std::string> input_ids = InputIds(run);
  artifact.mutable_made_from_ids()->Assign(input_ids.begin(), input_ids.end());
  SealedArtifact sealed = SealArtifact(artifact);
  v1::JobEvent event = Event(v1::JOB_EVENT_KIND_STAGE_FINISHED, stage);
  event.set_message(Summarize(artifact));
  if (const std::string models = SummarizeModels(artifact); !models.empty()) {
    event.set_message(fmt::format("{}  ({})", event.message(), models));
  }
  *event.mutable_artifact() = sealed.ref;
  *event.mutable_duration() = ToProto(clock_.Elapsed() - start);
  const bool paid_for = !artifact.model_calls().empty();
  RETURN_IF_ERROR(Record({event, stage_index, KeyOf(stage, run, revision)}, std::move(sealed), paid_for));
  Output output{std::move(artifact), {}};
  output.timing.set_stage(std::string(stage.name));
  *output.timing.mutable_duration() = event.duration();
  return output;
}

// Asks a worker, again where that is safe and useful, until the deadline of one call has passed since the first. Each
// attempt has a whole deadline of its own.
template <typename Result>
absl::StatusOr<Result> StageRunner::Retry(const std::function<absl::StatusOr<Result>(const StageRun&)>& function,
                                          const StageRun& run) const {
  const absl::Time last_attempt = clock_.Now() + options_.stage_deadline;
  // What a worker that is not asked again answered; and whether a worker failed before there was none.
  std::optional<absl::StatusOr<Result>> bad;
  std::set<int64_t> bad_answerers;
  bool failed = false;
  for (int attempt = 0;; ++attempt) {
    StageClients::Call call(run.job_id, clock_.Now() + options_.stage_deadline, clock_);
    call.set_bad_answerers(bad_answerers);
    runtime::OnCancel guard(cancellation_, [&call] { call.cancellation().Cancel(); });
    StageRun current{run.stage,          run.job_id, run.spec,    run.inputs,      run.options,
                     run.options_digest, run.build,  run.timings, run.model_usage, run.clients,
                     run.catalogs,       call,       run.catalog};
    absl::StatusOr<Result> result = cancellation_.cancelled()
                                        ? absl::StatusOr<Result>(absl::CancelledError("the job was cancelled"))
                                        : function(current);
    if (result.ok() || cancellation_.cancelled()) return result;
    if (call.bad_answerers().size() > bad_answerers.size() && !bad.has_value()) {
      bad_answerers = call.bad_answerers();
      bad = std::move(result);
      continue;
    }
    if (bad.has_value()) return absl::IsUnavailable(result.status()) ? *bad : result;
    failed = failed || !IsOutage(result.status());
    if (failed && IsOutage(result.status())) result = absl::Status(result.status().code(), result.status().message());
    const std::optional<absl::Duration> delay = options_.backoff.DelayAfter(result.status(), attempt, run.job_id);
    if (!delay.has_value() || clock_.Now() + *delay > last_attempt) return result;
    options_.wait(*delay, call);
  }
}

// Sets `revision` to that of the worker that answered, which need not be the one that was thought of before.
absl::StatusOr<v1::Artifact> StageRunner::Make(const Stage& stage, const StageRun& run, Revision& revision) const {
  const auto make = [&](const StageRun& current) -> absl::StatusOr<v1::Artifact> {
    absl::StatusOr<v1::Artifact> made = stage.run(current);
    if (!made.ok()) return made;
    if (absl::Status status = CheckAnswer(stage, *made); !status.ok()) {
      current.call.ReportBadAnswer(status);
      return status;
    }
    // What we make ourselves, such as the report, is ours whoever was asked for it.
    const bool ours = revision.has_value() && revision->empty();
    if (current.call.answerer().has_value() && !ours) revision = current.call.answerer()->revision;
    return made;
  };
  absl::StatusOr<v1::Artifact> artifact = Retry<v1::Artifact>(make, run);
  if (absl::IsDeadlineExceeded(artifact.status())) {
    return DeadlineExceeded("stage \"{}\" did not finish within {} (stage_deadline_seconds)", stage.name,
                            absl::FormatDuration(options_.stage_deadline));
  }
  return artifact;
}

absl::StatusOr<StageRunner::Output> StageRunner::Reuse(int stage_index, const v1::ArtifactRef& ref) const {
  const Stage& stage = Stages()[static_cast<size_t>(stage_index)];
  const absl::Duration start = clock_.Elapsed();
  absl::StatusOr<v1::Artifact> artifact = artifacts_.Get(ref.id());
  if (!artifact.ok()) return OfStore(artifact.status());
  Output output{*std::move(artifact), {}};
  output.timing.set_stage(std::string(stage.name));
  const auto before = history_.find(stage.name);
  if (before != history_.end() && before->second.artifact().id() == ref.id()) {
    *output.timing.mutable_duration() = before->second.duration();
    output.timing.set_reused(before->second.kind() == v1::JOB_EVENT_KIND_STAGE_REUSED);
    return output;
  }
  v1::JobEvent event = Event(v1::JOB_EVENT_KIND_STAGE_REUSED, stage);
  event.set_message(Summarize(output.artifact));
  *event.mutable_artifact() = ref;
  *event.mutable_duration() = ToProto(clock_.Elapsed() - start);
  RETURN_IF_ERROR(Record({event, stage_index, ""}, {}));
  *output.timing.mutable_duration() = event.duration();
  output.timing.set_reused(true);
  return output;
}

absl::Status StageRunner::Record(StageRecord record, std::optional<SealedArtifact> artifact, bool paid_for) const {
  // Somebody watches a job that stands alone; and no money is spent twice.
  const bool at_once = job_.batch_id().empty() || paid_for;
  return OfStore(steps_.Add(std::move(record), std::move(artifact),
                            at_once ? StepLog::Urgency::kAtOnce : StepLog::Urgency::kMayWait));
}

v1::JobEvent StageRunner::Event(v1::JobEventKind kind, const Stage& stage) const {
  v1::JobEvent event;
  event.set_job_id(job_.id());
  event.set_kind(kind);
  event.set_stage(std::string(stage.name));
  event.set_state(v1::JOB_STATE_RUNNING);
  return event;
}

}  // namespace flair::orchestrator
