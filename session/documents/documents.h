// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "absl/status/statusor.h"
#include "cli/output/output_folder.h"
#include "flair/store/v1/document_record.pb.h"
#include "flair/v1/studio_service.pb.h"
#include "session/acts/layout_acts.h"
#include "session/documents/events.h"
#include "session/documents/store.h"
#include "session/stages.h"
#include "worker_runtime/bootstrap/call_context.h"

namespace flair::session {

// What a program gives to its documents beside the stages.
struct DocumentParts {
  // An artifact or a room from the bytes of a user's file; INVALID_ARGUMENT says what is wrong with it.
  std::function<absl::StatusOr<v1::Artifact>(const std::string& bytes)> read_file;
  // The note of a layout as `flair explain --json` writes it, and as text for people.
  std::function<absl::StatusOr<std::string>(const v1::SolvedLayout&, const v1::ConstraintCatalog&)> note_json,
      note_text;
  // What of the brief was done otherwise or not at all.
  std::function<std::vector<std::string>(const v1::SolvedLayout&)> not_as_asked;
  // What a designer says of objects in a room, for those that are added; null: nothing.
  SentencesOf sentences_of;
  // Furniture that can be added.
  std::vector<v1::FurnitureOffer> furniture;
  // Other words for it, lower case and singular, with the indexes of the offers that each means, likeliest first.
  std::map<std::string, std::vector<int>> furniture_words;
  // The model that designs at first, without its key; and how another one comes to: the channels of an orchestrator and
  // a translator that ask it. Null where the services of another program design.
  v1::ModelChoice model;
  std::function<absl::StatusOr<Channels>(const v1::ModelChoice&)> choose_model;
};

// Every act on documents, for the studio, for agents and for commands: the methods of StudioService, free of gRPC.
// Errors as studio_service.proto says. Nothing is changed on an error. Thread-safe.
class Documents {
 public:
  // In `folder`; goes on following the jobs of documents that it holds. Errors as DocumentStore::Open.
  static absl::StatusOr<std::unique_ptr<Documents>> Open(const std::string& folder, const Channels& channels,
                                                         DocumentParts parts);
  // Stops following jobs, which go on or are interrupted as their orchestrator is.
  ~Documents();

  absl::StatusOr<v1::ListDocumentsResponse> List(const v1::ListDocumentsRequest& request);
  absl::StatusOr<v1::CreateDocumentResponse> Create(const v1::CreateDocumentRequest& request,
                                                    runtime::CallContext& call);
  absl::StatusOr<v1::GetDocumentResponse> Get(const v1::GetDocumentRequest& request);
  absl::StatusOr<v1::DeleteDocumentResponse> Delete(const v1::DeleteDocumentRequest& request);
  absl::StatusOr<v1::RestoreDocumentResponse> Restore(const v1::RestoreDocumentRequest& request);
  absl::StatusOr<v1::ActResponse> Act(const v1::ActRequest& request, runtime::CallContext& call);
  absl::StatusOr<v1::FindVariantsResponse> FindVariants(const v1::FindVariantsRequest& request,
                                                        runtime::CallContext& call);
  absl::StatusOr<v1::JudgeResponse> Judge(const v1::JudgeRequest& request, runtime::CallContext& call);
  absl::StatusOr<v1::ExplainResponse> Explain(const v1::ExplainRequest& request, runtime::CallContext& call);
  absl::StatusOr<v1::DrawDocumentResponse> Draw(const v1::DrawDocumentRequest& request, runtime::CallContext& call);
  absl::StatusOr<v1::ExportDocumentResponse> Export(const v1::ExportDocumentRequest& request,
                                                    runtime::CallContext& call);
  absl::StatusOr<v1::ShareDocumentResponse> Share(const v1::ShareDocumentRequest& request, runtime::CallContext& call);
  absl::StatusOr<v1::ListFurnitureResponse> ListFurniture(const v1::ListFurnitureRequest& request,
                                                          runtime::CallContext& call);
  v1::GetModelResponse GetModel();
  absl::StatusOr<v1::ChooseModelResponse> ChooseModel(const v1::ChooseModelRequest& request);
  DocumentEvents& events() { return events_; }

  // Beyond StudioService.

  // Waits until the document's job has ended and what came of it is the document's, and tells every step, also those
  // before the call. FAILED_PRECONDITION when it has no job; CANCELLED when the caller gives up: the job goes on.
  absl::StatusOr<v1::Document> AwaitJob(const std::string& document_id,
                                        const std::function<void(const v1::JobEvent&)>& see,
                                        runtime::CallContext& call);
  // Ends the document's job, if it has not ended by itself.
  absl::Status CancelJob(const std::string& document_id, runtime::CallContext& call);
  // Solves what is shown again for up to `count`, [1, 16], layouts that differ from it visibly, which TakeVariant then
  // takes; another seed finds others. What is shown stays. Returns what is shown with them as runner-ups.
  absl::StatusOr<v1::GetDocumentResponse> FindAlternatives(const std::string& document_id, int64_t revision, int count,
                                                           int64_t seed, runtime::CallContext& call);
  // An artifact of a document or of a job. NOT_FOUND when nobody has it.
  absl::StatusOr<v1::Artifact> GetArtifact(const std::string& artifact_id, runtime::CallContext& call);

