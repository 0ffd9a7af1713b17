// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/documents/documents.h"

#include <algorithm>

#include "absl/strings/ascii.h"
#include "absl/strings/match.h"
#include "cli/output/report_text.h"
#include "fmt/format.h"
#include "session/documents/record.h"
#include "session/sentences/names.h"
#include "session/sentences/spoken.h"
#include "worker_runtime/files/files.h"
#include "worker_runtime/status/status_macros.h"

namespace flair::session {
namespace {

using orchestrator::SealedArtifact;
using runtime::CallContext;
using store::v1::LayoutState;

constexpr int kMostStates = 500;
constexpr size_t kLayoutsInMemory = 16;

// `parts` outlive it.
Catalogue CatalogueOf(const DocumentParts& parts) {
  constexpr size_t kShown = 3;
  // By whole names, by words of other people for them, and by their last words, in this order.
  auto names = std::make_shared<std::map<std::string, int>>();
  for (size_t i = 0; i < parts.furniture.size(); ++i) {
    names->emplace(absl::AsciiStrToLower(parts.furniture[i].object().name()), static_cast<int>(i));
  }
  for (const auto& [word, offers] : parts.furniture_words) names->emplace(word, offers.front());
  for (size_t i = 0; i < parts.furniture.size(); ++i) {
    const std::string name = absl::AsciiStrToLower(parts.furniture[i].object().name());
    for (size_t at = name.find(' '); at != std::string::npos; at = name.find(' ', at + 1)) {
      names->emplace(name.substr(at + 1), static_cast<int>(i));
    }
  }
  Catalogue catalogue;
  catalogue.find = [&parts, names](const std::string& name) -> std::optional<v1::Object> {
    const auto found = names->find(name);
    return found == names->end() ? std::nullopt : std::optional(parts.furniture[found->second].object());
  };
  for (size_t i = 0; i < std::min(kShown, parts.furniture.size()); ++i) {
    catalogue.some += WithArticle(parts.furniture[i].object().name()) + ", ";
  }
  catalogue.some += fmt::format("{} pieces in all", parts.furniture.size());
  return catalogue;
}

}  // namespace

Documents::Documents(std::unique_ptr<DocumentStore> store, const Channels& channels, DocumentParts parts)
    : store_(std::move(store)),
      stages_(channels),
      parts_(std::move(parts)),
      acts_(stages_, parts_.sentences_of, CatalogueOf(parts_)),
      model_(parts_.model) {}

v1::GetModelResponse Documents::GetModel() {
  const std::lock_guard lock(mutex_);
  v1::GetModelResponse response;
  *response.mutable_model() = model_;
  response.mutable_model()->clear_api_key();
  response.set_has_key(!model_.api_key().empty());
  response.set_can_choose(parts_.choose_model != nullptr);
  return response;
}

absl::StatusOr<v1::ChooseModelResponse> Documents::ChooseModel(const v1::ChooseModelRequest& request) {
  if (parts_.choose_model == nullptr) {
    return absl::UnimplementedError("the orchestrator elsewhere designs, with its own model");
  }
  ASSIGN_OR_RETURN(const Channels channels, parts_.choose_model(request.model()));
  stages_.DesignBy(channels);
  const std::lock_guard lock(mutex_);
  model_ = request.model();
  return v1::ChooseModelResponse();
}

absl::StatusOr<std::unique_ptr<Documents>> Documents::Open(const std::string& folder, const Channels& channels,
                                                           DocumentParts parts) {
  ASSIGN_OR_RETURN(std::unique_ptr<DocumentStore> store, DocumentStore::Open(folder));
  std::unique_ptr<Documents> documents(new Documents(std::move(store), channels, std::move(parts)));
  ASSIGN_OR_RETURN(const std::vector<Record> records, documents->store_->List(1000));
  for (const Record& record : records) {
    const v1::Document& document = record.document();
    if (document.job_id().empty() || !IsRunning(document.job_state())) continue;
    documents->GoOn(record);
  }
  return documents;
}

Documents::~Documents() {
  std::vector<std::thread> followers;
  {
    const std::lock_guard lock(mutex_);
    closing_ = true;
    for (const auto& call : followed_) call->cancellation().Cancel();
    followers.swap(followers_);
  }
  for (std::thread& follower : followers) follower.join();
}

absl::StatusOr<v1::ListDocumentsResponse> Documents::List(const v1::ListDocumentsRequest& request) {
  if (request.page_size() < 0 || request.page_size() > 1000) {
    return InvalidArgument("page_size: {}; must be in [0, 1000]", request.page_size());
  }
  ASSIGN_OR_RETURN(const std::vector<Record> records,
                   store_->List(request.page_size() == 0 ? 50 : request.page_size()));
  v1::ListDocumentsResponse response;
  for (const Record& record : records) *response.add_documents() = DocumentOf(record);
  return response;
}

absl::StatusOr<Documents::Layout> Documents::LayoutOf(const Record& record, const std::string& id) {
  {
    const std::lock_guard lock(mutex_);
    const auto kept = std::ranges::find(layouts_, id, &std::pair<std::string, Layout>::first);
    if (kept != layouts_.end()) {
      layouts_.splice(layouts_.begin(), layouts_, kept);
      return layouts_.front().second;
    }
  }
  ASSIGN_OR_RETURN(v1::Artifact artifact, store_->GetLayout(record.document().id(), id));
  const auto layout = std::make_shared<const v1::Artifact>(std::move(artifact));
  const std::lock_guard lock(mutex_);
  layouts_.emplace_front(id, layout);
  if (layouts_.size() > kLayoutsInMemory) layouts_.pop_back();
  return layout;
}

absl::StatusOr<Documents::Layout> Documents::Shown(const Record& record) {
  if (record.states().empty()) {
    return absl::FailedPreconditionError("the document has no layout yet: its job has not ended");
  }
  return LayoutOf(record, record.states(record.position()).layout_id());
}

absl::StatusOr<Documents::Record> Documents::GetAt(const std::string& id, int64_t revision) {
  ASSIGN_OR_RETURN(Record record, store_->Get(id));
  if (record.document().revision() != revision) {
    return absl::AbortedError(fmt::format("revision: the document is at {}, not at {}: somebody else has changed it",
                                          record.document().revision(), revision));
  }
  return record;
}

absl::Status Documents::Commit(Record& record, std::span<const SealedArtifact> added) {
  v1::Document& document = *record.mutable_document();
  document.set_revision(document.revision() + 1);
  *document.mutable_update_time() = NowProto();
  RETURN_IF_ERROR(store_->Save(record, added));
  Tell(record);
  return absl::OkStatus();
}

void Documents::Tell(const Record& record) {
  v1::WatchDocumentsResponse event;
  *event.mutable_document() = DocumentOf(record);
  events_.Tell(event);
}

absl::Status Documents::PushState(Record& record, v1::Artifact artifact, LayoutState state) {
  const SealedArtifact sealed = orchestrator::SealArtifact(artifact);
  state.set_layout_id(sealed.ref.id());
  if (state.settled_layout_id() == "shown") state.set_settled_layout_id(sealed.ref.id());
  auto& states = *record.mutable_states();
  if (!states.empty()) states.DeleteSubrange(record.position() + 1, states.size() - record.position() - 1);
  *states.Add() = std::move(state);
  if (states.size() > kMostStates) states.DeleteSubrange(0, states.size() - kMostStates);
  record.set_position(states.size() - 1);
  return Commit(record, {&sealed, 1});
}

absl::StatusOr<v1::ActResponse> Documents::Answer(const Record& record, const Layout& before, const Acted& acted) {
  v1::ActResponse response;
  response.mutable_moved_object_ids()->Assign(acted.moved_ids.begin(), acted.moved_ids.end());
  response.mutable_diagnostics()->Assign(acted.diagnostics.begin(), acted.diagnostics.end());
  response.set_answer(acted.answer);
  response.set_left_over(acted.left_over);
  *response.mutable_document() = DocumentOf(record);
  if (record.states().empty()) return response;
  ASSIGN_OR_RETURN(const Layout layout, Shown(record));
  *response.mutable_layout() = layout->solved_layout();
  response.mutable_layout()->clear_runner_ups();
  const bool same_graph = before != nullptr && runtime::CanonicalBytes(before->solved_layout().graph()) ==
                                                   runtime::CanonicalBytes(layout->solved_layout().graph());
  if (same_graph) response.mutable_layout()->clear_graph();
  return response;
}

absl::StatusOr<v1::GetDocumentResponse> Documents::Get(const v1::GetDocumentRequest& request) {
  ASSIGN_OR_RETURN(const Record record, store_->Get(request.document_id()));
  v1::GetDocumentResponse response;
  if (!request.layout_id().empty()) {
    ASSIGN_OR_RETURN(const Layout layout, LayoutOf(record, request.layout_id()));
    *response.mutable_document() = DocumentOf(record);
    *response.mutable_layout() = layout->solved_layout();
    return response;
  }
  ASSIGN_OR_RETURN(v1::ActResponse answer, Answer(record, nullptr));
  response.mutable_document()->Swap(answer.mutable_document());
  if (answer.has_layout()) response.mutable_layout()->Swap(answer.mutable_layout());
  return response;
}

absl::StatusOr<v1::DeleteDocumentResponse> Documents::Delete(const v1::DeleteDocumentRequest& request) {
  RETURN_IF_ERROR(store_->Delete(request.document_id()));
  v1::WatchDocumentsResponse event;
  event.set_deleted_document_id(request.document_id());
  events_.Tell(event);
  return v1::DeleteDocumentResponse();
}

absl::StatusOr<v1::ActResponse> Documents::Act(const v1::ActRequest& request, CallContext& call) {
  ASSIGN_OR_RETURN(Record record, GetAt(request.document_id(), request.revision()));
  switch (request.act_case()) {
    case v1::ActRequest::kUndo:
      return ActOnHistory(std::move(record), -1);
    case v1::ActRequest::kRedo:
      return ActOnHistory(std::move(record), 1);
    case v1::ActRequest::kTakeVariant:
      return TakeVariant(std::move(record), request.take_variant().index(), call);
    case v1::ActRequest::kFurnish:
      return Furnish(std::move(record), request, call);
    case v1::ActRequest::kTitle: {
      const std::string title(absl::StripAsciiWhitespace(request.title()));
      if (title.empty() || title.size() > kMostTitleLetters) {
        return InvalidArgument("title: {} characters; must have 1 to {}", title.size(), kMostTitleLetters);
      }
      record.mutable_document()->set_title(title);
      RETURN_IF_ERROR(Commit(record, {}));
      v1::ActResponse response;
      *response.mutable_document() = DocumentOf(record);
      return response;
    }
    case v1::ActRequest::kSay:
      return Say(std::move(record), request, call);
    default:
      return ActOnLayout(std::move(record), request, call);
  }
}

absl::StatusOr<v1::ActResponse> Documents::Say(Record record, const v1::ActRequest& request, CallContext& call) {
  const std::string asked = HistoryAsked(request.say().text());
  if (asked.empty()) return ActOnLayout(std::move(record), request, call);
  if (asked == "another layout") {
    // Another one at every time, and the same again after an undo of all of it.
    const int64_t seed = record.position() + 1;
    ASSIGN_OR_RETURN(const v1::GetDocumentResponse found,
                     FindAlternatives(request.document_id(), request.revision(), 1, seed, call));
    if (found.layout().runner_ups().empty()) return absl::FailedPreconditionError("no other layout was found");
    ASSIGN_OR_RETURN(record, GetAt(request.document_id(), found.document().revision()));
    ASSIGN_OR_RETURN(v1::ActResponse response, TakeVariant(std::move(record), 0, call));
    response.set_answer(fmt::format("Here is another layout: {} pieces stand elsewhere. Undo brings the last one back.",
                                    response.moved_object_ids_size()));
    return response;
  }
  const bool undo = asked == "undo";
  const v1::Document before = DocumentOf(record);
  ASSIGN_OR_RETURN(v1::ActResponse response, ActOnHistory(std::move(record), undo ? -1 : 1));
  response.set_answer(
      fmt::format("{}: {}.", undo ? "Taken back" : "Done again", undo ? before.undo_label() : before.redo_label()));
  return response;
}

absl::StatusOr<v1::ActResponse> Documents::ActOnHistory(Record record, int step) {
  const int to = record.position() + step;
  if (to < 0 || to >= record.states_size()) {
    return FailedPrecondition("there is nothing to {}", step < 0 ? "undo" : "do again");
  }
  ASSIGN_OR_RETURN(const Layout before, Shown(record));
  if (LayoutState& crossed = *record.mutable_states(std::max(to, record.position())); crossed.has_variants()) {
    record.mutable_variants_layout_id()->swap(*crossed.mutable_other_variants_layout_id());
    const int count = record.document().variant_count();
    record.mutable_document()->set_variant_count(crossed.other_variant_count());
    crossed.set_other_variant_count(count);
  }
  record.set_position(to);
  RETURN_IF_ERROR(Commit(record, {}));
  return Answer(record, before);
}

absl::StatusOr<v1::ActResponse> Documents::Unchanged(Record record, const Layout& before, Acted acted) {
  LayoutState& now = *record.mutable_states(record.position());
  if (acted.settled && !now.pending_edits().empty()) {
    // That it is settled now is all that is new.
    now.set_settled_layout_id(now.layout_id());
    now.clear_pending_edits();
    RETURN_IF_ERROR(Commit(record, {}));
  }
  if (acted.diagnostics.empty()) {
    acted.diagnostics.push_back(
        Remark(v1::SEVERITY_NOTE, "nothing_changed", "", "Nothing was changed: all of it is so already."));
  }
  return Answer(record, before, acted);
}

absl::StatusOr<v1::ActResponse> Documents::ActOnLayout(Record record, const v1::ActRequest& request,
                                                       CallContext& call) {
  ASSIGN_OR_RETURN(const Layout before, Shown(record));
  const LayoutState& now = record.states(record.position());
  Layout settled;
  if (!now.settled_layout_id().empty()) {
    ASSIGN_OR_RETURN(settled, LayoutOf(record, now.settled_layout_id()));
  }
  const ObjectIds by_hand(now.placed_by_hand_ids().begin(), now.placed_by_hand_ids().end());
  const Standing standing{before->solved_layout(), settled == nullptr ? nullptr : &settled->solved_layout(),
                          now.pending_edits(), by_hand};
  ASSIGN_OR_RETURN(Acted acted, acts_.Act(standing, request, call));
  if (ChangesNothing(before->solved_layout(), acted)) return Unchanged(std::move(record), before, std::move(acted));
  LayoutState state;
  state.set_label(acted.label);
  if (acted.settled) {
    state.set_settled_layout_id("shown");
  } else if (!acted.anew) {
    state.set_settled_layout_id(now.settled_layout_id());
  }
  *state.mutable_pending_edits() = acted.pending;
  for (const std::string& id : acted.by_hand) state.add_placed_by_hand_ids(id);
  RETURN_IF_ERROR(
      PushState(record, ArtifactOf(std::move(acted.layout), acted.producer, now.layout_id()), std::move(state)));
  return Answer(record, before, acted);
}

absl::StatusOr<v1::GetDocumentResponse> Documents::FindAlternatives(const std::string& document_id, int64_t revision,
                                                                    int count, int64_t seed, CallContext& call) {
  ASSIGN_OR_RETURN(Record record, GetAt(document_id, revision));
  ASSIGN_OR_RETURN(const Layout shown, Shown(record));
  ASSIGN_OR_RETURN(v1::SolvedLayout all, acts_.WithAlternatives(shown->solved_layout(), count, seed, call));
  v1::GetDocumentResponse response;
  *response.mutable_layout() = all;
  record.mutable_document()->set_variant_count(all.runner_ups_size());
  std::vector<SealedArtifact> added;
  record.clear_variants_layout_id();
  if (!all.runner_ups().empty()) {
    v1::Artifact artifact = ArtifactOf(std::move(all), shown->producer(), shown->id());
    added.push_back(orchestrator::SealArtifact(artifact));
    record.set_variants_layout_id(added.front().ref.id());
  }
  RETURN_IF_ERROR(Commit(record, added));
  *response.mutable_document() = DocumentOf(record);
  return response;
}

absl::StatusOr<v1::ActResponse> Documents::TakeVariant(Record record, int index, CallContext& call) {
  if (index < -1 || index >= record.document().variant_count() || record.variants_layout_id().empty()) {
    return InvalidArgument("take_variant.index: {}; there are {}", index, record.document().variant_count());
  }
  ASSIGN_OR_RETURN(const Layout before, Shown(record));
  ASSIGN_OR_RETURN(const Layout all, LayoutOf(record, record.variants_layout_id()));
  int at = -1;
  for (int i = 0, seen = 0; i < all->solved_layout().runner_ups_size() && at < 0; ++i) {
    if (cli::IsComplete(all->solved_layout().runner_ups(i)) && seen++ == index) at = i;
  }
  v1::SolvedLayout variant = at < 0 ? all->solved_layout() : cli::VariantOf(all->solved_layout(), at);
  variant.clear_runner_ups();
  ASSIGN_OR_RETURN(Acted taken, acts_.Taken(before->solved_layout(), std::move(variant), call));
  LayoutState state;
  state.set_label(fmt::format("take variant {}", index + 2));
  state.set_settled_layout_id("shown");
  const v1::Producer& producer = taken.producer.program().empty() ? all->producer() : taken.producer;
  RETURN_IF_ERROR(PushState(record, ArtifactOf(std::move(taken.layout), producer, all->id()), std::move(state)));
  return Answer(record, before, taken);
}

absl::StatusOr<v1::FindVariantsResponse> Documents::FindVariants(const v1::FindVariantsRequest& request,
                                                                 CallContext& call) {
  ASSIGN_OR_RETURN(v1::GetDocumentResponse found,
                   FindAlternatives(request.document_id(), request.revision(), request.count(), request.seed(), call));
  v1::FindVariantsResponse response;
  response.mutable_document()->Swap(found.mutable_document());
  return response;
}

}  // namespace flair::session
