// SPDX-License-Identifier: GPL-3.0-or-later
// What documents begin with: a brief, a job, a file, an empty room, another document; and how they come back.
#include <algorithm>
#include <random>
#include <utility>

#include "cli/output/report_text.h"
#include "fmt/format.h"
#include "room/validation/validate.h"
#include "session/documents/documents.h"
#include "session/documents/record.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using runtime::CallContext;
using store::v1::LayoutState;

std::string NewDocumentId() {
  std::random_device random;
  return fmt::format("{:x}-{:08x}", absl::ToUnixMicros(absl::Now()), random());
}

}  // namespace

void Documents::SetVariants(Record& record, v1::Artifact& artifact) {
  const auto count = std::ranges::count_if(artifact.solved_layout().runner_ups(), cli::IsComplete);
  record.mutable_document()->set_variant_count(static_cast<int>(count));
  record.set_variants_layout_id(count > 0 ? orchestrator::ComputeArtifactId(artifact) : "");
}

absl::StatusOr<v1::Document> Documents::CopyOf(const std::string& id, Record copy) {
  ASSIGN_OR_RETURN(const Record original, store_->Get(id));
  RETURN_IF_ERROR(Shown(original).status());
  v1::Document document = DocumentOf(original);
  document.set_title(TitleOf("Copy of " + document.title()));
  document.set_id(copy.document().id());
  document.set_revision(1);
  *document.mutable_create_time() = *document.mutable_update_time() = copy.document().create_time();
  // A job that has not ended furnishes the original alone.
  if (IsRunning(document.job_state())) {
    document.clear_job_id();
    document.clear_job_state();
  }
  *copy.mutable_document() = std::move(document);
  *copy.mutable_states() = original.states();
  copy.set_position(original.position());
  copy.set_variants_layout_id(original.variants_layout_id());
  RETURN_IF_ERROR(store_->SaveCopy(copy, id));
  Tell(copy);
  return DocumentOf(copy);
}

absl::StatusOr<v1::RestoreDocumentResponse> Documents::Restore(const v1::RestoreDocumentRequest& request) {
  ASSIGN_OR_RETURN(const Record record, store_->Restore(request.document_id()));
  if (IsRunning(record.document().job_state())) GoOn(record);
  Tell(record);
  v1::RestoreDocumentResponse response;
  *response.mutable_document() = DocumentOf(record);
  return response;
}

absl::StatusOr<v1::CreateDocumentResponse> Documents::Create(const v1::CreateDocumentRequest& request,
                                                             CallContext& call) {
  if (request.request_id().empty() || request.request_id().size() > 128) {
    return InvalidArgument("request_id: {} characters; must have 1 to 128", request.request_id().size());
  }
  const std::string digest = runtime::Sha256Hex(runtime::CanonicalBytes(request));
  ASSIGN_OR_RETURN(const std::optional<Record> known, store_->FindByRequest(request.request_id()));
  v1::CreateDocumentResponse response;
  if (known.has_value()) {
    if (known->request_digest() != digest) {
      return absl::AlreadyExistsError("request_id: another document was made with it");
    }
    *response.mutable_document() = DocumentOf(*known);
    return response;
  }
  Record record;
  record.set_request_id(request.request_id());
  record.set_request_digest(digest);
  v1::Document& document = *record.mutable_document();
  document.set_id(NewDocumentId());
  *document.mutable_create_time() = NowProto();
  v1::Artifact artifact;
  switch (request.source_case()) {
    case v1::CreateDocumentRequest::kDesign:
      *document.mutable_brief() = request.design().brief();
      document.set_title(TitleOf(request.design().brief().text()));
      RETURN_IF_ERROR(StartJob(record, request.design(), request.request_id(), call));
      RETURN_IF_ERROR(Commit(record, {}));
      Follow(document.id(), document.job_id(), kDesign);
      *response.mutable_document() = DocumentOf(record);
      return response;
    case v1::CreateDocumentRequest::kJobId: {
      ASSIGN_OR_RETURN(const v1::Job job, stages_.GetJob(request.job_id(), call));
      ASSIGN_OR_RETURN(artifact, LayoutOfJob(job, call));
      *document.mutable_brief() = job.spec().brief();
      document.set_title(TitleOf(job.spec().brief().text()));
      break;
    }
    case v1::CreateDocumentRequest::kFile: {
      ASSIGN_OR_RETURN(artifact, parts_.read_file(request.file()));
      break;
    }
    case v1::CreateDocumentRequest::kRoom:
      *artifact.mutable_room() = request.room();
      break;
    case v1::CreateDocumentRequest::kDocumentId: {
      ASSIGN_OR_RETURN(*response.mutable_document(), CopyOf(request.document_id(), std::move(record)));
      return response;
    }
    default:
      return absl::InvalidArgumentError("source: is not set; say what the document begins with");
  }
  LayoutState state;
  state.set_label("open");
  if (artifact.has_room()) {
    RETURN_IF_ERROR(Validate(artifact.room()));
    v1::SolvedLayout layout;
    *layout.mutable_graph()->mutable_room() = artifact.room();
    v1::Zone& zone = *layout.mutable_graph()->mutable_zone_plan()->add_zones();
    zone.set_id("room");
    zone.set_name("room");
    ASSIGN_OR_RETURN(layout, acts_.Evaluated(std::move(layout), call));
    artifact = ArtifactOf(std::move(layout), ByHand("opened by hand"), artifact.id());
  } else if (artifact.has_solved_layout()) {
    state.set_settled_layout_id("shown");
  } else {
    return absl::InvalidArgumentError("file: holds no layout and no room");
  }
  if (document.title().empty()) document.set_title(TitleOf(artifact.solved_layout().graph().room().title()));
  if (document.title().empty()) document.set_title(kOwnRoom);
  SetVariants(record, artifact);
  RETURN_IF_ERROR(PushState(record, std::move(artifact), std::move(state)));
  *response.mutable_document() = DocumentOf(record);
  return response;
}

}  // namespace flair::session