 private:
  // What jobs do, in the history.
  static constexpr char kDesign[] = "design the room", kFurnish[] = "furnish the room";
  using Record = store::v1::DocumentRecord;
  using Layout = std::shared_ptr<const v1::Artifact>;

  static bool IsRunning(v1::JobState state) { return state == v1::JOB_STATE_QUEUED || state == v1::JOB_STATE_RUNNING; }

  Documents(std::unique_ptr<DocumentStore> store, const Channels& channels, DocumentParts parts);

  // A layout of a document; the latest are kept in memory.
  absl::StatusOr<Layout> LayoutOf(const Record& record, const std::string& id);
  // What is shown; FAILED_PRECONDITION when there is none yet.
  absl::StatusOr<Layout> Shown(const Record& record);
  absl::StatusOr<Record> GetAt(const std::string& id, int64_t revision);
  // The next revision: stores it, tells it, and fills in what follows from the states.
  absl::Status Commit(Record& record, std::span<const orchestrator::SealedArtifact> added);
  // The document's variants are the complete runner-ups of this layout.
  static void SetVariants(Record& record, v1::Artifact& artifact);
  // Shows another layout from now on.
  absl::Status PushState(Record& record, v1::Artifact artifact, store::v1::LayoutState state);
  absl::StatusOr<v1::ActResponse> ActOnHistory(Record record, int step);
  // A sentence may ask for an undo or another layout, too.
  absl::StatusOr<v1::ActResponse> Say(Record record, const v1::ActRequest& request, runtime::CallContext& call);
  absl::StatusOr<v1::ActResponse> ActOnLayout(Record record, const v1::ActRequest& request, runtime::CallContext& call);
  // After an act that has changed nothing: no state is added, and the answer says so.
  absl::StatusOr<v1::ActResponse> Unchanged(Record record, const Layout& before, Acted acted);
  absl::StatusOr<v1::ActResponse> TakeVariant(Record record, int index, runtime::CallContext& call);
  absl::StatusOr<v1::ActResponse> Furnish(Record record, const v1::ActRequest& request, runtime::CallContext& call);
  // What is shown now, its graph only where that differs from the one of `before`.
  absl::StatusOr<v1::ActResponse> Answer(const Record& record, const Layout& before, const Acted& acted = {});
  // Tells those who watch.
  void Tell(const Record& record);
  // A new document that is as another one.
  absl::StatusOr<v1::Document> CopyOf(const std::string& id, Record copy);
  // What a format other than an archive holds.
  absl::StatusOr<std::string> ContentOf(const Record& record, const Layout& layout, v1::DocumentFormat format,
                                        const v1::RenderOptions& options, runtime::CallContext& call);
  // The layout and what led to it, as far as it is still stored; not more than so many bytes.
  absl::StatusOr<std::vector<cli::OutputFile>> ArtifactFilesOf(const Layout& shown, size_t most,
                                                               runtime::CallContext& call);
  // Files of every format, and the artifacts.
  absl::StatusOr<std::vector<cli::OutputFile>> EveryFileOf(const Record& record, const Layout& layout,
                                                           v1::PaperSize paper, runtime::CallContext& call);

  // Starts a job for the document and follows it.
  absl::Status StartJob(Record& record, const v1::JobSpec& spec, const std::string& request_id,
                        runtime::CallContext& call);
  // After a restart: asks for the job again, which an orchestrator of one process runs only then, and follows it.
  void GoOn(const Record& record);
  void Follow(const std::string& document_id, const std::string& job_id, const std::string& label);
  void FollowToEnd(const std::string& document_id, const std::string& job_id, const std::string& label);
  // Makes what came of a job that has ended the document's, unless somebody has done it before.
  absl::Status Adopt(const std::string& document_id, const v1::Job& job, const std::string& label);
  absl::Status AdoptOnce(const std::string& document_id, const v1::Job& job, const std::string& label);
  absl::StatusOr<v1::Artifact> LayoutOfJob(const v1::Job& job, runtime::CallContext& call);

  const std::unique_ptr<DocumentStore> store_;
  Stages stages_;
  const DocumentParts parts_;
  const LayoutActs acts_;
  DocumentEvents events_;

  std::mutex mutex_;  // of all below
  v1::ModelChoice model_;
  std::list<std::pair<std::string, Layout>> layouts_;  // latest use first
  std::vector<std::thread> followers_;
  bool closing_ = false;
  std::list<std::shared_ptr<runtime::CallContext>> followed_;
};

}  // namespace flair::session
