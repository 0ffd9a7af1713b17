// SPDX-License-Identifier: GPL-3.0-or-later
// Documents whose room is designed or furnished by a job.
#include <algorithm>
#include <memory>
#include <utility>

#include "fmt/format.h"
#include "orchestrator/pipeline/stage_clients.h"
#include "room/validation/validate.h"
#include "session/documents/documents.h"
#include "session/documents/record.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {

// A second apart: after these its job is taken for failed.
constexpr int kMostLooks = 600;

using runtime::CallContext;
using store::v1::LayoutState;

absl::Status Documents::StartJob(Record& record, const v1::JobSpec& spec, const std::string& request_id,
                                 CallContext& call) {
  RETURN_IF_ERROR(Validate(spec, "design"));
  v1::CreateJobRequest request;
  request.set_request_id(request_id);
  *request.mutable_spec() = spec;
  ASSIGN_OR_RETURN(const v1::Job job, stages_.CreateJob(request, call));
  record.set_job_request_id(request_id);
  v1::Document& document = *record.mutable_document();
  document.set_job_id(job.id());
  document.set_job_state(v1::JOB_STATE_QUEUED);
  document.clear_job_error();
  return absl::OkStatus();
}

absl::StatusOr<v1::ActResponse> Documents::Furnish(Record record, const v1::ActRequest& request, CallContext& call) {
  ASSIGN_OR_RETURN(const Layout before, Shown(record));
  if (IsRunning(record.document().job_state())) {
    return absl::FailedPreconditionError("furnish: the document's job has not ended; wait for it or cancel it");
  }
  v1::JobSpec spec;
  *spec.mutable_brief() = request.furnish();
  *spec.mutable_brief()->mutable_room() = before->solved_layout().graph().room();
  RETURN_IF_ERROR(
      StartJob(record, spec, fmt::format("{}-{}", record.document().id(), record.document().revision()), call));
  RETURN_IF_ERROR(Commit(record, {}));
  Follow(record.document().id(), record.document().job_id(), kFurnish);
  return Answer(record, before);
}

absl::StatusOr<v1::ShareDocumentResponse> Documents::Share(const v1::ShareDocumentRequest& request, CallContext& call) {
  ASSIGN_OR_RETURN(const Record record, store_->Get(request.document_id()));
  ASSIGN_OR_RETURN(const Layout shown, Shown(record));
  const v1::LayoutGraph& graph = shown->solved_layout().graph();
  if (graph.object_list().objects().empty()) {
    return absl::FailedPreconditionError("nothing stands in the room: there is nothing to share");
  }
  const auto has_it = [&](const v1::Job& job) {
    return std::ranges::find(job.artifacts(), shown->id(), &v1::ArtifactRef::id) != job.artifacts().end();
  };
  v1::ShareDocumentResponse response;
  if (!record.document().job_id().empty()) {
    const absl::StatusOr<v1::Job> own = stages_.GetJob(record.document().job_id(), call);
    if (own.ok() && has_it(*own)) {
      response.set_job_id(own->id());
      return response;
    }
  }
  v1::CreateJobRequest create;
  create.set_request_id("layout-" + shown->id());
  *create.mutable_layout() = *shown;
  v1::Brief& brief = *create.mutable_spec()->mutable_brief();
  brief = DocumentOf(record).brief();
  if (brief.text().empty()) brief.set_text(record.document().title());
  const absl::StatusOr<v1::Job> made = stages_.CreateJob(create, call);
  if (made.ok() && !has_it(*made)) {
    // It has taken the brief alone.
    stages_.CancelJob(made->id(), call).IgnoreError();
    return absl::UnimplementedError("the orchestrator is of an earlier version, which stores no layouts");
  }
  if (made.ok()) {
    response.set_job_id(made->id());
    return response;
  }
  if (!absl::IsAlreadyExists(made.status())) return made.status();
  // Shared before, with another brief.
  ASSIGN_OR_RETURN(const std::vector<v1::Job> jobs, stages_.ListJobs(call));
  const auto job = std::ranges::find_if(jobs, has_it);
  if (job == jobs.end()) return made.status();
  response.set_job_id(job->id());
  return response;
}

absl::StatusOr<v1::Artifact> Documents::LayoutOfJob(const v1::Job& job, CallContext& call) {
  for (const v1::ArtifactRef& ref : job.artifacts()) {
    if (ref.kind() == v1::ARTIFACT_KIND_SOLVED_LAYOUT) return stages_.GetArtifact(ref.id(), call);
  }
  return FailedPrecondition("job_id: the job {} has no layout", job.id());
}

