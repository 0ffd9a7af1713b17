// SPDX-License-Identifier: GPL-3.0-or-later
#include "orchestrator/pipeline/pipeline.h"

#include <algorithm>
#include <latch>
#include <optional>

#include "orchestrator/pipeline/stage_clients.h"
#include "orchestrator/pipeline/stage_runner.h"
#include "orchestrator/pipeline/summary.h"

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
    for (int i = 0; i < static_cast<int>(outputs_.size()); ++i) {
      const Stage& stage = Stages()[i];
      const bool wanted = stage.wanted == nullptr || stage.wanted(spec_);
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
  if (!status.ok()) return {OfStore(status), "report"};
  return {absl::OkStatus(), "report", *std::move(last)};
}

}  // namespace flair::orchestrator