absl::StatusOr<v1::Document> Documents::AwaitJob(const std::string& document_id,
                                                 const std::function<void(const v1::JobEvent&)>& see,
                                                 CallContext& call) {
  ASSIGN_OR_RETURN(const Record record, store_->Get(document_id));
  const std::string& job_id = record.document().job_id();
  if (job_id.empty()) return absl::FailedPreconditionError("the document was made by no job");
  RETURN_IF_ERROR(stages_.WatchJob(job_id, 0, see, call));
  ASSIGN_OR_RETURN(const v1::Job job, stages_.GetJob(job_id, call));
  RETURN_IF_ERROR(Adopt(document_id, job, record.states().empty() ? kDesign : kFurnish));
  v1::GetDocumentRequest get;
  get.set_document_id(document_id);
  ASSIGN_OR_RETURN(v1::GetDocumentResponse now, Get(get));
  return std::move(*now.mutable_document());
}

absl::Status Documents::CancelJob(const std::string& document_id, CallContext& call) {
  ASSIGN_OR_RETURN(const Record record, store_->Get(document_id));
  if (!IsRunning(record.document().job_state())) return absl::OkStatus();
  return stages_.CancelJob(record.document().job_id(), call);
}

void Documents::GoOn(const Record& record) {
  CallContext call;
  const v1::Document& document = record.document();
  const absl::StatusOr<v1::Job> job = stages_.GetJob(document.job_id(), call);
  if (job.ok() && IsRunning(job->state())) {
    v1::CreateJobRequest request;
    request.set_request_id(record.job_request_id());
    *request.mutable_spec() = job->spec();
    stages_.CreateJob(request, call).IgnoreError();
  }
  Follow(document.id(), document.job_id(), record.states().empty() ? kDesign : kFurnish);
}

void Documents::Follow(const std::string& document_id, const std::string& job_id, const std::string& label) {
  const std::lock_guard lock(mutex_);
  if (closing_) return;
  followers_.emplace_back([this, document_id, job_id, label] { FollowToEnd(document_id, job_id, label); });
}

void Documents::FollowToEnd(const std::string& document_id, const std::string& job_id, const std::string& label) {
  const auto call = std::make_shared<CallContext>();
  {
    const std::lock_guard lock(mutex_);
    if (closing_) return;
    followed_.push_back(call);
  }
  int64_t seen = 0;
  v1::Job job;
  const auto look = [&]() -> absl::Status {
    RETURN_IF_ERROR(stages_.WatchJob(
        job_id, seen,
        [&](const v1::JobEvent& event) {
          v1::WatchDocumentsResponse told;
          *told.mutable_job_event() = event;
          seen = event.sequence();
          events_.Tell(told);
        },
        *call));
    ASSIGN_OR_RETURN(job, stages_.GetJob(job_id, *call));
    return absl::OkStatus();
  };
  absl::Status status = look();
  // An orchestrator elsewhere may be restarting; its jobs go on.
  for (int i = 0; i < kMostLooks && absl::IsUnavailable(status) && !call->cancelled(); ++i) {
    orchestrator::WaitUnlessCancelled(absl::Seconds(1), *call);
    status = look();
  }
  if (!status.ok() && !call->cancelled()) {
    job.set_id(job_id);
    job.set_state(v1::JOB_STATE_FAILED);
    job.set_error(std::string(status.message()));
  }
  if (!call->cancelled()) {
    Adopt(document_id, job, label).IgnoreError();
  }
  const std::lock_guard lock(mutex_);
  followed_.remove(call);
}

absl::Status Documents::Adopt(const std::string& document_id, const v1::Job& job, const std::string& label) {
  // Somebody may change the document at the same moment.
  constexpr int kMostTries = 20;
  absl::Status adopted = absl::AbortedError("");
  for (int i = 0; i < kMostTries && absl::IsAborted(adopted); ++i) adopted = AdoptOnce(document_id, job, label);
  return adopted;
}

absl::Status Documents::AdoptOnce(const std::string& document_id, const v1::Job& job, const std::string& label) {
  ASSIGN_OR_RETURN(Record record, store_->Get(document_id));
  v1::Document& document = *record.mutable_document();
  if (document.job_id() != job.id() || !IsRunning(document.job_state())) return absl::OkStatus();
  document.set_job_state(job.state());
  document.set_job_error(job.error());
  if (job.state() != v1::JOB_STATE_SUCCEEDED) return Commit(record, {});
  CallContext call;
  ASSIGN_OR_RETURN(v1::Artifact artifact, LayoutOfJob(job, call));
  LayoutState state;
  state.set_label(label);
  state.set_settled_layout_id("shown");
  if (label == kFurnish) {
    *state.mutable_brief() = job.spec().brief();
    state.mutable_brief()->clear_room();
  }
  // Who takes this back has the variants again that were found before.
  state.set_has_variants(true);
  state.set_other_variants_layout_id(record.variants_layout_id());
  state.set_other_variant_count(document.variant_count());
  SetVariants(record, artifact);
  return PushState(record, std::move(artifact), std::move(state));
}

}  // namespace flair::session
